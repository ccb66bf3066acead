// SPDX-License-Identifier: BSD-3-Clause
#include "card.hpp"

#include "keywords.hpp"

#include "abut/core/error.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace abut::abaqus {

namespace {

bool is_blank(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

std::string without_blanks(const std::string& text) {
  std::string out;
  std::copy_if(text.begin(), text.end(), std::back_inserter(out),
               [](char c) { return !is_blank(c); });
  return out;
}

/// A field as it may be shown in a message.
std::string shown(const std::string& field) {
  constexpr std::size_t longest = 40;
  std::string s = field.substr(0, longest);
  std::replace_if(
      s.begin(), s.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + s + (field.size() > longest ? "...'" : "'");
}

} // namespace

bool stands_for(const std::string& word, const std::string& valid) {
  constexpr std::size_t least = 3;
  const std::string a = key_of(word), b = key_of(valid);
  return a == b || (a.size() >= least && b.compare(0, a.size(), a) == 0);
}

std::vector<std::string> DataLine::fields() const {
  std::vector<std::string> result;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    std::size_t first = at, last = end;
    while (first < last && is_blank(text[first]))
      ++first;
    while (last > first && is_blank(text[last - 1]))
      --last;
    result.emplace_back(text.substr(first, last - first));
    at = end + 1;
  }
  if (result.size() > 1 && result.back().empty())
    result.pop_back(); // behind the comma at the end
  return result;
}

void Card::add_parameter(std::string name, std::string value) {
  parameters_.push_back({key_of(name), std::move(value), false, ""});
}

Card::Parameter* Card::find(const char* name) {
  const std::string key = key_of(name);
  if (std::find(asked_.begin(), asked_.end(), name) == asked_.end())
    asked_.emplace_back(name);
  Parameter* found = nullptr;
  for (Parameter& p : parameters_)
    if (p.name == key)
      found = &p;
  for (Parameter& p : parameters_)
    if (!found && !p.taken && stands_for(p.name, key))
      found = &p;
  if (found)
    found->taken = true;
  return found;
}

std::optional<std::string> Card::parameter(const char* name) {
  const Parameter* p = find(name);
  return p ? std::optional(p->value) : std::nullopt;
}

std::string Card::required(const char* name) {
  const auto value = parameter(name);
  if (!value || key_of(*value).empty())
    fail(std::string("expected the parameter ") + name + "=...");
  return *value;
}

std::string Card::word(const char* name, std::initializer_list<const char*> valid,
                       const char* otherwise) {
  const auto value = parameter(name);
  if (!value)
    return otherwise;
  for (const char* word : valid)
    if (key_of(*value) == key_of(word))
      return word;
  for (const char* word : valid)
    if (stands_for(*value, word))
      return word;
  const std::vector<std::string> words(valid.begin(), valid.end());
  refuse(std::string(name) + "=" + shown(*value) + "; " +
         nearest_word_hint(key_of(*value), words.data(), words.size()));
  return "";
}

std::optional<double> Card::number_parameter(const char* name) {
  const auto value = parameter(name);
  if (!value)
    return {};
  return number({place_, {}}, *value, name);
}

void Card::ignore(std::initializer_list<const char*> names, const std::string& why) {
  for (const char* name : names)
    if (Parameter* p = find(name))
      p->ignored = why;
}

void Card::use() {
  used_ = true;
}

void Card::refuse(const std::string& why) {
  if (std::find(refusals_.begin(), refusals_.end(), why) == refusals_.end())
    refusals_.push_back(why);
}

void Card::set_ignored(const std::string& why) {
  ignored_ = why;
}

void Card::note(const std::string& text) {
  if (std::find(notes_.begin(), notes_.end(), text) == notes_.end())
    notes_.push_back(text);
}

void Card::fail(const Place& at, const std::string& message) const {
  throw InputError((*files_)[static_cast<std::size_t>(at.file)] + ":" + std::to_string(at.line) +
                   ": *" + name_ + ": " + message);
}

double Card::number(const DataLine& line, const std::string& field, const char* what) const {
  std::string text = without_blanks(field);
  for (char& c : text)
    if (c == 'd' || c == 'D')
      c = 'e';
  double value = 0.0;
  const char *first = text.data() + (!text.empty() && text[0] == '+' ? 1 : 0),
             *last = text.data() + text.size();
  const auto end = std::from_chars(first, last, value);
  constexpr double largest = 1e60, least = 1e-60; // products of some of them are numbers still
  const bool is_number = first != last && end.ec == std::errc() && end.ptr == last;
  if (!is_number || !(std::abs(value) <= largest))
    fail(line.place, std::string("expected ") + what + ", got " + shown(field));
  return std::abs(value) < least ? 0.0 : value;
}

Global Card::whole(const DataLine& line, const std::string& field, const char* what) const {
  constexpr double largest = 2000000000; // Exodus files hold 32 bits
  const double value = number(line, field, what);
  if (value != std::floor(value) || std::abs(value) > largest)
    fail(line.place, std::string("expected ") + what + ", got " + shown(field));
  return static_cast<Global>(value);
}

double Card::number(const DataLine& line, const std::vector<std::string>& fields, std::size_t i,
                    const char* what, std::optional<double> otherwise) const {
  if (i < fields.size() && !fields[i].empty())
    return number(line, fields[i], what);
  if (!otherwise)
    fail(line.place, std::string("expected ") + what);
  return *otherwise;
}

std::vector<double> Card::numbers() const {
  std::vector<double> result;
  for (const DataLine& line : lines) {
    const std::vector<std::string> fields = line.fields();
    for (const std::string& field : fields)
      result.push_back(field.empty() ? 0.0 : number(line, field, "a number"));
  }
  return result;
}

void Card::add_to(Report& report) const {
  const auto joined = [](const std::vector<std::string>& texts) {
    std::string out;
    for (const std::string& t : texts)
      out += (out.empty() ? "" : "; ") + t;
    return out;
  };
  const std::string included = place_.file == 0 ? ""
                                                : (*files_)[static_cast<std::size_t>(place_.file)] +
                                                      ":" + std::to_string(place_.line) + ": ";
  // Lines of included files are told in the path; the report counts those of the file itself.
  const auto entry = [&](const std::string& path, Fate fate, const std::string& note) {
    report.add({place_.line, included + "*" + path, fate, note});
  };
  if (!refusals_.empty()) {
    entry(name_, Fate::refused, joined(refusals_));
    return;
  }
  if (ignored_) {
    entry(name_, Fate::ignored, *ignored_);
    return;
  }
  if (!used_) {
    entry(name_, Fate::refused, "it does not belong here");
    return;
  }
  entry(name_, Fate::used, joined(notes_));
  for (const Parameter& p : parameters_)
    if (!p.taken)
      entry(name_ + ", " + p.name, Fate::refused,
            "abut does not know this parameter; " +
                nearest_word_hint(p.name, asked_.data(), asked_.size()));
    else if (!p.ignored.empty())
      entry(name_ + ", " + p.name, Fate::ignored, p.ignored);
}

Cards::Cards(const std::string& text, const std::string& file, const ReadFile& read)
    : read_file_(read) {
  files_.push_back(file);
  texts_.push_back(std::make_unique<std::string>(text));
  this->read(0);
}

void Cards::read(int file) {
  open_.push_back(file);
  const std::string_view text = *texts_[static_cast<std::size_t>(file)];
  long long line = 0;
  for (std::size_t at = 0; at < text.size();) {
    ++line;
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::size_t first = at;
    while (first < end && is_blank(text[first]))
      ++first;
    if (first == end || text.compare(first, 2, "**") == 0) {
      at = end + 1;
    } else if (text[first] == '*') {
      at = keyword(file, text, first, line);
    } else {
      if (receiver_ == 0)
        throw InputError(files_[static_cast<std::size_t>(file)] + ":" + std::to_string(line) +
                         ": expected a keyword, as *NODE, before the first data line");
      cards_[receiver_ - 1].lines.push_back({{file, line}, text.substr(first, end - first)});
      at = end + 1;
    }
  }
  open_.pop_back();
}

/// From the star to the end of its line, and of the next one where a comma ends it. Returns the
/// beginning of the line behind.
std::size_t Cards::keyword(int file, std::string_view text, std::size_t at, long long& line) {
  const Place place{file, line};
  std::string words;
  for (bool more = true; more && at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    words += text.substr(at, end - at);
    at = end + 1;
    while (!words.empty() && is_blank(words.back()))
      words.pop_back();
    more = words.back() == ',' && at < text.size() && text[at] != '*';
    line += more;
  }
  const std::vector<std::string> fields = DataLine{place, words}.fields();
  const std::string name = key_of(fields[0].substr(1));
  const Keyword* known = find_keyword(name);
  constexpr std::size_t longest_name = 80, longest_value = 1000; // what is longer is no word
  Card card(files_, place, known ? known->name : name.substr(0, longest_name), known != nullptr);
  for (std::size_t i = 1; i < fields.size(); ++i) {
    const std::size_t equals = fields[i].find('=');
    const std::string key = fields[i].substr(0, equals);
    if (key_of(key).empty())
      continue;
    std::string value = equals == std::string::npos ? "" : fields[i].substr(equals + 1);
    value.erase(0, std::min(value.find_first_not_of(" \t"), value.size()));
    if (value.size() > longest_value)
      card.fail("expected a value of at most a thousand letters");
    card.add_parameter(key.substr(0, longest_name), std::move(value));
  }
  const bool includes = card.is("INCLUDE");
  cards_.push_back(std::move(card));
  if (!includes)
    receiver_ = cards_.size();
  else
    include(cards_.back(), file);
  return at;
}

void Cards::include(Card& card, int file) {
  card.use();
  std::string name = card.required("INPUT");
  name.erase(std::remove(name.begin(), name.end(), '"'), name.end());
  const std::string& from = files_[static_cast<std::size_t>(file)];
  const std::size_t folder = from.find_last_of('/');
  const std::string path =
      name[0] == '/' || folder == std::string::npos ? name : from.substr(0, folder + 1) + name;
  for (const int open : open_)
    if (files_[static_cast<std::size_t>(open)] == path)
      card.fail("the file includes itself");
  std::string text;
  try {
    text = read_file_(path);
  } catch (const InputError& e) {
    card.fail(e.what());
  }
  files_.push_back(path);
  texts_.push_back(std::make_unique<std::string>(std::move(text)));
  read(static_cast<int>(files_.size()) - 1);
}

Report Cards::report() const {
  Report report;
  for (const Card& card : cards_)
    card.add_to(report);
  return report;
}

} // namespace abut::abaqus
