// SPDX-License-Identifier: BSD-3-Clause
#include "abut/io/history_file.hpp"

#include "abut/core/error.hpp"
#include "abut/core/machine_error.hpp"
#include "linked.hpp"

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace abut::io {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string line_of(const double* row, std::size_t columns) {
  std::string line;
  for (std::size_t i = 0; i < columns; ++i) {
    char number[40];
    std::snprintf(number, sizeof number, "%.17g", row[i]);
    line += (i > 0 ? "," : "") + std::string(number);
  }
  return line + "\n";
}

/// A name as a cell of a line: in quotes where it would be cut apart.
std::string cell(const std::string& name) {
  if (name.find_first_of(",\"\n") == std::string::npos)
    return name;
  std::string quoted = "\"";
  for (const char c : name)
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

void describe(const std::string& path, const std::vector<HistoryColumn>& columns) {
  Json list = Json::array();
  for (const HistoryColumn& c : columns)
    list.push_back({{"name", c.name}, {"of", c.key}, {"meaning", c.meaning}, {"unit", c.unit}});
  std::ofstream out(path);
  out << list.dump(1, ' ', false, Json::error_handler_t::replace) << '\n';
  if (!out.flush())
    throw InputError("cannot write '" + path + "'");
}

} // namespace

std::string history_path(const std::string& stem) {
  return stem + ".history.csv";
}
std::string history_columns_path(const std::string& stem) {
  return stem + ".history.json";
}

HistoryFile::HistoryFile(const std::string& stem, const std::vector<HistoryColumn>& columns,
                         const std::vector<double>& rows)
    : path_(history_path(stem)) {
  describe(history_columns_path(stem), columns);
  const fs::path place = linked(path_);
  std::error_code ignored;
  // Rows of an earlier part must not be lost if this run ends here: a draft takes their place.
  const bool is_file = !fs::exists(place, ignored) || fs::is_regular_file(place, ignored);
  const fs::path draft = is_file ? place.string() + ".unfinished" : place.string();
  out_.open(draft);
  for (std::size_t i = 0; i < columns.size(); ++i)
    out_ << (i > 0 ? "," : "") << cell(columns[i].name);
  out_ << '\n';
  for (std::size_t first = 0; first < rows.size(); first += columns.size())
    out_ << line_of(&rows[first], columns.size());
  std::error_code error;
  if (out_.flush() && is_file)
    fs::rename(draft, place, error);
  if (!out_ || error) {
    if (is_file)
      fs::remove(draft, ignored);
    throw InputError("cannot write '" + path_ + "'");
  }
}

void HistoryFile::add(const std::vector<double>& row) {
  out_ << line_of(row.data(), row.size());
  if (!out_.flush())
    throw MachineError("cannot write '" + path_ + "': is the disk full?");
}

} // namespace abut::io
