# SPDX-License-Identifier: BSD-3-Clause
"""Results of a run, whether all ranks wrote one file or each its own.

    from abut.results import Results
    results = Results("blocks.exo")
    x = results.coordinates + results.vector("displacement")   # at the last written step
    print(results.times[-1], results.nodal("contact_pressure").max())
"""
import glob
import pathlib
import re

import numpy as np

from .errors import InputError
from .exodus import ExodusFile


def files_of(path):
    """The files that hold the results `path`: itself, or those of the ranks, NAME.exo.RANKS.RANK."""
    path = pathlib.Path(path)
    of_rank = re.fullmatch(r"(.*)\.(\d+)\.(\d+)", path.name)
    if of_rank and path.exists():
        stem, ranks = of_rank.group(1), int(of_rank.group(2))
        files = [path.with_name(f"{stem}.{ranks}.{rank:0{len(str(ranks))}d}") for rank in range(ranks)]
        missing = [file.name for file in files if not file.exists()]
        if missing:
            raise InputError(f"{path}: is one of {ranks} files, of which are missing: {', '.join(missing)}")
        return files
    if path.exists():
        return [path]
    parts = sorted(glob.glob(glob.escape(str(path)) + ".*.*"))
    parts = [part for part in parts if re.fullmatch(r"\.\d+\.0+", part[len(str(path)):])]
    if len(parts) > 1:
        raise InputError(f"{path}: there are results of several numbers of ranks; give one of {', '.join(parts)}")
    if not parts:
        raise InputError(f"{path}: there is no such file")
    return files_of(parts[0])


class Results:
    """Mesh and fields of a run. Steps count from 0, -1 is the last one; nodes and elements from 0.

    Of several files, nodes are in the order of their numbers, elements in that of ranks, and the steps are those that
    all files have. Raises InputError for files that cannot be read or lack a name.
    """

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.parts = [ExodusFile(file) for file in files_of(path)]
        ids = [part.node_map for part in self.parts]
        if len(self.parts) == 1:
            self.node_map, self._places = ids[0], [np.arange(len(ids[0]))]
        else:
            self.node_map = np.unique(np.concatenate(ids))
            self._places = [np.searchsorted(self.node_map, own) for own in ids]

    @property
    def times(self):
        """Load parameter t of each written step."""
        return min((part.times for part in self.parts), key=len)

    @property
    def title(self):
        return self.parts[0].title

    @property
    def coordinates(self):
        """(nodes, 3), of the reference configuration."""
        return self._join([part.coordinates for part in self.parts])

    @property
    def num_elements(self):
        return sum(len(part.element_map) for part in self.parts)

    @property
    def blocks(self):
        return self.names("eb")

    def names(self, kind):
        """kind: nod_var, elem_var, glo_var (variables), eb, ns, ss (blocks and sets)."""
        return max((part.names(kind) for part in self.parts), key=len)

    def has_nodal(self, name):
        return name in self.names("nod_var") and len(self.times) > 0

    def nodal(self, name, step=-1):
        """(nodes,) values of a nodal variable."""
        step = self._step(step)
        return self._join([part.nodal(name, step) for part in self.parts if len(part.node_map)])

    def vector(self, name, step=-1):
        """(nodes, 3) from name_x, name_y, name_z."""
        return np.stack([self.nodal(f"{name}_{axis}", step) for axis in "xyz"], axis=1)

    def element(self, name, block, step=-1):
        """(elements of the block,) values of an element variable."""
        step = self._step(step)
        return np.concatenate([part.element(name, block, step) for part in self.parts
                               if len(part.connectivity(block))] or [np.zeros(0)])

    def globals(self, step=-1):
        """All global variables by name."""
        return self.parts[0].globals(self._step(step))

    def global_columns(self):
        """All global variables over the steps: {name: (steps,)}."""
        steps = len(self.times)
        return {name: column[:steps] for name, column in self.parts[0].global_columns().items()}

    def kind(self, block):
        """Type of the elements of a block: HEX8, TETRA10, ..."""
        return next(filter(None, (part.kind(block) for part in self.parts)), "")

    def connectivity(self, block):
        """(elements, nodes of each), indices into coordinates."""
        cells = [place[part.connectivity(block)] for part, place in zip(self.parts, self._places)
                 if len(part.connectivity(block))]
        return np.concatenate(cells) if cells else np.zeros((0, 0), int)

    def node_set(self, name):
        """Indices into coordinates."""
        return np.unique(np.concatenate([place[part.node_set(name)]
                                         for part, place in zip(self.parts, self._places)]))

    def _step(self, step):
        steps = len(self.times)
        if not -steps <= step < steps:
            raise InputError(f"{self.path}: holds {steps} steps, not number {step}")
        return step % steps

    def _join(self, values):
        """Values at the nodes of each part as those of all."""
        if len(values) == 1 and len(self.parts) == 1:
            return np.asarray(values[0])
        places = [place for place in self._places if len(place)]
        joined = np.zeros((len(self.node_map), *values[0].shape[1:]))
        for place, own in zip(places, (v for v in values if len(v))):
            joined[place] = own
        return joined
