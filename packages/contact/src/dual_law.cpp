// SPDX-License-Identifier: BSD-3-Clause
#include "dual_law.hpp"

#include "abut/contact/dual_weights.hpp"
#include "constants.hpp"
#include "prediction.hpp"

#include <algorithm>
#include <cmath>

namespace abut::contact {

namespace {

/// Components of the nodal sums.
enum Mean {
  area,
  gap,
  penalty,
  normal,
  slip = normal + 3,
  carried = slip + 3,
  means = carried + 3
};

Vec3 vector_at(const double* sums) {
  return {{sums[0], sums[1], sums[2]}};
}

} // namespace

DualLaw::DualLaw(const Comm& comm, const mesh::Surface& surface, const CornerSpace& corners,
                 std::vector<Local> first_point, const std::vector<std::array<double, 2>>& xi,
                 std::vector<double> area, const std::vector<double>& size,
                 const std::vector<double>& soft, bool friction)
    : comm_(comm), surface_(surface), space_(corners), first_point_(std::move(first_point)),
      area_(std::move(area)), nodes_(surface.node.size()), friction_(friction) {
  corner_.assign(area_.size() * max_corners, 0.0);
  dual_ = corner_;
  std::vector<double> sums(3 * nodes_.size(), 0.0);
  for (Local f = 0; f < surface.num_faces(); ++f) {
    const int n = space_.corners(f);
    const Local first = first_point_[f], points = first_point_[f + 1] - first;
    std::vector<double> N(std::size_t(points * n));
    for (Local q = 0; q < points; ++q)
      space_.values(f, xi[std::size_t(first + q)].data(), &N[std::size_t(q * n)]);
    double C[max_corners * max_corners];
    dual_coefficients(n, points, N.data(), &area_[first], C);
    for (Local q = 0; q < points; ++q)
      for (int a = 0; a < n; ++a) {
        const std::size_t i = std::size_t(first + q) * max_corners + std::size_t(a);
        corner_[i] = N[std::size_t(q * n + a)];
        for (int b = 0; b < n; ++b)
          dual_[i] += C[a * n + b] * N[std::size_t(q * n + b)];
        double* sum = &sums[3 * std::size_t(corner_nodes(f)[a])];
        sum[0] += area_[first + q] * corner_[i];
        sum[1] += area_[first + q] * corner_[i] * size[f];
        sum[2] += area_[first + q] * corner_[i] * soft[f];
      }
  }
  space_.sum(sums, 3);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double* sum = &sums[3 * i];
    nodes_[i].full = sum[0];
    nodes_[i].size = sum[0] > 0.0 ? sum[1] / sum[0] : 0.0;
    nodes_[i].soft = sum[0] > 0.0 ? sum[2] / sum[0] : 0.0;
  }
  psi_ = field_ = corner_;
  take_.assign(size.size() * max_corners * max_corners, 0.0);
  if (friction_)
    carried_.resize(area_.size() * max_corners);
  carried_converged_ = carried_;
}

/// The functions of this configuration, from which points have a partner.
void DualLaw::cover(const std::vector<DualPoint>& points) {
  std::vector<double> covered(nodes_.size(), 0.0);
  for (Local f = 0; f < surface_.num_faces(); ++f)
    for (Local q = first_point_[f]; q < first_point_[f + 1]; ++q)
      for (int a = 0; points[q].covered && a < corners(f); ++a)
        covered[corner_nodes(f)[a]] += area_[q] * corner_[std::size_t(q) * max_corners + a];
  space_.sum(covered);
  std::vector<char> merged(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    nodes_[i].covered = covered[i];
    merged[i] =
        covered[i] < sliver * nodes_[i].full || (!prescribed_.empty() && prescribed_[i] != 0);
  }
  for (Local f = 0; f < surface_.num_faces(); ++f) {
    double take[max_corners][max_corners] = {};
    for (int a = 0; a < corners(f); ++a) {
      take[a][a] = 1.0;
      space_.hand_on(f, merged, take[a]);
    }
    std::copy_n(&take[0][0], max_corners * max_corners,
                &take_[std::size_t(f) * max_corners * max_corners]);
    const Local first = first_point_[f], end = first_point_[f + 1];
    const bool whole = std::all_of(points.begin() + first, points.begin() + end,
                                   [](const DualPoint& p) { return p.covered; });
    const std::vector<double>& base = whole ? dual_ : corner_;
    for (Local q = first; q < end; ++q)
      for (int b = 0; b < corners(f); ++b) {
        const std::size_t i = std::size_t(q) * max_corners;
        psi_[i + b] = field_[i + b] = 0.0;
        for (int a = 0; a < corners(f); ++a) {
          psi_[i + b] += take[a][b] * base[i + a];
          field_[i + b] += take[a][b] * corner_[i + a];
        }
      }
  }
}

