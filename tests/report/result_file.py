# SPDX-License-Identifier: BSD-3-Clause
"""Exodus results with given values, written without abut."""
import netCDF4
import numpy as np

import exodus_edit


def bricks():
    """Two hexahedra on top of each other: (mesh, the pressed faces' nodes of the lower and of the upper one)."""
    corners = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], float)
    x = np.array([(*c, z) for z in (0, 1, 1, 3) for c in corners])
    blocks = [exodus_edit.Block("lower", 1, "HEX8", np.arange(8)[None]),
              exodus_edit.Block("upper", 2, "HEX8", np.arange(8, 16)[None])]
    mesh = exodus_edit.ExodusMesh(x, blocks, {"foot": np.arange(4)}, {"lid": (np.array([1]), np.array([5]))})
    mesh.node_map = np.arange(16) * 10 + 7
    return mesh, np.arange(4, 8), np.arange(8, 12)


def put_fields(path, times, nodal, element=None, globals_=None):
    """nodal {name: (steps, nodes)}, element {name: {block number: (steps, elements)}}, globals_ {name: (steps,)}."""
    with netCDF4.Dataset(path, "a") as data:
        data["time_whole"][:] = times
        _put_names(data, "nod", list(nodal))
        for i, values in enumerate(nodal.values(), 1):
            data.createVariable(f"vals_nod_var{i}", "f8", ("time_step", "num_nodes"))[:] = values
        if element:
            _put_names(data, "elem", list(element))
        for i, blocks in enumerate((element or {}).values(), 1):
            for number, values in blocks.items():
                data.createVariable(f"vals_elem_var{i}eb{number}", "f8", ("time_step", f"num_el_in_blk{number}"))[:] = values
        if globals_:
            _put_names(data, "glo", list(globals_))
            data.createVariable("vals_glo_var", "f8", ("time_step", "num_glo_var"))[:] = np.stack(list(globals_.values()), 1)


def _put_names(data, kind, words):
    data.createDimension(f"num_{kind}_var", len(words))
    length = len(data.dimensions["len_name"])
    rows = data.createVariable(f"name_{kind}_var", "S1", (f"num_{kind}_var", "len_name"))
    rows[:] = np.array([list(word.ljust(length, "\0")) for word in words], dtype="S1")


def pressed_bricks(path):
    """Results of bricks() whose faces press each other with 3 at t = 1, the upper one moved down by 0.25."""
    mesh, low, high = bricks()
    exodus_edit.write(path, mesh)
    zero = np.zeros((2, 16))
    fields = {name: zero.copy() for name in
              [f"displacement_{a}" for a in "xyz"] + ["contact_pressure", "contact_gap"]
              + [f"contact_traction_{a}" for a in "xyz"] + ["contact_status"]}
    fields["displacement_z"][1, 8:] = -0.25
    for side, sign in ((low, -1), (high, 1)):
        fields["contact_pressure"][1, side] = 3
        fields["contact_traction_z"][1, side] = 3 * sign
        fields["contact_status"][1, side] = 1
    put_fields(path, [0, 1], fields, {"von_mises": {1: [[0], [4]], 2: [[0], [5]]}},
               {"steps": np.array([0.0, 2]), "newton_iterations": np.array([0.0, 9]), "press_force_z": np.array([0.0, 3])})
    return mesh
