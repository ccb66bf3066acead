// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/options.hpp"
#include "abut/contact/point_force.hpp"
#include "abut/fem/quadrature.hpp"
#include "abut/mesh/surface.hpp"
#include "spaces/dual_weights.hpp"
#include "spaces/nodal_arrays.hpp"

#include <algorithm>
#include <array>
#include <vector>

/// The nodal law of docs/theory/multipliers.md written down a second time, as a function of the
/// displacements on any scalar: search by brute force, means, laws and forces in one go, so that
/// automatic differentiation goes through all of it. One rank.
namespace abut::contact::testing {

class DualReference {
public:
  /// options.penalty is the penalty; no offset. Surfaces must outlive the object.
  DualReference(const mesh::Surface& primary, const mesh::Surface& secondary,
                const ContactOptions& options);

  /// (mesh nodes, 3) from displacements (mesh nodes, 3).
  template <class T> std::vector<T> residual(const std::vector<T>& u);
  /// The state of the last residual becomes multiplier, or the converged one at displacements u.
  void augment(const std::vector<double>& u);
  void accept(const std::vector<double>& u);

  enum Count { uncovered, open, frictionless, stick, slip, merged, counts };
  /// Nodes in each state at the last residual.
  int count(Count which) const { return count_[which]; }

private:
  static constexpr int corners_at_most = max_corners;
  using Weights = std::array<double, corners_at_most>;
  struct Table {
    std::vector<double> N, dN;
  };
  struct Point {
    Local face;
    std::size_t in_face;               ///< number on the face
    double weight, area;               ///< of the quadrature, times the reference area
    Weights N{}, dual{}, psi{}, hat{}; ///< the latter two: of this configuration
    std::array<StoredTraction, corners_at_most> carried;
    Local facing = -1;
    double xi[2];
  };
  struct Node {
    double multiplier = 0.0, previous_gap = 0.0, full = 0.0, gap = 0.0, pressure = 0.0;
    Vec3 shear = Vec3::zero();
    bool in_contact = false, active = false;
  };
  template <class T> struct Means {
    double area = 0.0;
    T gap = 0.0, pressure = 0.0;
    Vec<T, 3> normal = Vec<T, 3>::zero(), slip = normal, carried = normal, shear = normal;
  };

  template <class T>
  static std::vector<Vec<T, 3>> nodes(const mesh::Surface& s, Local f, const std::vector<T>& u);
  PointShape shape(const Point& p) const;
  void make_functions(Local face);
  void find(Point& p, const std::vector<double>& u) const;
  void cover(const std::vector<double>& u);
  template <class T> void law(Node& node, Means<T>& m);
  template <class T>
  ContactPoint contact_point(const Point& p, const std::vector<Vec3>& x, const std::vector<Vec3>& y,
                             PrimaryPoint<T>& at, ContactPartner<T>& partner,
                             const std::vector<T>& u) const;

