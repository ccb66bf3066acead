// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/abaqus/import.hpp"
#include "abut/translation/report.hpp"

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abut::abaqus {

using translation::Fate;
using translation::Report;

/// A line below a keyword.
struct DataLine {
  Place place;
  std::string_view text;

  /// What stands between its commas, without blanks at the ends.
  std::vector<std::string> fields() const;
};

/// A keyword with its parameters and data lines. It knows which parameters have been asked for:
/// what nobody asked for ends up refused, so that nothing is dropped in silence.
class Card {
public:
  Card(const std::vector<std::string>& files, Place place, std::string name, bool known)
      : files_(&files), place_(place), name_(std::move(name)), known_(known) {}

  const std::string& name() const { return name_; } ///< "CONTACT PAIR"
  bool is(const char* name) const { return name_ == name; }
  bool is_known() const { return known_; }
  const Place& place() const { return place_; }
  std::vector<DataLine> lines;

  void add_parameter(std::string name, std::string value);
  /// Its value, empty for a mere word; a parameter may be shortened to three letters.
  std::optional<std::string> parameter(const char* name);
  std::string required(const char* name);
  bool has(const char* name) { return parameter(name).has_value(); }
  /// A value of its own list, which may be shortened to three letters; `otherwise` without the
  /// parameter. Refuses the card for another value and then returns an empty text.
  std::string word(const char* name, std::initializer_list<const char*> valid,
                   const char* otherwise);
  std::optional<double> number_parameter(const char* name);
  /// These parameters cannot change the answer.
  void ignore(std::initializer_list<const char*> names, const std::string& why);

  void use();                               ///< somebody understands it
  void refuse(const std::string& why);      ///< it is not supported; all else goes on
  void set_ignored(const std::string& why); ///< it cannot change the answer
  void note(const std::string& text);

  /// "FILE:LINE: *KEYWORD: message"
  [[noreturn]] void fail(const std::string& message) const { fail(place_, message); }
  [[noreturn]] void fail(const Place& at, const std::string& message) const;
  double number(const DataLine& line, const std::string& field, const char* what) const;
  Global whole(const DataLine& line, const std::string& field, const char* what) const;
  /// Number i of the fields; `otherwise`, or an error without one, where it is missing or empty.
  double number(const DataLine& line, const std::vector<std::string>& fields, std::size_t i,
                const char* what, std::optional<double> otherwise = {}) const;
  /// The numbers of all lines, empty fields as zero; trailing ones left out.
  std::vector<double> numbers() const;

  void add_to(Report& report) const;

private:
  struct Parameter {
    std::string name, value;
    bool taken = false;
    std::string ignored;
  };
  Parameter* find(const char* name);

  const std::vector<std::string>* files_;
  Place place_;
  std::string name_;
  bool known_, used_ = false;
  std::vector<Parameter> parameters_;
  std::vector<std::string> asked_;
  std::vector<std::string> notes_, refusals_;
  std::optional<std::string> ignored_;
};

/// The keywords of a file and of those that it includes, in their order.
class Cards {
public:
  Cards(const std::string& text, const std::string& file, const ReadFile& read);

  std::vector<Card>& list() { return cards_; }
  const std::vector<std::string>& files() const { return files_; }
  Report report() const;

private:
  void read(int file);
  std::size_t keyword(int file, std::string_view text, std::size_t at, long long& line);
  void include(Card& card, int file);

  const ReadFile& read_file_;
  std::vector<std::string> files_;
  std::vector<std::unique_ptr<std::string>> texts_;
  std::vector<int> open_; ///< files that include the present one, and itself
  std::vector<Card> cards_;
  std::size_t receiver_ = 0; ///< index + 1 of the card that data lines belong to; 0: none yet
};

/// Whether a word is a valid one or, with three letters or more, the beginning of it.
bool stands_for(const std::string& word, const std::string& valid);

} // namespace abut::abaqus