void DualLaw::gather(const std::vector<DualPoint>& points) {
  cover(points);
  const int width = friction_ ? means : int(normal) + 3;
  std::vector<double> sums(nodes_.size() * std::size_t(width), 0.0);
  for (Local f = 0; f < surface_.num_faces(); ++f)
    for (Local q = first_point_[f]; q < first_point_[f + 1]; ++q) {
      const DualPoint& p = points[q];
      for (int a = 0; p.covered && a < corners(f); ++a) {
        double* sum = &sums[std::size_t(corner_nodes(f)[a] * width)];
        const double weight = area_[q] * psi(q)[a];
        sum[Mean::area] += weight;
        sum[Mean::gap] += weight * p.gap;
        // Positive weights: the penalty of a face that meets several must not turn negative.
        sum[Mean::penalty] += area_[q] * field(q)[a] * p.penalty;
        for (int i = 0; i < 3; ++i)
          sum[Mean::normal + i] += weight * p.normal[i];
        for (int i = 0; friction_ && i < 3; ++i) {
          sum[Mean::slip + i] += weight * p.slip[i];
          sum[Mean::carried + i] += weight * p.carried[std::size_t(a)][i];
        }
      }
    }
  space_.sum(sums, width);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    DualNode& node = nodes_[i];
    const double* sum = &sums[i * std::size_t(width)];
    node.area = sum[Mean::area];
    if (!(node.area > 0.0)) {
      node.area = node.gap = node.penalty = 0.0;
      continue;
    }
    node.gap = sum[Mean::gap] / node.area;
    node.penalty = sum[Mean::penalty] / node.area;
    const Vec3 m = vector_at(sum + Mean::normal);
    node.normal_sum = norm(m);
    node.normal = node.normal_sum > 0.0 ? (1.0 / node.normal_sum) * m : Vec3::zero();
    if (friction_) {
      node.slip = (1.0 / node.area) * vector_at(sum + Mean::slip);
      node.carried = (1.0 / node.area) * vector_at(sum + Mean::carried);
    }
  }
}

void DualLaw::start() {
  is_new_ = false;
  for (DualNode& n : nodes_) {
    n.history.gap = n.gap;
    n.history.in_contact = n.area > 0.0 && n.gap <= touching_gap * n.size;
    n.converged = n.history;
  }
}

void DualLaw::decide(double friction, bool frozen, bool predicting) {
  for (DualNode& n : nodes_)
    decide(n, friction, frozen, predicting);
}

void DualLaw::decide(DualNode& n, double friction, bool frozen, bool predicting) const {
  const PointRule before = n.rule;
  n.rule = PointRule::open;
  n.touching = false;
  n.settled = true;
  n.pressure = 0.0;
  n.traction = Vec3::zero();
  if (n.area == 0.0 || (frozen && before == PointRule::open) ||
      (predicting && stays_open(n.converged, n.size)))
    return;
  const double pressure = n.history.multiplier - n.penalty * n.gap;
  if (pressure <= -n.penalty * touching_gap * n.size)
    return;
  n.touching = pressure <= 0.0;
  n.pressure = std::max(pressure, 0.0);
  n.rule = PointRule::frictionless;
  if (friction == 0.0)
    return;
  ContactPoint c;
  c.first = !n.converged.in_contact;
  c.previous_gap = n.converged.gap;
  c.multiplier = n.history.multiplier;
  c.penalty = n.penalty;
  n.share = contact_share(c, n.gap);
  n.share_slope = contact_share_slope(c, n.gap);
  const Vec3 z = n.carried - (n.penalty * n.share) * n.slip;
  n.out_of_plane = dot(n.normal, z);
  n.trial = z - n.out_of_plane * n.normal;
  n.rule = PointRule::incremental_stick;
  if (n.touching)
    return;
  const bool held =
      frozen && (before == PointRule::incremental_stick || before == PointRule::incremental_slip);
  const double share = n.soft > 0.0 ? std::min(1.0, n.soft / n.penalty) : 1.0;
  const ShearChoice choice =
      choose_shear(n.last, n.trial, n.normal, friction * n.pressure, share,
                   held ? std::optional(before == PointRule::incremental_slip) : std::nullopt);
  n.rule = choice.slips ? PointRule::incremental_slip : PointRule::incremental_stick;
  n.line = choice.line;
  n.traction = choice.traction;
  n.settled = choice.settled;
}

void DualLaw::keep_iterate() {
  for (DualNode& n : nodes_) {
    n.last = {n.pressed(), n.rule == PointRule::incremental_slip, n.line};
  }
}

bool DualLaw::settled() const {
  return std::none_of(nodes_.begin(), nodes_.end(),
                      [](const DualNode& n) { return n.pressed() && !n.settled; });
}

} // namespace abut::contact
