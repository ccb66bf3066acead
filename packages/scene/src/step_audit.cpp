// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/step_audit.hpp"

#include <algorithm>

namespace abut::scene {

namespace {

struct ForceNotice {
  Global node;
  Vec3 force;
};

/// (rigid bodies) Those that follow the deck are one frame: they overlap only if it says so. So are
/// the members of a mechanism, which are drawn one over the other at their joints.
std::vector<int> frames_of_bodies(const Options& options, const Scene& scene) {
  std::vector<int> frame;
  for (std::size_t b = 0; b < scene.rigid_bodies.size(); ++b)
    frame.push_back(scene.rigid_bodies[b].has_unknowns() ? static_cast<int>(b) + 1 : 0);
  const auto frame_of = [&](const std::string& name) {
    for (std::size_t b = 0; b < frame.size(); ++b)
      if (scene.rigid_bodies[b].name == name)
        return frame[b];
    return -1; // the ground
  };
  for (const rigid::JointOptions& joint : options.joints) {
    const int a = frame_of(joint.bodies[0]), b = frame_of(joint.bodies[1]);
    if (joint.kind != rigid::JointKind::spring && a >= 0 && b >= 0)
      std::replace(frame.begin(), frame.end(), b, a);
  }
  return frame;
}

std::vector<int> frames(const Options& options, const Scene& scene) {
  const std::vector<int> of_body = frames_of_bodies(options, scene);
  std::vector<int> frame;
  for (const int body : scene.rigid_body_of_node)
    frame.push_back(body < 0 ? -1 : of_body[std::size_t(body)]);
  return frame;
}

audit::Bodies bodies_of(const Options& options, const Scene& scene) {
  audit::Bodies bodies{{}, scene.body_of_block, frames(options, scene)};
  for (const BodyOptions& body : options.bodies)
    bodies.names.push_back(body.name);
  return bodies;
}

std::vector<audit::Interface> interfaces_of(const Scene& scene) {
  std::vector<audit::Interface> list;
  for (const auto& c : scene.contacts)
    list.push_back({c->name(), c->settings().primary, c->settings().secondary});
  return list;
}

/// What the interface exerts on the nodes that each rank owns, as the equations get it. Collective.
std::vector<audit::NodalForce> nodal_forces(const mesh::Mesh& mesh, contact::Interaction& c) {
  const Connectivity& cells = c.connectivity();
  std::vector<Global> nodes = cells.nodes;
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::vector<Local> row;
  for (const Global node : cells.nodes)
    row.push_back(
        static_cast<Local>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin()));
  std::vector<double> values(3 * nodes.size(), 0.0);
  ResidualScatter scatter;
  scatter.fields = 3;
  scatter.cell_offset = cells.offsets.data();
  scatter.row = row.data();
  scatter.values = values.data();
  c.residual({}, scatter);
  std::vector<std::vector<ForceNotice>> to(std::size_t(mesh.comm.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double* f = &values[3 * i];
    if (f[0] != 0.0 || f[1] != 0.0 || f[2] != 0.0)
      to[std::size_t(mesh.owner(nodes[i]))].push_back({nodes[i], {{-f[0], -f[1], -f[2]}}});
  }
  std::vector<audit::NodalForce> forces;
  const Global first = mesh.first_node[std::size_t(mesh.comm.rank())];
  for (const auto& part : mesh.comm.exchange(to))
    for (const ForceNotice& f : part)
      forces.push_back({static_cast<Local>(f.node - first), f.force});
  return forces;
}

} // namespace

audit::Belief belief_of(const mesh::Mesh& mesh, contact::Interaction& c) {
  const contact::Settings& settings = c.settings();
  audit::Belief belief;
  belief.acts = c.acts();
  belief.may_pull = settings.tension || settings.anchors();
  belief.has_cone = !settings.anchors() && settings.friction_map != contact::FrictionMap::literal;
  belief.friction = c.points().friction();
  belief.force = c.summary().force;
  for (const contact::PointRecord& p : c.points().records())
    belief.points.push_back({p.face, p.x, p.paired,
                             settings.anchors() && p.status == contact::Status::stick, p.gap,
                             p.pressure, p.shear});
  belief.forces = nodal_forces(mesh, c);
  return belief;
}

StepAudit::StepAudit(const Options& options, const Scene& scene, double tolerance)
    : scene_(scene),
      audit_(*scene.mesh, bodies_of(options, scene), interfaces_of(scene), tolerance) {}

audit::Findings StepAudit::look() {
  std::vector<audit::Belief> beliefs;
  for (const auto& contact : scene_.contacts)
    beliefs.push_back(belief_of(*scene_.mesh, *contact));
  return audit_.look(scene_.equations->fields().u, beliefs);
}

} // namespace abut::scene
