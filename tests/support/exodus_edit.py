# SPDX-License-Identifier: BSD-3-Clause
"""Reads, changes and writes Exodus meshes for tests, without abut: only netCDF4 and numpy.

All indices are zero based, sides too; number maps hold the ids that a user sees.
"""
from dataclasses import dataclass, field

import netCDF4
import numpy as np


@dataclass
class Block:
    name: str
    id: int
    kind: str
    nodes: np.ndarray  # (elements, nodes per element)


@dataclass
class ExodusMesh:
    x: np.ndarray  # (nodes, 3)
    blocks: list
    node_sets: dict = field(default_factory=dict)  # name -> nodes
    side_sets: dict = field(default_factory=dict)  # name -> (elements, sides)
    node_map: np.ndarray = None
    element_map: np.ndarray = None

    @property
    def num_elements(self):
        return sum(len(block.nodes) for block in self.blocks)


def names(data, variable):
    """The list of names that an Exodus file keeps as rows of characters."""
    if variable not in data.variables:
        return []
    rows = data.variables[variable]
    rows.set_auto_mask(False)
    return [b"".join(row).split(b"\0")[0].decode().strip() for row in rows[:]]


def read(path):
    with netCDF4.Dataset(path) as data:
        data.set_auto_mask(False)
        x = np.stack([data["coord" + axis][:] for axis in "xyz"], axis=1)

        def indices(variable, shape=(0,)):
            """Zero-based; a file of one rank leaves out what it has nothing of."""
            found = variable in data.variables
            return data[variable][:].astype(np.int64) - 1 if found else np.zeros(shape, np.int64)

        blocks = []
        for i, name in enumerate(names(data, "eb_names"), 1):
            kind = getattr(data.variables.get(f"connect{i}"), "elem_type", "")
            blocks.append(Block(name, int(data["eb_prop1"][i - 1]), kind,
                                indices(f"connect{i}", (0, 0))))
        mesh = ExodusMesh(x, blocks)
        for i, name in enumerate(names(data, "ns_names"), 1):
            mesh.node_sets[name] = indices(f"node_ns{i}")
        for i, name in enumerate(names(data, "ss_names"), 1):
            mesh.side_sets[name] = (indices(f"elem_ss{i}"), indices(f"side_ss{i}"))
        for kind in ("node", "elem"):
            if f"{kind}_num_map" in data.variables:
                ids = data[f"{kind}_num_map"][:].astype(np.int64)
                setattr(mesh, "node_map" if kind == "node" else "element_map", ids)
        return mesh


def _put_names(data, variable, dimension, words):
    data.createVariable(variable, "S1", (dimension, "len_name"))
    length = len(data.dimensions["len_name"])
    data[variable][:] = np.array([list(word.ljust(length, "\0")) for word in words], dtype="S1")


def _put(data, variable, dimensions, values, kind="i4"):
    data.createVariable(variable, kind, dimensions)
    data[variable][:] = values


def _put_ids(data, prefix, dimension, words, ids, sizes=None):
    """sizes: of sets, those without members having neither dimension nor variable."""
    _put(data, prefix + "_status", (dimension,), np.ones(len(words)) if sizes is None else np.sign(sizes))
    _put(data, prefix + "_prop1", (dimension,), ids)
    data[prefix + "_prop1"].setncattr("name", "ID")
    _put_names(data, prefix + "_names", dimension, words)


