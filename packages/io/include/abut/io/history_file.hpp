// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace abut::io {

/// A column of a history: what it is, in words.
struct HistoryColumn {
  std::string name, key, meaning, unit;
};

/// A table in time as STEM.history.csv: a line of names, then a line of numbers for each row, with
/// 17 significant digits, on its way to the disk as soon as it is added. STEM.history.json beside
/// it says what each column is. Serial.
class HistoryFile {
public:
  /// Replaces what is there, at once, by the rows (rows, columns) known so far. Throws InputError
  /// when the files cannot be written.
  HistoryFile(const std::string& stem, const std::vector<HistoryColumn>& columns,
              const std::vector<double>& rows);

  /// Throws MachineError when the disk does not take it.
  void add(const std::vector<double>& row);

private:
  std::string path_;
  std::ofstream out_;
};

std::string history_path(const std::string& stem);         ///< of the table
std::string history_columns_path(const std::string& stem); ///< of what its columns are

} // namespace abut::io
