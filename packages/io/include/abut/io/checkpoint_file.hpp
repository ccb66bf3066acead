// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/state_archive.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace abut::io {

/// The state of a run between two steps, and what it is a state of.
struct Checkpoint {
  std::string program;    ///< version of what wrote it
  std::string deck;       ///< file
  std::string model;      ///< the deck's part that decides what is solved, as text
  std::uint64_t mesh = 0; ///< fingerprint
  double t = 0.0;
  long long step = 0;
  int part = 1; ///< of the results that were written until then
  std::vector<StateArchive::Array> arrays;
};

/// One line `abut checkpoint VERSION BYTES`, one line of JSON with the facts and the arrays' names
/// and shapes, the arrays themselves, keys (int64) before values (float64), little-endian, and a
/// checksum of all that. Written beside the path, brought to the disk and renamed: whatever
/// happens, the path holds a whole checkpoint or what it held before. Serial. Throws MachineError.
void write_checkpoint(const std::string& path, const Checkpoint& checkpoint);

/// Serial. Throws InputError that names the file and what is wrong: it cannot be read, is none of
/// ours, of another format, cut short or damaged.
Checkpoint read_checkpoint(const std::string& path);

/// Whether the file at the path begins like a checkpoint, whole or not. Serial.
bool is_checkpoint(const std::string& path);

} // namespace abut::io
