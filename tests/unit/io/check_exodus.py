# SPDX-License-Identifier: BSD-3-Clause
"""Opens what test_io_result_writer wrote with VTK and compares names, times and values.

usage: check_exodus.py FOLDER RANKS
"""
import sys

from vtkmodules.vtkIOExodus import vtkExodusIIReader
from vtkmodules.util.numpy_support import vtk_to_numpy
import numpy as np

TIMES = [0.5, 1.25, 2.0]
# VTK keeps points in single precision: 2 * 2**-24 for coordinates below 2, times 2 in the field.
ROUNDING = 4 * 2.0 ** -24


def require(condition, message):
    if not condition:
        sys.exit("check_exodus: " + message)


def read(path, step):
    """Blocks of one file at one step: name -> grid, with all arrays switched on."""
    reader = vtkExodusIIReader()
    reader.SetFileName(path)
    reader.ApplyDisplacementsOff()
    reader.GenerateGlobalNodeIdArrayOn()
    reader.GenerateGlobalElementIdArrayOn()
    reader.UpdateInformation()
    times = [reader.GetOutputInformation(0).Get(_TIME_STEPS, i)
             for i in range(reader.GetOutputInformation(0).Length(_TIME_STEPS))]
    require(np.allclose(times, TIMES, rtol=0, atol=1e-15), f"{path}: times {times}")
    kinds = (reader.NODAL, reader.ELEM_BLOCK, reader.GLOBAL)
    for kind in kinds:
        for i in range(reader.GetNumberOfObjectArrays(kind)):
            reader.SetObjectArrayStatus(kind, reader.GetObjectArrayName(kind, i), 1)
    names = {kind: [reader.GetObjectArrayName(kind, i)
                    for i in range(reader.GetNumberOfObjectArrays(kind))] for kind in kinds}
    require(names[reader.NODAL] == ["displacement_", "input_number"] or
            names[reader.NODAL] == ["displacement", "input_number"], f"nodal {names[reader.NODAL]}")
    require(names[reader.ELEM_BLOCK] == ["centre_z_plus_time", "element_number"],
            f"element {names[reader.ELEM_BLOCK]}")
    require(names[reader.GLOBAL] == ["force", "newton_iterations"], f"global {names[reader.GLOBAL]}")
    reader.SetTimeStep(step)
    reader.GetOutputInformation(0).Set(_UPDATE_TIME, TIMES[step])
    reader.Update()
    blocks = reader.GetOutput().GetBlock(0)
    grids = {}
    for b in range(blocks.GetNumberOfBlocks()):
        if blocks.GetBlock(b):
            grids[reader.GetObjectName(reader.ELEM_BLOCK, b)] = blocks.GetBlock(b)
    return grids


def check_file(path, seen):
    for step, time in enumerate(TIMES):
        for name, grid in read(path, step).items():
            if grid.GetNumberOfCells() == 0:
                continue
            data = grid.GetPointData()
            arrays = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
            vector = next(a for a in arrays if a.startswith("displacement"))
            u = vtk_to_numpy(data.GetArray(vector))
            x = vtk_to_numpy(grid.GetPoints().GetData())
            require(u.shape[1] == 3, "displacement is no vector")
            expected = np.column_stack([time * x[:, 0], 2.0 * x[:, 1], time + x[:, 2]])
            require(np.abs(u - expected).max() < ROUNDING, f"{path} {name}: displacement")
            number = vtk_to_numpy(data.GetArray("input_number"))
            ids = vtk_to_numpy(data.GetGlobalIds() or data.GetArray("GlobalNodeId"))
            require((ids == 100 + 3 * number).all(), f"{path} {name}: node ids")
            cells = grid.GetCellData()
            number = vtk_to_numpy(cells.GetArray("element_number"))
            ids = vtk_to_numpy(cells.GetGlobalIds() or cells.GetArray("GlobalElementId"))
            require((ids == 50 + 2 * number).all(), f"{path} {name}: element ids")
            value = vtk_to_numpy(cells.GetArray("centre_z_plus_time"))
            for c in range(grid.GetNumberOfCells()):
                points = grid.GetCell(c).GetPointIds()
                z = np.mean([x[points.GetId(i), 2] for i in range(points.GetNumberOfIds())])
                require(abs(value[c] - z - time) < ROUNDING, f"{path} {name}: element field")
            force = grid.GetFieldData().GetArray("force")
            require(force is not None and
                    any(abs(force.GetTuple1(i) - 10 * time) < 1e-12
                        for i in range(force.GetNumberOfTuples())), f"{path}: global variable")
            seen.setdefault((step, name), []).extend(int(n) for n in number)


def check(paths, what):
    seen = {}
    for path in paths:
        check_file(path, seen)
    for step in range(len(TIMES)):
        require(sorted(seen[(step, "lower")]) == list(range(0, 60)), f"{what}: block lower")
        require(sorted(seen[(step, "upper")]) == list(range(60, 96)), f"{what}: block upper")
    print(f"check_exodus: {what}: {len(TIMES)} steps in {len(paths)} files are right")


def check_together(pattern_stem, ranks):
    """The files of all ranks as one data set, as ParaView opens them."""
    try:
        from vtkmodules.vtkIOParallelExodus import vtkPExodusIIReader
    except ImportError:
        print("check_exodus: VTK has no parallel Exodus reader; skipped")
        return
    reader = vtkPExodusIIReader()
    reader.SetFilePrefix(pattern_stem)
    reader.SetFilePattern("%s.%0" + str(len(str(ranks))) + "i")
    reader.SetFileRange(0, ranks - 1)
    reader.SetFileName(pattern_stem + ".0")
    reader.UpdateInformation()
    reader.Update()
    cells = reader.GetOutput().GetNumberOfCells()
    require(cells == 96, f"all ranks' files together have {cells} cells")
    print("check_exodus: the ranks' files open as one")


if __name__ == "__main__":
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as pipeline
    _TIME_STEPS, _UPDATE_TIME = pipeline.TIME_STEPS(), pipeline.UPDATE_TIME_STEP()
    folder, ranks = sys.argv[1], int(sys.argv[2])
    check([f"{folder}/results{ranks}.exo"], "one file")
    if ranks > 1:
        stem = f"{folder}/parts{ranks}.exo.{ranks}"
        check([f"{stem}.{r}" for r in range(ranks)], "a file per rank")
        check_together(stem, ranks)
