// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/abaqus/model.hpp"
#include "abut/translation/report.hpp"
#include "abut/translation/yaml_text.hpp"

#include <array>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace abut::abaqus {

/// Points (total time, value), time growing; linear between them.
using Points = std::vector<std::array<double, 2>>;

/// What a line of the file asks of one component of a node, an element or a face.
struct Demand {
  long long key = 0; ///< of the node, element or face
  int component = 0;
  int step = -1;
  double value = 0.0;
  std::string amplitude;
  bool stays = false;
  Place place;
  std::string name; ///< of its set
};

/// A number from one step to another.
struct Run {
  std::size_t first = 0, last = 0; ///< steps
  bool stays = false;              ///< where the node is
  Points points;

  bool is_zero() const;
  friend bool operator<(const Run& a, const Run& b) {
    return std::tie(a.first, a.last, a.stays, a.points) <
           std::tie(b.first, b.last, b.stays, b.points);
  }
  friend bool operator==(const Run& a, const Run& b) { return !(a < b) && !(b < a); }
};

using Runs = std::map<std::pair<long long, int>, std::vector<Run>>; ///< by key and component

enum class Kind { displacement, load };

/// What the demands of all steps come to. Within a step several loads on one key add up, and the
/// last displacement counts; a later step replaces them. What OP=NEW takes away ends: a
/// displacement with the step before, a load by a ramp to zero in its step.
Runs runs_of(const Model& model, const std::vector<Demand>& demands, Kind kind,
             Renewal::Kind renewal, translation::Report& report);

/// A number and a curve for it; an empty name is t itself, or of a zero none.
struct Timed {
  double number = 0.0;
  std::string curve;
};

/// The curves that a deck uses.
class Curves {
public:
  explicit Curves(const Model& model) : end_(model.end()) {}

  Timed of(const Points& points, const std::string& name);
  /// Names of the curves 1 and t.
  std::string constant();
  std::string ramp();
  std::string text() const;

private:
  double end_;
  translation::DeckNames names_;
  std::map<Points, std::string> used_;
};

} // namespace abut::abaqus
