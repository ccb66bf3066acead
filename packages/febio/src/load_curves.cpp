// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "deck_parts.hpp"

#include <algorithm>
#include <cmath>

namespace abut::febio {

namespace {

using Points = std::vector<std::array<double, 2>>;

/// The parabola through points first, first + 1, first + 2.
double parabola(const Points& p, std::size_t first, double t) {
  double value = 0.0;
  for (std::size_t i = first; i < first + 3; ++i) {
    double weight = 1.0;
    for (std::size_t j = first; j < first + 3; ++j)
      if (j != i)
        weight *= (t - p[j][0]) / (p[i][0] - p[j][0]);
    value += weight * p[i][1];
  }
  return value;
}

double linear(const std::array<double, 2>& a, const std::array<double, 2>& b, double t) {
  return a[1] + (b[1] - a[1]) * (t - a[0]) / (b[0] - a[0]);
}

/// Value between the ends of the curve.
double inside(const LoadCurve& curve, double t) {
  const Points& p = curve.points;
  const auto upper = std::lower_bound(p.begin() + 1, p.end() - 1, t,
                                      [](const auto& a, double x) { return a[0] < x; });
  const std::size_t i = static_cast<std::size_t>(upper - p.begin()) - 1; // t in (t_i, t_i+1]
  if (t == p[i][0])
    return p[i][1];
  if (curve.interpolation == Interpolation::step)
    return p[i + 1][1];
  if (curve.interpolation == Interpolation::linear || p.size() == 2)
    return linear(p[i], p[i + 1], t);
  if (i == 0)
    return parabola(p, 0, t);
  if (i + 2 == p.size())
    return parabola(p, i - 1, t);
  const double w = (t - p[i][0]) / (p[i + 1][0] - p[i][0]);
  return (1.0 - w) * parabola(p, i - 1, t) + w * parabola(p, i, t);
}

void append(Points& points, double t, double value) {
  if (points.empty() || t > points.back()[0])
    points.push_back({t, value});
}

/// Points of the curve between its own ends, moved by (dt, dv).
void append_cycle(Points& out, const LoadCurve& curve, double jump, double dt, double dv) {
  constexpr int pieces = 16; // of a parabola
  const Points& p = curve.points;
  append(out, p[0][0] + dt + (out.empty() ? 0.0 : jump), p[0][1] + dv);
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    const bool curved = curve.interpolation == Interpolation::smooth && p.size() > 2;
    const int n = curved ? pieces : 1;
    if (curve.interpolation == Interpolation::step && p[i + 1][1] != p[i][1])
      append(out, p[i][0] + dt + 2.0 * jump, p[i + 1][1] + dv);
    for (int k = 1; k <= n; ++k) {
      const double t = k == n ? p[i + 1][0] : p[i][0] + (p[i + 1][0] - p[i][0]) * k / n;
      append(out, t + dt, inside(curve, t) + dv);
    }
  }
}

/// Linear between the points, constant beyond.
double value_at(const Points& p, double t) {
  const auto upper =
      std::lower_bound(p.begin(), p.end(), t, [](const auto& a, double x) { return a[0] < x; });
  if (upper == p.end())
    return p.back()[1];
  return upper == p.begin() || (*upper)[0] == t ? (*upper)[1] : linear(*(upper - 1), *upper, t);
}

void extrapolate(Points& out, double end) {
  const std::size_t n = out.size();
  if (out[n - 1][0] < end)
    append(out, end, linear(out[n - 2], out[n - 1], end));
  if (out[0][0] > 0.0)
    out.insert(out.begin(), {0.0, linear(out[0], out[1], 0.0)});
}

} // namespace

double LoadCurve::operator()(double t) const {
  const auto first = points.front(), last = points.back();
  if (points.size() == 1)
    return first[1];
  const double period = last[0] - first[0];
  if (t >= first[0] && t <= last[0])
    return inside(*this, t);
  switch (extension) {
  case Extension::constant:
    break;
  case Extension::extrapolate:
    return t < first[0] ? linear(points[0], points[1], t)
                        : linear(points[points.size() - 2], last, t);
  case Extension::repeat:
  case Extension::repeat_offset: {
    const double cycles = std::floor((t - first[0]) / period);
    const double offset =
        extension == Extension::repeat_offset ? cycles * (last[1] - first[1]) : 0.0;
    return inside(*this, t - cycles * period) + offset;
  }
  }
  return t < first[0] ? first[1] : last[1];
}

