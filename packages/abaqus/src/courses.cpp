// SPDX-License-Identifier: BSD-3-Clause
#include "courses.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace abut::abaqus {

using translation::Fate;

namespace {

constexpr double jump = 1e-9; // of the whole time

void append(Points& points, double t, double value) {
  if (points.empty() || t > points.back()[0])
    points.push_back({t, value});
}

/// The demands of one step on one key.
struct Wanted {
  double value = 0.0;
  const Amplitude* amplitude = nullptr;
  bool stays = false;
};

class Course {
public:
  Course(const Model& model, Kind kind, const std::vector<bool>& renewed)
      : model_(model), kind_(kind), renewed_(renewed), end_(model.end()) {}

  std::vector<Run> run(const std::map<int, Wanted>& wanted) {
    for (std::size_t s = 0; s < model_.steps.size(); ++s) {
      const auto now = wanted.find(static_cast<int>(s));
      const bool is_new = now != wanted.end();
      if (renewed_[s] && !is_new)
        end(s);
      else if (is_new)
        begin(s, now->second);
      else if (active_)
        go_on(s);
    }
    return std::move(runs_);
  }

private:
  void begin(std::size_t s, const Wanted& w) {
    if (!active_ || w.stays || runs_.back().stays) {
      runs_.push_back({s, s, w.stays, {}});
      last_ = 0.0;
      if (s > 0 && kind_ == Kind::load)
        runs_.back().first = 0;
      if (runs_.back().first < s)
        runs_.back().points = {{0.0, 0.0}, {model_.start(s), 0.0}};
    }
    active_ = true;
    present_ = w;
    runs_.back().last = s;
    if (!w.stays)
      add(s);
  }

  /// The points of a step in which something new begins.
  void add(std::size_t s) {
    Points& points = runs_.back().points;
    const Step& step = model_.steps[s];
    const double from = model_.start(s), to = model_.start(s + 1);
    if (present_.amplitude) {
      follow(points, from, to, present_.amplitude->total_time ? 0.0 : from);
      return;
    }
    const bool at_once = step.at_once || step.dynamic;
    if (!at_once) {
      append(points, from, last_);
    } else if (last_ != present_.value || points.empty()) {
      if (!points.empty() || s > runs_.back().first)
        append(points, from, last_);
      append(points, points.empty() ? from : from + jump * end_, present_.value);
    }
    append(points, to, last_ = present_.value);
  }

  /// The amplitude, whose time begins at `zero`.
  void follow(Points& points, double from, double to, double zero) {
    const Amplitude& a = *present_.amplitude;
    const auto at = [&](double t) { return present_.value * a(t - zero); };
    if (!points.empty() && points.back()[1] != at(from))
      append(points, from + jump * end_, at(from));
    else
      append(points, from, at(from));
    for (const auto& p : a.points)
      if (p[0] + zero > from && p[0] + zero < to)
        append(points, p[0] + zero, at(p[0] + zero));
    append(points, to, last_ = at(to));
  }

  void go_on(std::size_t s) {
    Run& run = runs_.back();
    run.last = s;
    if (run.stays)
      return;
    const double from = model_.start(s), to = model_.start(s + 1);
    // What counts the time of a step holds its last value in the next one.
    if (present_.amplitude && present_.amplitude->total_time)
      follow(run.points, from, to, 0.0);
    else
      append(run.points, to, last_);
  }

  void end(std::size_t s) {
    if (!active_)
      return;
    active_ = false;
    if (kind_ == Kind::displacement)
      return;
    Run& run = runs_.back();
    const double from = model_.start(s);
    append(run.points, model_.steps[s].at_once ? from + jump * end_ : model_.start(s + 1), 0.0);
    append(run.points, end_, 0.0);
    run.last = model_.steps.size() - 1;
  }

  const Model& model_;
  Kind kind_;
  const std::vector<bool>& renewed_;
  double end_;
  bool active_ = false;
  double last_ = 0.0; ///< value at the end of the last step
  Wanted present_;
  std::vector<Run> runs_;
};

} // namespace

bool Run::is_zero() const {
  return std::all_of(points.begin(), points.end(), [](const auto& p) { return p[1] == 0.0; });
}

Runs runs_of(const Model& model, const std::vector<Demand>& demands, Kind kind,
             Renewal::Kind renewal, translation::Report& report) {
  std::vector<bool> renewed(model.steps.size(), false);
  for (const Renewal& r : model.renewals)
    if (r.kind == renewal)
      renewed[std::size_t(r.step)] = true;
  std::map<std::pair<long long, int>, std::map<int, Wanted>> wanted;
  std::set<long long> mixed;
  for (const Demand& d : demands) {
    const int step = std::max(d.step, 0);
    if (d.step < 0 && renewed[0])
      continue;
    auto& of_key = wanted[{d.key, d.component}];
    const auto [at, is_new] = of_key.try_emplace(step);
    Wanted& w = at->second;
    const Amplitude* const a = d.amplitude.empty() ? nullptr : &model.amplitudes.at(d.amplitude);
    const bool adds = kind == Kind::load && !is_new;
    if (adds && w.amplitude != a && mixed.insert(d.place.line).second)
      report.add({d.place.line, "load on '" + d.name + "'", Fate::refused,
                  "two loads of one step on the same place have different amplitudes"});
    w.value = adds ? w.value + d.value : d.value;
    w.amplitude = a;
    w.stays = d.stays;
  }
  Runs runs;
  for (const auto& [key, of_key] : wanted)
    runs[key] = Course(model, kind, renewed).run(of_key);
  return runs;
}

Timed Curves::of(const Points& points, const std::string& name) {
  double number = 0.0;
  for (const auto& p : points)
    if (std::abs(p[1]) > std::abs(number))
      number = p[1];
  if (number == 0.0)
    return {};
  Points unit;
  for (const auto& p : points) {
    const double value = p[1] / number;
    const auto n = unit.size();
    if (n > 1 && unit[n - 1][1] == value && unit[n - 2][1] == value)
      unit[n - 1][0] = p[0];
    else
      unit.push_back({p[0], value});
  }
  if (unit.size() == 1)
    unit.push_back({std::max(end_, unit[0][0] + 1.0), unit[0][1]});
  if (end_ == 1.0 && unit == Points{{0.0, 0.0}, {1.0, 1.0}})
    return {number, ""};
  const auto known = used_.find(unit);
  if (known != used_.end())
    return {number, known->second};
  const bool constant =
      std::all_of(unit.begin(), unit.end(), [](const auto& p) { return p[1] == 1.0; });
  return {number, used_[unit] = names_.make(constant ? "constant" : name, "curve")};
}

std::string Curves::constant() {
  return of({{0.0, 1.0}, {end_, 1.0}}, "constant").curve;
}

std::string Curves::ramp() {
  const Points unit = {{0.0, 0.0}, {1.0, 1.0}};
  const auto known = used_.find(unit);
  return known != used_.end() ? known->second : used_[unit] = names_.make("ramp", "curve");
}

std::string Curves::text() const {
  std::string out;
  for (const auto& [points, name] : used_) {
    std::vector<std::string> items;
    for (const auto& p : points)
      items.push_back(
          translation::list_text({translation::number_text(p[0]), translation::number_text(p[1])}));
    out += "  " + name + ": " + translation::list_text(items) + "\n";
  }
  return out.empty() ? "" : "curves:\n" + out;
}

} // namespace abut::abaqus