  const mesh::Surface &primary_, &secondary_;
  ContactOptions options_;
  bool started_ = false;
  std::vector<Table> tables_; ///< (primary faces)
  std::vector<std::vector<Point>> points_;
  std::vector<Node> nodes_;
  std::vector<double> previous_;
  int count_[counts] = {};
};

inline DualReference::DualReference(const mesh::Surface& primary, const mesh::Surface& secondary,
                                    const ContactOptions& options)
    : primary_(primary), secondary_(secondary), options_(options),
      nodes_(std::size_t(primary.num_nodes())) {
  const std::vector<double> rest(3 * std::size_t(primary.num_nodes() + secondary.num_nodes()), 0.0);
  for (Local f = 0; f < primary.num_faces(); ++f) {
    const fem::FaceType type = primary.type[f];
    const auto rule = options.formulation == Formulation::node_on_facet
                          ? fem::nodal_rule(type)
                          : fem::face_rule(type, fem::default_points(type));
    tables_.emplace_back();
    points_.emplace_back();
    for (int q = 0; q < rule.size(); ++q) {
      Point p{f, std::size_t(q), rule.weight[q], 0.0, {}, {}, {}, {}, {}, -1, {0.0, 0.0}};
      double N[fem::max_face_nodes], dN[fem::max_face_nodes][2];
      fem::dispatch_face(type, [&](auto s) {
        decltype(s)::values(rule.xi[q].data(), N);
        decltype(s)::derivatives(rule.xi[q].data(), dN);
      });
      const int n = fem::face_nodes(type);
      tables_.back().N.insert(tables_.back().N.end(), N, N + n);
      tables_.back().dN.insert(tables_.back().dN.end(), dN[0], dN[0] + 2 * n);
      fem::dispatch_face(fem::is_triangle(type) ? fem::FaceType::tri3 : fem::FaceType::quad4,
                         [&](auto s) { decltype(s)::values(rule.xi[q].data(), p.N.data()); });
      points_.back().push_back(p);
    }
    for (Point& p : points_.back())
      p.area = p.weight * primary_point(shape(p), nodes(primary, f, rest).data()).area;
    make_functions(f);
  }
}

inline void DualReference::make_functions(Local face) {
  const int n = fem::face_corners(primary_.type[face]);
  std::vector<Point>& points = points_[std::size_t(face)];
  std::vector<double> N, w, C(std::size_t(n * n));
  for (const Point& p : points) {
    N.insert(N.end(), p.N.begin(), p.N.begin() + n);
    w.push_back(p.area);
  }
  dual_coefficients(n, int(points.size()), N.data(), w.data(), C.data());
  for (Point& p : points)
    for (int a = 0; a < n; ++a) {
      for (int b = 0; b < n; ++b)
        p.dual[std::size_t(a)] += C[std::size_t(a * n + b)] * p.N[std::size_t(b)];
      nodes_[std::size_t(primary_.nodes[primary_.offset[face] + a])].full +=
          p.area * p.N[std::size_t(a)];
    }
}

template <class T>
std::vector<Vec<T, 3>> DualReference::nodes(const mesh::Surface& s, Local f,
                                            const std::vector<T>& u) {
  std::vector<Vec<T, 3>> x;
  for (Local a = s.offset[f]; a < s.offset[f + 1]; ++a) {
    const auto n = std::size_t(s.nodes[a]);
    x.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      x.back()[int(i)] = s.x[3 * n + i] + u[3 * std::size_t(s.node[n]) + i];
  }
  return x;
}

inline PointShape DualReference::shape(const Point& p) const {
  const int n = fem::face_nodes(primary_.type[p.face]);
  const Table& t = tables_[std::size_t(p.face)];
  return {n, &t.N[p.in_face * std::size_t(n)],
          reinterpret_cast<const double(*)[2]>(&t.dN[p.in_face * std::size_t(2 * n)])};
}

/// The nearest face that the point projects on, or one that it lies just beside.
inline void DualReference::find(Point& p, const std::vector<double>& u) const {
  const auto at = primary_point(shape(p), nodes(primary_, p.face, u).data());
  double best[2] = {1e300, 1e300}; // inside, beside
  p.facing = -1;
  for (Local f = 0; f < secondary_.num_faces(); ++f) {
    const auto y = nodes(secondary_, f, u);
    const fem::FaceType type = secondary_.type[f];
    double xi[2];
    fem::dispatch_face(type, [&](auto s) { decltype(s)::center(xi); });
    double distance;
    if ((options_.formulation == Formulation::sliding_elastic)) {
      const auto hit = search::intersect(type, y.data(), at.x, -at.normal, xi);
      if (!hit.converged)
        continue;
      std::copy_n(hit.xi, 2, xi);
    } else {
      const auto found = search::project(type, y.data(), at.x, xi);
      if (!found.converged)
        continue;
      std::copy_n(found.xi, 2, xi);
    }
    fem::FacePoint<double> on;
    fem::face_point(type, y.data(), xi, on);
    distance = norm(on.x - at.x);
    const double side = fem::is_triangle(type) ? 1.0 : 2.0;
    const auto within = [&](double margin) {
      return fem::dispatch_face(type,
                                [&](auto s) { return decltype(s)::inside(xi, margin * side); });
    };
    if (!within(options_.projection_margin))
      continue;
    const int beside = within(1e-9) ? 0 : 1;
    if (distance >= best[beside] || (beside == 1 && best[0] < 1e300))
      continue;
    best[beside] = distance;
    p.facing = f;
    std::copy_n(xi, 2, p.xi);
  }
}

/// psi and N of this configuration.
inline void DualReference::cover(const std::vector<double>& u) {
  std::vector<double> covered(nodes_.size(), 0.0);
  const auto corner = [&](Local f, int a) {
    return std::size_t(primary_.nodes[primary_.offset[f] + a]);
  };
  for (auto& face : points_)
    for (Point& p : face) {
      find(p, u);
      for (int a = 0; p.facing >= 0 && a < fem::face_corners(primary_.type[p.face]); ++a)
        covered[corner(p.face, a)] += p.area * p.N[std::size_t(a)];
    }
  for (auto& face : points_) {
    const Local f = face.front().face;
    const int n = fem::face_corners(primary_.type[f]);
    const bool whole =
        std::all_of(face.begin(), face.end(), [](const Point& p) { return p.facing >= 0; });
    std::vector<int> stay, go;
    for (int a = 0; a < n; ++a) {
      const std::size_t i = corner(f, a);
      (covered[i] < 0.2 * nodes_[i].full ? go : stay).push_back(a);
    }
    for (Point& p : face) {
      p.psi = whole ? p.dual : p.N;
      p.hat = p.N;
      for (Weights* w : {&p.psi, &p.hat})
        for (int a : go) {
          for (int b : stay)
            (*w)[std::size_t(b)] += (*w)[std::size_t(a)] / double(stay.size());
          if (!stay.empty())
            (*w)[std::size_t(a)] = 0.0;
        }
    }
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    count_[merged] += covered[i] > 0.0 && covered[i] < 0.2 * nodes_[i].full;
}

template <class T>
ContactPoint DualReference::contact_point(const Point& p, const std::vector<Vec3>& x,
                                          const std::vector<Vec3>& y, PrimaryPoint<T>& at,
                                          ContactPartner<T>& partner,
                                          const std::vector<T>& u) const {
  ContactPoint c;
  c.ray = (options_.formulation == Formulation::sliding_elastic);
  c.shape = shape(p);
  c.face = secondary_.type[p.facing];
  std::copy_n(p.xi, 2, c.xi);
  c.x_previous = x.data();
  c.y_previous = y.data();
  at = primary_point(c.shape, nodes(primary_, p.face, u).data());
  partner = contact_partner(c, at, nodes(secondary_, p.facing, u).data());
  return c;
}

template <class T> void DualReference::law(Node& node, Means<T>& m) {
  node.active = false;
  if (m.area == 0.0) {
    ++count_[uncovered];
    return;
  }
  m.gap /= m.area;
  m.slip = T(1.0 / m.area) * m.slip;
  m.carried = T(1.0 / m.area) * m.carried;
  m.normal = T(T(1.0) / norm(m.normal)) * m.normal;
  node.gap = value_of(m.gap);
  if (!started_) {
    node.previous_gap = node.gap;
    node.in_contact = node.gap <= 0.0;
  }
  m.pressure = node.multiplier - *options_.penalty * m.gap;
  if (value_of(m.pressure) <= 0.0) {
    m.pressure = 0.0;
    ++count_[open];
    return;
  }
  node.active = true;
  if (options_.friction == 0.0) {
    ++count_[frictionless];
    return;
  }
  ContactPoint c;
  c.first = !node.in_contact;
  c.previous_gap = node.previous_gap;
  c.multiplier = node.multiplier;
  c.penalty = *options_.penalty;
  const T stiffness = c.penalty * contact_share(c, m.gap);
  const Vec<T, 3> z = m.carried - stiffness * m.slip;
  m.shear = z - T(dot(m.normal, z)) * m.normal;
  const T size = norm(m.shear), limit = options_.friction * m.pressure;
  const bool slips = value_of(size) > value_of(limit);
  if (slips)
    m.shear = T(limit / size) * m.shear;
  ++count_[slips ? slip : stick];
}

template <class T> std::vector<T> DualReference::residual(const std::vector<T>& u) {
  std::vector<double> value;
  for (const T& v : u)
    value.push_back(value_of(v));
  if (!started_)
    previous_ = value;
  std::fill_n(count_, counts, 0);
  cover(value);
  std::vector<Means<T>> means(nodes_.size());
  const auto each = [&](const auto& visit) {
    for (auto& face : points_)
      for (Point& p : face) {
        if (p.facing < 0)
          continue;
        const auto x = nodes(primary_, p.face, previous_),
                   y = nodes(secondary_, p.facing, previous_);
        PrimaryPoint<T> at;
        ContactPartner<T> partner;
        const ContactPoint c = contact_point(p, x, y, at, partner, u);
        visit(p, c, at, partner);
      }
  };
  const auto node = [&](const Point& p, int a) {
    return std::size_t(primary_.nodes[primary_.offset[p.face] + a]);
  };
  each([&](const Point& p, const ContactPoint& c, const auto& at, const auto& partner) {
    const Vec<T, 3> slip = objective_slip(c, partner);
    for (int a = 0; a < fem::face_corners(primary_.type[p.face]); ++a) {
      const bool hat = options_.weighted_gap == WeightedGap::hat;
      const double w = p.area * (hat ? p.hat : p.psi)[std::size_t(a)];
      Means<T>& m = means[node(p, a)];
      m.area += w;
      m.gap += w * partner.gap;
      m.normal += T(w) * partner.c;
      m.slip += T(w) * slip;
      m.carried += T(w) * turned_traction(p.carried[std::size_t(a)], at);
    }
  });
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    law(nodes_[i], means[i]);
    nodes_[i].pressure = value_of(means[i].pressure);
    for (int k = 0; k < 3; ++k)
      nodes_[i].shear[k] = value_of(means[i].shear[k]);
  }
  started_ = true;
  std::vector<T> r(u.size(), T(0.0));
  each([&](const Point& p, const ContactPoint& c, const auto& at, const auto& partner) {
    T pressure = 0.0;
    Vec<T, 3> shear = Vec<T, 3>::zero();
    for (int a = 0; a < fem::face_corners(primary_.type[p.face]); ++a) {
      pressure += p.psi[std::size_t(a)] * means[node(p, a)].pressure;
      shear += T(p.psi[std::size_t(a)]) * means[node(p, a)].shear;
    }
    const T weight = c.ray ? T(p.weight * at.area) : T(p.area);
    const Vec<T, 3> force = weight * Vec<T, 3>(pressure * partner.c + shear);
    for (int i = 0; i < 3; ++i) {
      for (int b = 0; b < c.shape.nodes; ++b) {
        const Local n = primary_.nodes[primary_.offset[p.face] + b];
        r[std::size_t(3 * primary_.node[n] + i)] -= c.shape.N[b] * force[i];
      }
      for (int b = 0; b < fem::face_nodes(c.face); ++b) {
        const Local n = secondary_.nodes[secondary_.offset[p.facing] + b];
        r[std::size_t(3 * secondary_.node[n] + i)] += partner.at.N[b] * force[i];
      }
    }
  });
  return r;
}

inline void DualReference::augment(const std::vector<double>& u) {
  for (Node& n : nodes_)
    n.multiplier = n.pressure;
  for (auto& face : points_)
    for (Point& p : face) {
      const auto at = primary_point(shape(p), nodes(primary_, p.face, u).data());
      for (int a = 0; a < fem::face_corners(primary_.type[p.face]); ++a)
        p.carried[std::size_t(a)] = store_traction(
            at, nodes_[std::size_t(primary_.nodes[primary_.offset[p.face] + a])].shear);
    }
}

inline void DualReference::accept(const std::vector<double>& u) {
  augment(u); // of augmented Lagrangian
  for (Node& n : nodes_) {
    n.previous_gap = n.gap;
    n.in_contact = n.active;
  }
  previous_ = u;
}

} // namespace abut::contact::testing
