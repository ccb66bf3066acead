// SPDX-License-Identifier: BSD-3-Clause
#include "dynamics.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/solid/mass.hpp"
#include "abut/solver/linear_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::app {

namespace {

Vec3 vec(const std::array<double, 3>& a) {
  return {{a[0], a[1], a[2]}};
}

Vec3 position(const mesh::Mesh& mesh, Local n) {
  const double* x = &mesh.x[3 * static_cast<std::size_t>(n)];
  return {{x[0], x[1], x[2]}};
}

/// Velocity with which a prescribed value starts. Where it jumps at once, that of a first step.
double initial_slope(const Model& m, const std::function<double(double)>& value) {
  const double step = m.deck.time.end / m.deck.time.steps, instant = 1e-3 * step;
  const double mean = (value(step) - value(0.0)) / step;
  const double now = (value(instant) - value(0.0)) / instant;
  return mean * now <= 0.0 ? 0.0 : std::fabs(now) < std::fabs(mean) ? now : mean;
}

std::vector<int> blocks_of(const Model& m, std::size_t body) {
  std::vector<int> blocks;
  for (std::size_t b = 0; b < m.body_of_block.size(); ++b)
    if (m.body_of_block[b] == static_cast<int>(body))
      blocks.push_back(static_cast<int>(b));
  return blocks;
}

double density_of(const Model& m, const solid::BodyOptions& body) {
  const auto material =
      std::find_if(m.deck.materials.begin(), m.deck.materials.end(),
                   [&](const solid::MaterialOptions& o) { return o.name == body.material; });
  ABUT_REQUIRE(material != m.deck.materials.end() && material->density,
               "the material of '" + body.name + "' passed the deck's checks");
  return *material->density;
}

/// (N) the first deformable body of each local node, or none.
std::vector<int> bodies_of_nodes(const Model& m) {
  constexpr int none = std::numeric_limits<int>::max();
  const mesh::Mesh& mesh = *m.mesh;
  std::vector<int> body(static_cast<std::size_t>(mesh.num_local()), none);
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (const Local n : mesh.blocks[b].nodes)
      if (m.material[b])
        body[std::size_t(n)] = std::min(body[std::size_t(n)], m.body_of_block[b]);
  struct Entry {
    Global node;
    int body;
  };
  std::vector<std::vector<Entry>> up(static_cast<std::size_t>(mesh.comm.size()));
  for (Local n = mesh.num_owned; n < mesh.num_local(); ++n)
    up[static_cast<std::size_t>(mesh.owner(mesh.node[n]))].push_back(
        {mesh.node[n], body[std::size_t(n)]});
  const Global first = mesh.first_node[static_cast<std::size_t>(mesh.comm.rank())];
  for (const auto& list : mesh.comm.exchange(up))
    for (const Entry& e : list) {
      int& mine = body[static_cast<std::size_t>(e.node - first)];
      mine = std::min(mine, e.body);
    }
  return body;
}

/// Velocities of owned nodes at the start, ghosts and nodes of rigid bodies left for later.
std::vector<double> velocities_of_bodies(const Model& m) {
  const mesh::Mesh& mesh = *m.mesh;
  std::vector<double> v(3 * static_cast<std::size_t>(mesh.num_local()), 0.0);
  const std::vector<int> body_of_node = bodies_of_nodes(m);
  for (std::size_t i = 0; i < m.deck.bodies.size(); ++i) {
    const solid::BodyOptions& body = m.deck.bodies[i];
    if (body.rigid)
      continue;
    const Vec3 center = body_mass(m, i).center;
    for (Local n = 0; n < mesh.num_owned; ++n) {
      if (body_of_node[std::size_t(n)] != static_cast<int>(i))
        continue;
      const Vec3 velocity = vec(body.initial_velocity) +
                            cross(vec(body.initial_angular_velocity), position(mesh, n) - center);
      for (int k = 0; k < 3; ++k)
        v[3 * std::size_t(n) + std::size_t(k)] = velocity[k];
    }
  }
  return v;
}

/// What moves the nodes of each rigid body along x, y and z. Those of a body that does not turn
/// move as its center does.
std::vector<std::array<solid::Lead, 3>> leads_of_bodies(const Model& m) {
  std::vector<std::array<solid::Lead, 3>> result;
  for (const solid::BodyOptions& body : m.deck.bodies) {
    if (!body.rigid)
      continue;
    const solid::RigidMotion& motion = body.motion;
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

struct NodalRates {
  std::vector<double> velocity, acceleration; ///< (N,3)
};

/// How nodes move at the start, but for the accelerations that forces make.
NodalRates initial_rates(const Model& m) {
  NodalRates rates;
  std::vector<double>& v = rates.velocity;
  v = velocities_of_bodies(m);
  for (const assembly::Constraint& c : m.constraints)
    v[3 * std::size_t(c.node) + std::size_t(c.field)] = initial_slope(m, c.value);
  mesh::GhostExchange(*m.mesh).update(v.data(), 3);
  rates.acceleration.assign(v.size(), 0.0);
  for (Local n = 0; n < m.mesh->num_local(); ++n) {
    if (m.rigid_body_of_node[std::size_t(n)] < 0)
      continue;
    const auto& body = m.rigid_bodies[std::size_t(m.rigid_body_of_node[std::size_t(n)])];
    const Vec3 turning = cross(body.spin, position(*m.mesh, n) - body.center);
    const Vec3 velocity = body.velocity + turning, inwards = cross(body.spin, turning);
    for (int k = 0; k < 3; ++k) {
      v[3 * std::size_t(n) + std::size_t(k)] = velocity[k];
      rates.acceleration[3 * std::size_t(n) + std::size_t(k)] = inwards[k];
    }
  }
  return rates;
}

} // namespace

std::shared_ptr<solid::InertiaContribution> make_inertia(const Model& m) {
  const mesh::Mesh& mesh = *m.mesh;
  std::vector<double> led(3 * static_cast<std::size_t>(mesh.num_local()), 0.0);
  for (const assembly::Constraint& c : m.constraints)
    led[3 * std::size_t(c.node) + std::size_t(c.field)] = 1.0;
  mesh::GhostExchange(mesh).update(led.data(), 3);
  const auto of_bodies = leads_of_bodies(m);
  std::vector<solid::Lead> lead;
  for (std::size_t i = 0; i < led.size(); ++i) {
    const int body = m.rigid_body_of_node[i / 3];
    lead.push_back(body >= 0      ? of_bodies[std::size_t(body)][i % 3]
                   : led[i] > 0.0 ? solid::Lead::prescribed
                                  : solid::Lead::free);
  }
  std::vector<solid::BlockDensity> blocks;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    if (m.material[b])
      blocks.push_back(
          {static_cast<int>(b), density_of(m, m.deck.bodies[std::size_t(m.body_of_block[b])])});
  return std::make_shared<solid::InertiaContribution>(mesh, blocks, m.deck.dynamics.rule(),
                                                      std::move(lead));
}

solid::MassProperties body_mass(const Model& m, std::size_t body) {
  const solid::BodyOptions& options = m.deck.bodies[body];
  const double density =
      options.rigid ? options.motion.density.value_or(0.0) : density_of(m, options);
  return solid::mass_properties(*m.mesh, blocks_of(m, body), density);
}

void set_inertia(const Model& m, const solid::BodyOptions& options, assembly::RigidBody& body) {
  if (!m.deck.dynamics.active)
    return;
  const solid::RigidMotion& motion = options.motion;
  if (motion.density) {
    const solid::MassProperties p =
        body_mass(m, static_cast<std::size_t>(&options - m.deck.bodies.data()));
    body.mass = {p.mass, p.center - body.center, p.inertia};
  } else if (motion.mass) {
    body.mass.mass = *motion.mass;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      body.mass.inertia[i][i] = motion.moments_of_inertia[std::size_t(i)];
      body.mass.inertia[i][j] = body.mass.inertia[j][i] =
          motion.products_of_inertia[std::size_t(i)];
    }
  }
  for (int i = 0; i < 3; ++i) {
    const auto &place = body.prescribed[std::size_t(i)],
               &turn = body.prescribed[std::size_t(i + 3)];
    body.velocity[i] = place ? initial_slope(m, place) : options.initial_velocity[std::size_t(i)];
    body.spin[i] = turn ? initial_slope(m, turn) : options.initial_angular_velocity[std::size_t(i)];
  }
}

void start_dynamics(Model& m, solver::LinearSolver& linear, const Vector& x) {
  constexpr double tolerance = 1e-12;
  assembly::EquationSystem& equations = *m.equations;
  solid::NodalMotion& nodes = m.inertia->motion();
  NodalRates rates = initial_rates(m);
  nodes.start(equations.time(), equations.nodal_values(x), rates.velocity);
  nodes.set_acceleration(rates.acceleration);
  Vector force(x.getMap()), acceleration(x.getMap());
  equations.start_motion(m.deck.dynamics.rule(), x, force);
  linear.setup(equations.mass(x), equations.graph_version(), equations.symmetric());
  linear.solve(force, acceleration, tolerance);
  linear.forget(); // the mass tells nothing of the matrices to come
  const std::vector<double> made = equations.nodal_rates(acceleration);
  for (std::size_t i = 0; i < made.size(); ++i)
    rates.acceleration[i] += made[i];
  nodes.set_acceleration(std::move(rates.acceleration));
  equations.accelerate(x, acceleration);
}

} // namespace abut::app
