# SPDX-License-Identifier: BSD-3-Clause
"""One Exodus file. Reads only what is asked for."""
import os

import netCDF4
import numpy as np

from .errors import InputError

NO_INDICES = np.zeros(0, int)


class ExodusFile:
    """A mesh, or results of all ranks or of one. Steps count from 0, -1 is the last one; nodes and elements from 0.

    Raises InputError for what is no Exodus file or lacks a name that is asked for.
    """

    def __init__(self, path):
        self.path = str(path)
        try:
            self._data = netCDF4.Dataset(self.path)
        except (OSError, RuntimeError) as error:
            reason = getattr(error, "strerror", None) or error
            raise InputError(f"{path}: cannot be read as an Exodus file: {reason}") from None
        self._data.set_auto_mask(False)
        if "num_dim" not in self._data.dimensions or "time_step" not in self._data.dimensions:
            raise InputError(f"{path}: is a NetCDF file, but not of Exodus")
        self._steps = self._whole_steps()

    @property
    def title(self):
        return getattr(self._data, "title", "")

    @property
    def times(self):
        """Load parameter t of each written step."""
        return self._array("time_whole")[:self._steps]

    @property
    def coordinates(self):
        """(nodes, 3), of the reference configuration."""
        return np.stack([self._array("coord" + axis) for axis in "xyz"], axis=1)

    @property
    def node_map(self):
        """Number of each node in the mesh file."""
        return self._array("node_num_map") if "node_num_map" in self._data.variables \
            else np.arange(self._size("num_nodes")) + 1

    @property
    def element_map(self):
        """Number of each element in the mesh file."""
        return self._array("elem_num_map") if "elem_num_map" in self._data.variables \
            else np.arange(self._size("num_elem")) + 1

    @property
    def num_ranks(self):
        """How many files the results are spread over."""
        return self._size("num_processors") or 1

    def names(self, kind):
        """kind: nod_var, elem_var, glo_var (variables), eb, ns, ss (blocks and sets)."""
        key = f"name_{kind}" if kind.endswith("var") else f"{kind}_names"
        return [bytes(row).split(b"\0")[0].decode(errors="replace").strip() for row in self._array(key)] \
            if key in self._data.variables else []

    def nodal(self, name, step=-1):
        """(nodes,) values of a nodal variable."""
        return self._data[f"vals_nod_var{self._number('nod_var', name)}"][self._step(step)]

    def vector(self, name, step=-1):
        """(nodes, 3) from name_x, name_y, name_z."""
        return np.stack([self.nodal(f"{name}_{axis}", step) for axis in "xyz"], axis=1)

    def element(self, name, block, step=-1):
        """(elements of the block,) values of an element variable; the block is given by name."""
        variable = f"vals_elem_var{self._number('elem_var', name)}eb{self._number('eb', block)}"
        return self._data[variable][self._step(step)] if variable in self._data.variables else np.zeros(0)

    def globals(self, step=-1):
        """All global variables by name."""
        names = self.names("glo_var")
        return dict(zip(names, self._data["vals_glo_var"][self._step(step)])) if names else {}

    def global_columns(self):
        """All global variables over the steps: {name: (steps,)}."""
        names = self.names("glo_var")
        return dict(zip(names, self._data["vals_glo_var"][:self._steps].T)) if names else {}

    def kind(self, block):
        """Type of the elements of a block as Exodus writes it: HEX8, TETRA10, ..."""
        variable = self._data.variables.get(f"connect{self._number('eb', block)}")
        return getattr(variable, "elem_type", "").upper()

    def connectivity(self, block):
        """(elements, nodes of each), indices into coordinates."""
        name = f"connect{self._number('eb', block)}"
        return self._array(name) - 1 if name in self._data.variables else np.zeros((0, 0), int)

    def node_set(self, name):
        """Indices into coordinates. One that has the name of a side set is called NAME_nodes in results."""
        sets = self.names("ns")
        name = name + "_nodes" if name not in sets and name + "_nodes" in sets else name
        return self._members("node_ns", "ns", name) - 1

    def side_set(self, name):
        """Elements, from 0 through all blocks, and their sides, from 1 as Exodus numbers them."""
        return self._members("elem_ss", "ss", name) - 1, self._members("side_ss", "ss", name)

    def _whole_steps(self):
        """Steps that the file holds in full: of what is missing at its end, NetCDF would make zeros."""
        steps = self._size("time_step")
        if not self._data.data_model.startswith("NETCDF3"):
            return steps
        fixed = each = 0
        for variable in self._data.variables.values():
            of_step = variable.dimensions[:1] == ("time_step",)
            size = variable.dtype.itemsize * int(np.prod(variable.shape[of_step:]))
            fixed, each = (fixed, each + size) if of_step else (fixed + size, each)
        there = os.path.getsize(self.path)
        if there < fixed + max(steps - 1, 0) * each:
            raise InputError(f"{self.path}: is damaged: at least {fixed + steps * each} bytes expected, {there} are there")
        return steps if there >= fixed + steps * each else steps - 1

    def _step(self, step):
        """From 0; raises InputError for a step that is not there."""
        if not -self._steps <= step < self._steps:
            raise InputError(f"{self.path}: holds {self._steps} steps, not number {step}")
        return step % self._steps

    def _array(self, variable):
        return self._data[variable][:]

    def _size(self, dimension):
        return self._data.dimensions[dimension].size if dimension in self._data.dimensions else 0

    def _members(self, variable, kind, name):
        """Of a set; a file leaves out those that are empty."""
        variable += str(self._number(kind, name))
        return self._array(variable) if variable in self._data.variables else NO_INDICES.copy()

    def _number(self, kind, name):
        """From 1, as Exodus counts."""
        names = self.names(kind)
        if name not in names:
            raise InputError(f"{self.path}: has no '{name}'; there are: {', '.join(names) or 'none'}")
        return names.index(name) + 1
