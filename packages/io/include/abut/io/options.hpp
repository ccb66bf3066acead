// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace abut::io {

enum class Files {
  automatic, ///< one file up to 200,000 nodes or on one rank, per rank beyond
  one,
  per_rank,
};

/// When a run writes down where it stands: whichever comes first; the last converged step always.
struct CheckpointOptions {
  bool active = false;
  std::optional<int> every;      ///< converged steps
  std::optional<double> minutes; ///< of wall time
};

/// Fields beside those of every run.
struct FieldOptions {
  bool stress_tensor = false, principal_stress = false, strain = false, nodal_stress = false;
};

struct OutputOptions {
  std::string name; ///< file name without folder and extension; empty: the deck's name
  Files files = Files::automatic;
  int every = 1; ///< write every n-th converged step; the last one always
  FieldOptions fields;
  bool history = true; ///< write a table of the global variables at every converged step
  bool points = false; ///< write a table of all contact points beside the fields
  CheckpointOptions checkpoint;
};

} // namespace abut::io
