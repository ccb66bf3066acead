// SPDX-License-Identifier: BSD-3-Clause
#include "inertia.hpp"

#include "abut/scene/masses.hpp"

namespace abut::scene {

namespace {

/// What moves the nodes of each rigid body along x, y and z. Those of a body that does not turn
/// move as its center does.
std::vector<std::array<solid::Lead, 3>> leads_of_bodies(const Options& options) {
  std::vector<std::array<solid::Lead, 3>> result;
  for (const BodyOptions& body : options.bodies) {
    if (!body.rigid)
      continue;
    const rigid::MotionOptions& motion = body.motion;
    bool turns = false;
    for (std::size_t i = 0; i < 3; ++i)
      turns = turns || motion.free[3 + i] || motion.rotation[i] != 0.0;
    std::array<solid::Lead, 3>& lead = result.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      lead[i] = turns && motion.has_unknowns() ? solid::Lead::rigid
                : !turns && motion.free[i]     ? solid::Lead::free
                                               : solid::Lead::prescribed;
  }
  return result;
}

} // namespace

std::shared_ptr<solid::InertiaContribution>
make_inertia(const Options& options, const mesh::Mesh& mesh, const std::vector<int>& body_of_block,
             const std::vector<int>& rigid_body_of_node,
             const std::vector<assembly::Constraint>& constraints) {
  std::vector<char> led(3 * static_cast<std::size_t>(mesh.num_local()), 0);
  for (const assembly::Constraint& c : constraints)
    led[3 * std::size_t(c.node) + std::size_t(c.field)] = 1;
  mesh::node_exchange(mesh).to_ghosts(led.data(), 3);
  const auto of_bodies = leads_of_bodies(options);
  std::vector<solid::Lead> lead;
  for (std::size_t i = 0; i < led.size(); ++i) {
    const int body = rigid_body_of_node[i / 3];
    lead.push_back(body >= 0 ? of_bodies[std::size_t(body)][i % 3]
                   : led[i]  ? solid::Lead::prescribed
                             : solid::Lead::free);
  }
  std::vector<solid::BlockDensity> blocks;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const BodyOptions& body = options.bodies[std::size_t(body_of_block[b])];
    if (!body.rigid)
      blocks.push_back({static_cast<int>(b), density_of(options, body)});
  }
  return std::make_shared<solid::InertiaContribution>(mesh, blocks, options.dynamics.rule(), lead);
}

} // namespace abut::scene
