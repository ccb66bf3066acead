// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/start_motion.hpp"

#include "abut/core/trilinos.hpp"
#include "abut/scene/masses.hpp"
#include "abut/solver/linear_solver.hpp"

#include <algorithm>
#include <limits>

namespace abut::scene {

namespace {

Vec3 vec(const std::array<double, 3>& a) {
  return {{a[0], a[1], a[2]}};
}

Vec3 position(const mesh::Mesh& mesh, Local n) {
  const double* x = &mesh.x[3 * static_cast<std::size_t>(n)];
  return {{x[0], x[1], x[2]}};
}

void put(std::vector<double>& values, Local n, const Vec3& v) {
  for (int k = 0; k < 3; ++k)
    values[3 * std::size_t(n) + std::size_t(k)] = v[k];
}

/// (N) the first deformable body of each node, of owned nodes over all ranks, or none.
std::vector<int> bodies_of_nodes(const Scene& s, const NodeExchange& ghosts) {
  constexpr int none = std::numeric_limits<int>::max();
  std::vector<int> body(static_cast<std::size_t>(s.mesh->num_local()), none);
  for (std::size_t b = 0; b < s.mesh->blocks.size(); ++b)
    for (const Local n : s.mesh->blocks[b].nodes)
      if (s.material[b])
        body[std::size_t(n)] = std::min(body[std::size_t(n)], s.body_of_block[b]);
  ghosts.min_to_owners(body.data());
  return body;
}

/// Velocities of owned nodes at the start, ghosts and nodes of rigid bodies left for later.
std::vector<double> velocities_of_bodies(const Options& options, const Scene& s,
                                         const NodeExchange& ghosts) {
  const mesh::Mesh& mesh = *s.mesh;
  std::vector<double> v(3 * static_cast<std::size_t>(mesh.num_local()), 0.0);
  const std::vector<int> body_of_node = bodies_of_nodes(s, ghosts);
  for (std::size_t i = 0; i < options.bodies.size(); ++i) {
    const BodyOptions& body = options.bodies[i];
    if (body.rigid)
      continue;
    const Vec3 center = body_mass(options, mesh, s.body_of_block, i).center;
    for (Local n = 0; n < mesh.num_owned; ++n)
      if (body_of_node[std::size_t(n)] == static_cast<int>(i))
        put(v, n,
            vec(body.initial_velocity) +
                cross(vec(body.initial_angular_velocity), position(mesh, n) - center));
  }
  return v;
}

struct NodalRates {
  std::vector<double> velocity, acceleration; ///< (N,3)
};

/// How nodes move at the start, but for the accelerations that forces make.
NodalRates initial_rates(const Options& options, const Scene& s) {
  const mesh::Mesh& mesh = *s.mesh;
  const NodeExchange ghosts = mesh::node_exchange(mesh);
  NodalRates rates;
  std::vector<double>& v = rates.velocity;
  v = velocities_of_bodies(options, s, ghosts);
  for (const assembly::Constraint& c : s.constraints)
    v[3 * std::size_t(c.node) + std::size_t(c.field)] = initial_slope(options.time, c.value);
  ghosts.to_ghosts(v.data(), 3);
  rates.acceleration.assign(v.size(), 0.0);
  for (Local n = 0; n < mesh.num_local(); ++n) {
    if (s.rigid_body_of_node[std::size_t(n)] < 0)
      continue;
    const auto& body = s.rigid_bodies[std::size_t(s.rigid_body_of_node[std::size_t(n)])];
    const Vec3 turning = cross(body.spin, position(mesh, n) - body.center);
    put(v, n, body.velocity + turning);
    put(rates.acceleration, n, cross(body.spin, turning));
  }
  return rates;
}

} // namespace

void start_motion(const Options& options, Scene& s, solver::LinearSolver& linear, const Vector& x) {
  constexpr double tolerance = 1e-12;
  assembly::EquationSystem& equations = *s.equations;
  solid::NodalMotion& nodes = s.inertia->motion();
  NodalRates rates = initial_rates(options, s);
  nodes.start(equations.time(), equations.nodal_values(x), rates.velocity);
  nodes.set_acceleration(rates.acceleration);
  Vector force(x.getMap()), acceleration(x.getMap());
  equations.start_motion(options.dynamics.rule(), x, force);
  linear.setup(equations.mass(x), equations.graph_version(), equations.symmetric());
  linear.solve(force, acceleration, tolerance);
  linear.forget(); // the mass tells nothing of the matrices to come
  const std::vector<double> made = equations.nodal_rates(acceleration);
  for (std::size_t i = 0; i < made.size(); ++i)
    rates.acceleration[i] += made[i];
  nodes.set_acceleration(rates.acceleration);
  equations.accelerate(x, acceleration);
}

} // namespace abut::scene
