// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/configuration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::contact {

using search::Box;

namespace {

constexpr double pattern_pad = 0.5; ///< pairs this close, in face sizes, get room in the matrix
constexpr int summary_levels = 6;   ///< up to 2^6 boxes tell other ranks where this one's faces are

Vec3 lowest_corner(const Comm& comm, const mesh::Surface& a, const mesh::Surface& b) {
  Vec3 corner;
  for (int i = 0; i < 3; ++i) {
    double low = std::numeric_limits<double>::max();
    for (const mesh::Surface* s : {&a, &b})
      for (std::size_t n = 0; n < s->node.size(); ++n)
        low = std::min(low, s->x[3 * n + std::size_t(i)]);
    corner[i] = comm.min(low);
  }
  return corner;
}

mesh::Surface moved(mesh::Surface surface, const Vec3& origin) {
  for (std::size_t k = 0; k < surface.x.size(); ++k)
    surface.x[k] -= origin[static_cast<int>(k % 3)];
  return surface;
}

double largest_motion(const double* now, const double* then, std::size_t nodes) {
  double most = 0.0;
  for (std::size_t n = 0; n < nodes; ++n, now += 3, then += 3) {
    double d = 0.0;
    for (int i = 0; i < 3; ++i)
      d += (now[i] - then[i]) * (now[i] - then[i]);
    most = std::max(most, d);
  }
  return std::sqrt(most);
}

Box<3> face_box(const PrimaryView& primary, Local face) {
  Box<3> box = Box<3>::empty();
  for (int a = 0; a < primary.nodes(face); ++a)
    box.add(primary.now(face)[a].v);
  return box;
}

} // namespace

Configuration::Configuration(const Comm& comm, mesh::Surface primary, mesh::Surface secondary,
                             const Settings& settings, double mean_face_size)
    : comm_(comm), origin_(lowest_corner(comm, primary, secondary)),
      primary_(std::move(primary), origin_, settings.points,
               settings.formulation == Formulation::node_on_facet),
      primary_rise_(facet_rises(comm, primary_.surface())),
      secondary_(moved(std::move(secondary), origin_)), facing_(comm, secondary_, settings.reach),
      self_(settings.primary == settings.secondary && !settings.primary.empty()),
      line_(settings.ray()), reach_(settings.reach), margin_(settings.projection_margin),
      slack_(mean_face_size), smallest_size_(std::numeric_limits<double>::max()) {
  for (Local f = 0; f < points().faces(); ++f)
    smallest_size_ = std::min(smallest_size_, points().size(f));
  smallest_size_ = comm_.min(smallest_size_);
  x_secondary_ = secondary_.x;
}

void Configuration::move(const NodalFields& fields) {
  primary_.move(fields.u, fields.fields);
  for (std::size_t n = 0; n < secondary_.node.size(); ++n)
    for (std::size_t i = 0; i < 3; ++i)
      x_secondary_[3 * n + i] =
          secondary_.x[3 * n + i] +
          fields.u[std::size_t(secondary_.field_index[n]) * std::size_t(fields.fields) + i];
  if (placed_)
    return;
  placed_ = true;
  primary_.accept();
  x_secondary_previous_ = x_secondary_;
}

void Configuration::start_at(const NodalFields& fields) {
  placed_ = collected_ = false;
  move(fields);
}

void Configuration::accept() {
  primary_.accept();
  x_secondary_previous_ = x_secondary_;
  facing_.accept();
}

void Configuration::at_last_step(const std::function<void()>& work) {
  const std::vector<double> now = x_secondary_;
  x_secondary_ = x_secondary_previous_;
  primary_.at_last_step([&] {
    collected_ = false;
    follow();
    work();
  });
  x_secondary_ = now;
}

void Configuration::follow() {
  const PrimaryView& p = points();
  const std::size_t nodes = p.x.extent(0);
  const auto motion_of_primary = [&](const Vec3* then) {
    return nodes == 0 ? 0.0 : largest_motion(p.x(0).v, then->v, nodes);
  };
  const auto motion_of_secondary = [&](const std::vector<double>& then) {
    return largest_motion(x_secondary_.data(), then.data(), x_secondary_.size() / 3);
  };
  double most[4] = {motion_of_primary(p.x_previous.data()),
                    motion_of_secondary(x_secondary_previous_), 0.0, 0.0};
  if (collected_) {
    most[2] = motion_of_primary(x_primary_collected_.data());
    most[3] = motion_of_secondary(x_secondary_collected_);
  }
  comm_.max(most, 4);
  motion_ = most[0] + most[1] <= reach_ * smallest_size_ ? 0.0 : most[0] + most[1];
  if (collected_ && motion_ <= collected_motion_ && most[2] + most[3] <= slack_)
    facing_.update(x_secondary_);
  else
    collect();
}

void Configuration::collect() {
  const PrimaryView& p = points();
  collected_motion_ = motion_;
  collected_ = true;
  x_primary_collected_.assign(p.x.data(), p.x.data() + p.x.extent(0));
  x_secondary_collected_ = x_secondary_;
  std::vector<Box<3>> boxes;
  for (Local f = 0; f < p.faces(); ++f) {
    boxes.push_back(face_box(p, f));
    boxes.back().inflate(std::max(reach_ * p.size(f), motion_) + slack_);
  }
  search::Bvh<3> tree;
  tree.build(boxes);
  facing_.collect(x_secondary_, x_secondary_previous_, tree.summary(summary_levels), self_);
}

PartnerSearch Configuration::search() const {
  return {points(), facing(), self_, line_, reach_, margin_, motion_};
}

void Configuration::near_pairs(Connectivity& cells, std::vector<Local>& face) const {
  const PrimaryView& p = points();
  const PartnerSearch search = this->search();
  for (Local f = 0; f < p.faces(); ++f) {
    Box<3> b = face_box(p, f);
    b.inflate(pattern_pad * p.size(f));
    Global nodes[2 * fem::max_face_nodes];
    const int n = p.nodes(f);
    std::copy_n(&p.global_node(p.first_node(f)), n, nodes);
    facing().tree.traverse([&](const Box<3>& box) { return box.overlaps(b); },
                           [&](Local candidate) {
                             if (search.own_neighbour(f, candidate))
                               return;
                             const int m = facing().nodes(candidate);
                             for (int a = 0; a < m; ++a)
                               nodes[n + a] = facing().mesh_node(candidate, a);
                             cells.add(nodes, n + m);
                             face.push_back(f);
                           });
  }
}

double Configuration::wrong_facing_share() const {
  const PrimaryView& p = points();
  const PartnerSearch search = this->search();
  double near[2] = {0.0, 0.0}; // points near a face of the other surface; those facing its back
  for (Local i = 0; i < p.points(); ++i) {
    const Local f = p.face(i);
    const auto at = p.at(i);
    const double reach2 = p.size(f) * p.size(f);
    bool wrong = false, found = false;
    facing().tree.traverse([&](const Box<3>& box) { return box.distance2(at.x.v) <= reach2; },
                           [&](Local candidate) {
                             if (search.own_neighbour(f, candidate))
                               return;
                             const fem::FaceType type = facing().type(candidate);
                             Vec3 y[fem::max_face_nodes];
                             facing().coordinates(candidate, y);
                             double center[2];
                             fem::dispatch_face(type, [&](auto s) { decltype(s)::center(center); });
                             const auto q = facet_gap<double>(type, y, at.x, center);
                             if (std::fabs(q.gap) > p.size(f))
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
