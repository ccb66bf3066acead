// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/io/options.hpp"
#include "abut/mesh/mesh.hpp"

#include <memory>
#include <string>
#include <vector>

namespace abut::io {

/// Names of what each time step holds. Names that end in _x, _y, _z become a vector in ParaView.
struct ResultNames {
  std::vector<std::string> nodal, element, global;
};

/// One time step; every outer list has the order of the names.
struct ResultStep {
  double time = 0.0;
  std::vector<std::vector<double>> nodal;   ///< (names) (owned nodes, in local order)
  std::vector<std::vector<double>> element; ///< (names) (this rank's elements, block after block)
  std::vector<double> global;               ///< (names) taken from the root
};

/// What the name of a file of results gets behind it: nothing for the first part of a run, "-s002"
/// for what a run writes that was started again from a checkpoint, and so on.
std::string part_suffix(int part);

/// Writes a mesh and time steps as Exodus II: one file STEM.exo in the order of the input, or one
/// per rank, STEM.exo.RANKS.RANK, with number maps that say how they join; further parts of a run
/// STEM.exo-s002 ... A set that has the name of a block or of a side set is called NAME_faces or
/// NAME_nodes there. All members are collective, also construction. The files are readable after
/// each step.
class ResultWriter {
public:
  /// Creates the files and writes the mesh, which must outlive the writer. Throws InputError on all
  /// ranks when that fails anywhere.
  ResultWriter(const std::string& stem, const mesh::Mesh& mesh, const ResultNames& names,
               Files files = Files::automatic, int part = 1);
  ~ResultWriter();
  ResultWriter(ResultWriter&&) noexcept;
  ResultWriter& operator=(ResultWriter&&) noexcept;

  /// Adds a step; times must grow. Throws InputError on all ranks when the disk fails, Defect when
  /// a list has the wrong length.
  void write_step(const ResultStep& step);

  /// The one file, or this rank's.
  const std::string& path() const;
  int steps() const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace abut::io