def write(path, mesh):
    """Names beyond 32 characters are written as other programs do, without maximum_name_length."""
    longest = max(len(word) for word in [*mesh.node_sets, *mesh.side_sets, *(b.name for b in mesh.blocks)])
    length = max(longest, 32) + 1
    with netCDF4.Dataset(path, "w", format="NETCDF3_64BIT_OFFSET") as data:
        data.setncatts({"api_version": np.float32(8.03), "version": np.float32(8.03),
                        "floating_point_word_size": np.int32(8), "file_size": np.int32(1),
                        "int64_status": np.int32(0), "title": "test"})
        if length == 33:
            data.setncattr("maximum_name_length", np.int32(32))
        for name, size in (("len_string", 33), ("len_line", 81), ("len_name", length), ("four", 4),
                           ("time_step", None), ("num_dim", 3), ("num_nodes", len(mesh.x)),
                           ("num_elem", mesh.num_elements), ("num_el_blk", len(mesh.blocks))):
            data.createDimension(name, size)
        data.createVariable("time_whole", "f8", ("time_step",))
        for i, axis in enumerate("xyz"):
            _put(data, "coord" + axis, ("num_nodes",), mesh.x[:, i], "f8")
        _put_names(data, "coor_names", "num_dim", "xyz")
        _put_ids(data, "eb", "num_el_blk", [b.name for b in mesh.blocks],
                 [b.id for b in mesh.blocks])
        for i, block in enumerate(mesh.blocks, 1):
            if not len(block.nodes):  # of another rank
                continue
            data.createDimension(f"num_el_in_blk{i}", block.nodes.shape[0])
            data.createDimension(f"num_nod_per_el{i}", block.nodes.shape[1])
            _put(data, f"connect{i}", (f"num_el_in_blk{i}", f"num_nod_per_el{i}"), block.nodes + 1)
            data[f"connect{i}"].elem_type = block.kind
        if mesh.node_map is not None:
            _put(data, "node_num_map", ("num_nodes",), mesh.node_map)
        if mesh.element_map is not None:
            _put(data, "elem_num_map", ("num_elem",), mesh.element_map)
        if mesh.node_sets:
            data.createDimension("num_node_sets", len(mesh.node_sets))
            _put_ids(data, "ns", "num_node_sets", list(mesh.node_sets),
                     np.arange(len(mesh.node_sets)) + 1,
                     [len(nodes) for nodes in mesh.node_sets.values()])
        for i, nodes in enumerate(mesh.node_sets.values(), 1):
            if not len(nodes):
                continue
            data.createDimension(f"num_nod_ns{i}", len(nodes))
            _put(data, f"node_ns{i}", (f"num_nod_ns{i}",), nodes + 1)
        if mesh.side_sets:
            data.createDimension("num_side_sets", len(mesh.side_sets))
            _put_ids(data, "ss", "num_side_sets", list(mesh.side_sets),
                     np.arange(len(mesh.side_sets)) + 1,
                     [len(sides) for _, sides in mesh.side_sets.values()])
        for i, (elements, sides) in enumerate(mesh.side_sets.values(), 1):
            if not len(sides):
                continue
            data.createDimension(f"num_side_ss{i}", len(elements))
            _put(data, f"elem_ss{i}", (f"num_side_ss{i}",), elements + 1)
            _put(data, f"side_ss{i}", (f"num_side_ss{i}",), sides + 1)


def permute(mesh, random):
    """The same mesh numbered anew: nodes, elements within blocks, order within sets.

    Returns the mesh and `place`: node n of `mesh` is node place[n] of the result.
    """
    place = random.permutation(len(mesh.x))
    x = np.empty_like(mesh.x)
    x[place] = mesh.x
    element_place = np.empty(mesh.num_elements, dtype=np.int64)
    blocks, first = [], 0
    for block in mesh.blocks:
        order = random.permutation(len(block.nodes))
        element_place[first + order] = first + np.arange(len(order))
        blocks.append(Block(block.name, block.id, block.kind, place[block.nodes[order]]))
        first += len(order)
    result = ExodusMesh(x, blocks)
    for name, nodes in mesh.node_sets.items():
        result.node_sets[name] = place[random.permutation(nodes)]
    for name, (elements, sides) in mesh.side_sets.items():
        order = random.permutation(len(elements))
        result.side_sets[name] = (element_place[elements[order]], sides[order])
    return result, place


def reverse_sides(mesh):
    """The same mesh with the sides of each side set listed backwards."""
    sets = {name: (elements[::-1].copy(), sides[::-1].copy())
            for name, (elements, sides) in mesh.side_sets.items()}
    return ExodusMesh(mesh.x, mesh.blocks, mesh.node_sets, sets, mesh.node_map, mesh.element_map)


def rotation(random):
    """A random proper orthogonal matrix."""
    q, r = np.linalg.qr(random.standard_normal((3, 3)))
    q *= np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else q[:, ::-1]
