// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace abut::translation {

/// What became of one construct of a file of another program.
enum class Fate {
  used,
  ignored, ///< cannot change the answer, or means nothing to abut
  refused, ///< not supported: there is no import
};

/// Every construct of a file and its fate, in the order of the file.
class Report {
public:
  struct Entry {
    long long line = 0; ///< or byte, see count_bytes
    std::string path;   ///< "Contact/contact/penalty"
    Fate fate = Fate::used;
    std::string note; ///< why, or how its meaning changed; may be empty
  };

  /// Places are bytes instead of lines, as in a binary file.
  void count_bytes(bool bytes) { bytes_ = bytes; }
  void add(Entry entry) { entries_.push_back(std::move(entry)); }
  const std::vector<Entry>& entries() const { return entries_; }
  int count(Fate fate) const;

  /// One line for each construct, of one fate after the other.
  std::string text(const std::string& file) const;
  /// Throws InputError that names all that is refused; does nothing when nothing is.
  void require_nothing_refused(const std::string& file) const;

private:
  bool bytes_ = false;
  std::vector<Entry> entries_;
};

} // namespace abut::translation
