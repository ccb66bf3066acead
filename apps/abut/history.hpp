// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model.hpp"

#include "abut/core/state_archive.hpp"
#include "abut/io/history_file.hpp"
#include "abut/scene/state.hpp"

#include <optional>
#include <string>
#include <vector>

namespace abut::app {

/// The global variables at every converged step, in a file that goes on over all parts of a run:
/// checkpoints carry its rows. Every member is collective.
class History {
public:
  /// stem: path of the results, the same for all parts. The model must outlive it.
  History(const Model& model, std::string stem);

  /// The first time it starts the file, with the rows known so far. Throws InputError when that
  /// cannot be written, MachineError when the disk is full.
  void add(const scene::State& state);
  /// The rows up to now. Where an archive has none, or of other columns, there are none.
  void exchange_state(StateArchive& archive);

private:
  std::vector<double> row_of(const scene::State& state) const;

  const Model& model_;
  std::string stem_;
  std::vector<io::HistoryColumn> columns_;
  std::vector<double> rows_;            ///< (rows, columns) on the root, kept for checkpoints
  std::optional<io::HistoryFile> file_; ///< on the root
};

} // namespace abut::app
