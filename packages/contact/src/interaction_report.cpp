// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/interaction.hpp"

#include "abut/fem/face_map.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace abut::contact {

namespace {
constexpr double plateau_ratio = 0.98; ///< an augmentation that leaves more of the gap than this...
constexpr std::size_t plateau_count = 3; ///< ...so many times in a row changes nothing any more
} // namespace

Augmentation Interaction::augmentation() const {
  double sums[2] = {0.0, 0.0};
  double gap = 0.0;
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p) {
      const Local i = point_index(f, p);
      const PointState& state = points_[i];
      const double change = state.pressure - state.multiplier;
      sums[0] += weight_[i] * change * change;
      sums[1] += weight_[i] * state.pressure * state.pressure;
      if (state.facing >= 0)
        gap = std::max(gap, -state.gap / size_[f]);
    }
  comm_.sum(sums, 2);
  Augmentation result;
  result.gap = comm_.max(gap);
  result.change = sums[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) : sums[0] > 0.0 ? 1.0 : 0.0;
  result.converged = result.change <= options_.multiplier_tolerance &&
                     (options_.gap_tolerance == 0.0 || result.gap <= options_.gap_tolerance);
  result.stalled = !result.converged && last_gaps_.size() >= plateau_count;
  double later = result.gap;
  for (std::size_t k = 0; result.stalled && k < plateau_count; ++k) {
    const double earlier = last_gaps_[last_gaps_.size() - 1 - k];
    result.stalled = later > plateau_ratio * earlier;
    later = earlier;
  }
  return result;
}

void Interaction::augment() {
  last_gaps_.push_back(augmentation().gap);
  for (PointState& p : points_)
    p.multiplier = p.pressure; // pressure is <lambda - eps gap>
}

double Interaction::current_area_ratio(Local face, int point) const {
  Vec3 x[fem::max_face_nodes];
  primary_coordinates(face, false, x);
  fem::FacePoint<double> now;
  fem::face_point(primary_.type[face], x, rule(face).xi[point].data(), now);
  return norm(cross(now.tangent[0], now.tangent[1])) * rule(face).weight[point] /
         weight_[point_index(face, point)];
}

/// Averages weighted with the corner functions, which stay positive on quadratic faces; a middle
/// node takes the functions of the corners it stands between.
NodalSums Interaction::nodal_sums() const {
  const auto n = static_cast<std::size_t>(primary_.num_nodes());
  NodalSums s;
  s.weight.assign(n, 0.0);
  s.pressure = s.gap = s.status = s.weight;
  s.traction.assign(3 * n, 0.0);
  for (Local f = 0; f < primary_.num_faces(); ++f) {
    const fem::FaceType type = primary_.type[f];
    const int corners = fem::face_corners(type), nodes = fem::face_nodes(type);
    for (int p = 0; p < face_points(f); ++p) {
      const PointState& state = points_[point_index(f, p)];
      const double area = current_area_ratio(f, p) * weight_[point_index(f, p)];
      const double pressure = state.pressure * weight_[point_index(f, p)] / area;
      double N[fem::max_face_nodes];
      fem::dispatch_face(fem::is_triangle(type) ? fem::FaceType::tri3 : fem::FaceType::quad4,
                         [&](auto shape) { decltype(shape)::values(rule(f).xi[p].data(), N); });
      Vec3 normal = Vec3::zero();
      if (pressure > 0.0) {
        Vec3 y[fem::max_face_nodes];
        facing_.coordinates(state.facing, y);
        normal = facet_gap<double>(facing_.type(state.facing), y, frame(f, p).x, state.xi).normal;
      }
      for (int a = 0; a < nodes; ++a) {
        double share = a < corners       ? N[a]
                       : a < 2 * corners ? 0.5 * (N[a - corners] + N[(a - corners + 1) % corners])
                                         : 0.25;
        share *= area;
        const auto node = static_cast<std::size_t>(primary_.nodes[primary_.offset[f] + a]);
        s.weight[node] += share;
        s.pressure[node] += share * pressure;
        s.gap[node] += share * state.gap;
        if (pressure > 0.0)
          s.status[node] += share;
        for (int i = 0; i < 3; ++i)
          s.traction[3 * node + std::size_t(i)] += share * pressure * normal[i];
      }
    }
  }
  return s;
}

