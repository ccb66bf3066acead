// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "point_cases.hpp"

#include <utility>

/// One contact point between faces whose nodes hang on springs: status, Newton, history, as an
/// interaction does it for many.
namespace abut::contact::testing {

enum class Map { inclined, incremental, literal };

class PointOnSprings {
public:
  Case s;
  Map map = Map::incremental;
  bool anchored = false;
  Nodes target_x, target_y;
  Vec3 spring{{5.0, 5.0, 500.0}};
  bool free_secondary = false;
  std::vector<double> history; ///< relative residuals of the last solve
  std::vector<PointRule> rules;

  /// Flat faces at an angle phi about y, penetrating by depth at the point; unit area.
  static PointOnSprings planes(double phi, Map map, bool ray, double friction = 0.5,
                               double penalty = 50.0, double depth = 0.1) {
    PointOnSprings p;
    Case& s = p.s;
    p.map = map;
    s.c.ray = ray;
    s.set_primary_point(FaceType::quad4, 0.0, 0.0);
    s.c.face = s.c.anchor_face = FaceType::quad4;
    s.x = reference_nodes(FaceType::quad4, 1.0);
    s.y = reference_nodes(FaceType::quad4, 3.0);
    for (Vec3& v : s.y)
      v = {{v[0], -v[1], -depth + std::tan(phi) * v[0]}};
    s.x_previous = p.target_x = s.x;
    s.y_previous = p.target_y = s.y;
    s.c.weight = 1.0;
    s.c.penalty = penalty;
    s.c.friction = friction;
    p.move_anchor_to_ray();
    return p;
  }

  void move_anchor_to_ray() {
    if (map == Map::incremental)
      return;
    s.c.rule = PointRule::frictionless;
    EXPECT_TRUE(s.find());
    s.c.anchor_xi[0] = s.c.xi[0];
    s.c.anchor_xi[1] = s.c.xi[1];
    anchored = true;
  }

  /// Stick as long as the trial lies in the cone and presses, slip outside it, open in tension.
  PointRule decide() {
    const auto p = s.primary();
    if (anchored && map != Map::incremental) {
      const ContactPoint c = s.point();
      const Vec3 trial = anchored_trial(c, p, s.y.data());
      const double pressure = -dot(p.normal, trial);
      const double shear = norm(trial + pressure * p.normal);
      if (pressure > 0.0 && shear <= c.friction * pressure)
        return set(PointRule::anchored);
      if (map == Map::inclined && shear > 0.0)
        return set(PointRule::inclined_slip);
      return set(PointRule::literal_slip);
    }
    set(PointRule::incremental_stick);
    if (s.c.rule == PointRule::open)
      return s.c.rule;
    const auto partner = contact_partner(s.point(), p, s.y.data());
    const double pressure = s.c.multiplier - s.c.penalty * (partner.gap - s.c.offset);
    const double shear = norm(incremental_trial(s.point(), p, partner));
    return shear <= s.c.friction * pressure ? s.c.rule : set(PointRule::incremental_slip);
  }

  /// The rule, or open when it would pull; the partner with it.
  PointRule set(PointRule rule) {
    s.c.rule = rule;
    if (!s.find() || !(s.traction().pressure > 0.0))
      s.c.rule = PointRule::open;
    return s.c.rule;
  }

  int size() const { return 3 * (s.n1 + (free_secondary ? s.n2() : 0)); }
  double& dof(Nodes& x, Nodes& y, int i) const {
    return i < 3 * s.n1 ? x[std::size_t(i / 3)][i % 3] : y[std::size_t(i / 3 - s.n1)][i % 3];
  }

  /// Newton from the present positions; iterations, or -1.
  int solve(double tolerance = 1e-11, int most = 40) {
    history.clear();
    rules.clear();
    const int n = size();
    for (int iteration = 0; iteration < most; ++iteration) {
      rules.push_back(decide());
      std::vector<double> r(std::size_t(3 * (s.n1 + s.n2())), 0.0), k;
      if (s.c.rule != PointRule::open) {
        r = s.force();
        k = s.tangent();
      }
      double error = 0.0, load = 0.0;
      for (int i = 0; i < n; ++i) {
        load += r[std::size_t(i)] * r[std::size_t(i)];
        r[std::size_t(i)] += spring[i % 3] * (dof(s.x, s.y, i) - dof(target_x, target_y, i));
        error += r[std::size_t(i)] * r[std::size_t(i)];
      }
      history.push_back(std::sqrt(error) / (std::sqrt(load) + 1.0));
      if (history.back() < tolerance)
        return iteration;
      const int width = 3 * s.columns();
      std::vector<std::vector<double>> a(std::size_t(n), std::vector<double>(std::size_t(n + 1)));
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j)
          a[std::size_t(i)][std::size_t(j)] =
              (k.empty() ? 0.0 : k[std::size_t(i * width + j)]) + (i == j ? spring[i % 3] : 0.0);
        a[std::size_t(i)][std::size_t(n)] = r[std::size_t(i)];
      }
      eliminate(a);
      for (int i = 0; i < n; ++i)
        dof(s.x, s.y, i) -= a[std::size_t(i)][std::size_t(n)];
    }
    return -1;
  }

  Vec3 shear() const {
    const auto t = s.traction();
    return t.traction - t.pressure * normal();
  }
  Vec3 normal() const {
    if (s.c.ray || s.c.rule == PointRule::anchored)
      return -s.primary().normal;
    return contact_partner(s.point(), s.primary(), s.y.data()).c;
  }

  void augment() {
    const double pressure = s.traction().pressure;
    s.c.carried = store_traction(s.primary(), shear());
    s.c.multiplier = pressure;
  }

  void end_step() {
    const PointRule rule = s.c.rule;
    if (rule == PointRule::open) {
      s.c.rule = PointRule::incremental_stick;
      s.find();
      s.c.previous_gap = contact_partner(s.point(), s.primary(), s.y.data()).gap - s.c.offset;
      s.c.rule = rule;
      s.c.carried = {};
      anchored = false;
    } else if (rule != PointRule::anchored) {
      if (rule == PointRule::incremental_stick || rule == PointRule::incremental_slip)
        s.c.carried = store_traction(s.primary(), shear());
      s.c.anchor_xi[0] = s.c.xi[0];
      s.c.anchor_xi[1] = s.c.xi[1];
      anchored = true;
    }
    s.c.first = rule == PointRule::open;
    s.x_previous = s.x;
    s.y_previous = s.y;
  }

private:
  static void eliminate(std::vector<std::vector<double>>& a) {
    const std::size_t n = a.size();
    for (std::size_t c = 0; c < n; ++c) {
      std::size_t best = c;
      for (std::size_t r = c + 1; r < n; ++r)
        if (std::fabs(a[r][c]) > std::fabs(a[best][c]))
          best = r;
      std::swap(a[c], a[best]);
      for (std::size_t r = 0; r < n; ++r) {
        if (r == c)
          continue;
        const double f = a[r][c] / a[c][c];
        for (std::size_t j = c; j <= n; ++j)
          a[r][j] -= f * a[c][j];
      }
    }
    for (std::size_t c = 0; c < n; ++c)
      a[c][n] /= a[c][c];
  }
};

} // namespace abut::contact::testing