std::vector<std::array<double, 2>> deck_points(const LoadCurve& curve, double end) {
  const double jump = 1e-9 * end;
  const auto first = curve.points.front(), last = curve.points.back();
  if (curve.points.size() == 1)
    return {{0.0, first[1]}, {end, first[1]}};
  Points out;
  append_cycle(out, curve, jump, 0.0, 0.0);
  const double period = last[0] - first[0];
  const bool repeats =
      curve.extension == Extension::repeat || curve.extension == Extension::repeat_offset;
  for (int k = 1; repeats && out.back()[0] < end; ++k)
    append_cycle(out, curve, jump, k * period,
                 curve.extension == Extension::repeat ? 0.0 : k * (last[1] - first[1]));
  if (curve.extension == Extension::extrapolate)
    extrapolate(out, end);
  return out;
}

const LoadCurve& DeckCurves::find(const Value& value) const {
  const auto found = model_.curves.find(value.curve);
  if (found == model_.curves.end())
    throw InputError(model_.where(value.line) + ": there is no load controller " +
                     std::to_string(value.curve));
  const auto& points = found->second.points;
  const double period = points.back()[0] - points.front()[0];
  constexpr double most_cycles = 1e4;
  if (points.size() > 1 && end_ - points.front()[0] > most_cycles * period)
    throw InputError(model_.where(found->second.line) + ": load curve '" + found->second.name +
                     "' ends long before the model does, which is " + number_text(end_));
  return found->second;
}

std::string DeckCurves::of(const Value& value) {
  const auto known = used_.find(value.curve);
  if (known != used_.end())
    return known->second;
  if (value.curve == 0)
    return used_[0] = names_.make("constant", "constant");
  return used_[value.curve] = names_.make(find(value).name, "curve");
}

Timed DeckCurves::of(const Course& course) {
  if (course.size() == 1)
    return {course[0].number, of(course[0])};
  double common = 0.0; // what all steps share
  std::string name;
  for (std::size_t s = 0; s < course.size(); ++s) {
    const Value& v = course[s];
    if (v.is_zero())
      continue;
    common = common == 0.0 || common == v.number ? v.number : 1.0;
    name += (name.empty() ? "" : "_") + (v.curve == 0 ? "constant" : find(v).name) + "_in_step_" +
            std::to_string(s + 1);
  }
  if (common == 0.0)
    return {0.0, of(Value{})};
  Pieces pieces;
  for (const Value& v : course)
    pieces.push_back(v.is_zero() ? std::pair(0.0, 0) : std::pair(v.number / common, v.curve));
  if (std::all_of(pieces.begin(), pieces.end(), [&](const auto& p) { return p == pieces[0]; }))
    return {common, of(Value{common, pieces[0].second, course[0].line})};
  const auto known = composed_.find(pieces);
  if (known != composed_.end())
    return {common, known->second};
  return {common, composed_[pieces] = names_.make(name, "curve")};
}

std::vector<std::array<double, 2>> DeckCurves::points(int id) const {
  if (id == 0)
    return {{0.0, 1.0}, {end_, 1.0}};
  return deck_points(model_.curves.at(id), end_);
}

std::vector<std::array<double, 2>> DeckCurves::points(const Pieces& pieces) const {
  const double jump = 1e-9 * end_;
  Points out;
  for (std::size_t s = 0; s < pieces.size(); ++s) {
    const double start = model_.start(s), stop = model_.start(s + 1), factor = pieces[s].first;
    const Points base = points(pieces[s].second);
    const double first = factor * value_at(base, start);
    if (out.empty())
      out.push_back({start, first});
    else if (first != out.back()[1])
      append(out, start + jump, first);
    for (const auto& p : base)
      if (p[0] > start && p[0] < stop)
        append(out, p[0], factor * p[1]);
    append(out, stop, factor * value_at(base, stop));
  }
  return out;
}

std::string DeckCurves::text() const {
  std::string out;
  const auto add = [&](const std::string& name, const Points& points) {
    std::vector<std::string> items;
    for (const auto& p : points)
      items.push_back(list_text({number_text(p[0]), number_text(p[1])}));
    out += "  " + name + ": " + list_text(items) + "\n";
  };
  for (const auto& [id, name] : used_)
    add(name, points(id));
  for (const auto& [pieces, name] : composed_)
    add(name, points(pieces));
  return out.empty() ? "" : "curves:\n" + out;
}

} // namespace abut::febio