namespace {

/// Largest average over the ranks that share nodes: each node is summed on one rank picked by its
/// id.
double largest_average(const Comm& comm, const std::vector<Global>& node,
                       const std::vector<double>& weight, const std::vector<double>& sum) {
  struct Entry {
    Global node;
    double weight, sum;
  };
  std::vector<std::vector<Entry>> send(static_cast<std::size_t>(comm.size()));
  for (std::size_t i = 0; i < node.size(); ++i)
    send[static_cast<std::size_t>(node[i] % comm.size())].push_back({node[i], weight[i], sum[i]});
  std::unordered_map<Global, std::pair<double, double>> total;
  for (const auto& list : comm.exchange(send))
    for (const Entry& e : list) {
      total[e.node].first += e.weight;
      total[e.node].second += e.sum;
    }
  double largest = 0.0;
  for (const auto& [id, t] : total)
    if (t.first > 0.0)
      largest = std::max(largest, t.second / t.first);
  return comm.max(largest);
}

} // namespace

ContactSummary Interaction::summary() const {
  ContactSummary s;
  double sums[4] = {0.0, 0.0, 0.0, 0.0}, largest[4] = {0.0, 0.0, 0.0, -1e300}, least = 1e300;
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p) {
      const Local i = point_index(f, p);
      const PointState& state = points_[i];
      ++s.points;
      if (state.facing < 0)
        continue;
      ++s.paired_points;
      least = std::min(least, state.gap);
      largest[3] = std::max(largest[3], state.gap);
      if (state.pressure <= 0.0)
        continue;
      ++s.active_points;
      Vec3 y[fem::max_face_nodes];
      facing_.coordinates(state.facing, y);
      const auto q = facet_gap<double>(facing_.type(state.facing), y, frame(f, p).x, state.xi);
      for (int k = 0; k < 3; ++k)
        sums[k] += weight_[i] * state.pressure * q.normal[k];
      sums[3] += weight_[i];
      largest[0] = std::max(largest[0], state.pressure / current_area_ratio(f, p));
      largest[1] = std::max(largest[1], -state.gap);
      largest[2] = std::max(largest[2], -state.gap / size_[f]);
    }
  comm_.sum(sums, 4);
  for (std::size_t k = 0; k < 3; ++k)
    s.force[k] = sums[k];
  s.area = sums[3];
  s.active_points = comm_.sum(s.active_points);
  s.points = comm_.sum(s.points);
  s.paired_points = comm_.sum(s.paired_points);
  s.max_point_pressure = comm_.max(largest[0]);
  s.max_penetration = comm_.max(largest[1]);
  s.max_penetration_over_face_size = comm_.max(largest[2]);
  s.max_gap = comm_.max(largest[3]);
  s.min_gap = comm_.min(least);
  const NodalSums nodes = nodal_sums();
  s.max_pressure = largest_average(comm_, primary_.node, nodes.weight, nodes.pressure);
  return s;
}

std::vector<ClosedPoint> Interaction::closed_points() const {
  std::vector<ClosedPoint> result;
  for (const Pair& pair : pair_list_) {
    Vec3 y[fem::max_face_nodes];
    facing_.coordinates(pair.facing, y);
    Global nodes[fem::max_face_nodes];
    facing_.global_nodes(pair.facing, nodes);
    for (Local p : pair.points) {
      const Vec3 x = frame(pair.face, p).x;
      const auto q =
          facet_gap<double>(facing_.type(pair.facing), y, x, points_[point_index(pair.face, p)].xi);
      result.push_back(
          {primary_.nodes[primary_.offset[pair.face]], nodes[0], origin_ + x, q.normal});
    }
  }
  return result;
}

double Interaction::wrong_facing_share() const {
  double near[2] = {0.0, 0.0}; // points near a face of the other surface; those facing its back
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p) {
      const Frame at = frame(f, p);
      double best = size_[f] * size_[f];
      bool wrong = false, found = false;
      facing_.tree().traverse(
          [&](const search::Box<3>& box) { return box.distance2(at.x.v) <= best; },
          [&](Local candidate) {
            Vec3 y[fem::max_face_nodes];
            facing_.coordinates(candidate, y);
            double center[2];
            fem::dispatch_face(facing_.type(candidate),
                               [&](auto s) { decltype(s)::center(center); });
            const auto q = facet_gap<double>(facing_.type(candidate), y, at.x, center);
            if (std::fabs(q.gap) > size_[f])
              return;
            found = true;
            wrong = dot(q.normal, at.normal) > 0.5;
          });
      near[0] += found;
      near[1] += found && wrong;
    }
  comm_.sum(near, 2);
  return near[0] > 0.0 ? near[1] / near[0] : 0.0;
}

} // namespace abut::contact
