// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/masses.hpp"

#include "abut/core/error.hpp"
#include "abut/rigid/make.hpp"

#include <algorithm>
#include <cmath>

namespace abut::scene {

namespace {

void set_inertia(const Options& options, const mesh::Mesh& mesh,
                 const std::vector<int>& body_of_block, std::size_t index, rigid::Body& body) {
  const BodyOptions& given = options.bodies[index];
  if (given.motion.density) {
    const solid::MassProperties p = body_mass(options, mesh, body_of_block, index);
    body.mass = {p.mass, p.center - body.center, p.inertia};
  }
  for (int i = 0; i < 3; ++i) {
    const auto &place = body.prescribed[std::size_t(i)],
               &turn = body.prescribed[std::size_t(i + 3)];
    body.velocity[i] =
        place ? initial_slope(options.time, place) : given.initial_velocity[std::size_t(i)];
    body.spin[i] =
        turn ? initial_slope(options.time, turn) : given.initial_angular_velocity[std::size_t(i)];
  }
}

} // namespace

std::vector<int> blocks_of(const std::vector<int>& body_of_block, std::size_t body) {
  std::vector<int> blocks;
  for (std::size_t b = 0; b < body_of_block.size(); ++b)
    if (body_of_block[b] == static_cast<int>(body))
      blocks.push_back(static_cast<int>(b));
  return blocks;
}

double density_of(const Options& options, const BodyOptions& body) {
  const auto material =
      std::find_if(options.materials.begin(), options.materials.end(),
                   [&](const solid::MaterialOptions& o) { return o.name == body.material; });
  ABUT_REQUIRE(material != options.materials.end() && material->density,
               "the material of '" + body.name + "' has no density");
  return *material->density;
}

solid::MassProperties body_mass(const Options& options, const mesh::Mesh& mesh,
                                const std::vector<int>& body_of_block, std::size_t index) {
  const BodyOptions& body = options.bodies[index];
  const double density = body.rigid ? body.motion.density.value_or(0.0) : density_of(options, body);
  return solid::mass_properties(mesh, blocks_of(body_of_block, index), density);
}

double initial_slope(const solver::TimeOptions& time, const std::function<double(double)>& value) {
  const double step = time.end / time.steps, instant = 1e-3 * step;
  const double mean = (value(step) - value(0.0)) / step;
  const double now = (value(instant) - value(0.0)) / instant;
  return mean * now <= 0.0 ? 0.0 : std::fabs(now) < std::fabs(mean) ? now : mean;
}

std::vector<rigid::Body> make_rigid_bodies(const Options& options, const mesh::Mesh& mesh,
                                           const std::vector<int>& body_of_block) {
  std::vector<rigid::Body> result;
  for (std::size_t i = 0; i < options.bodies.size(); ++i) {
    const BodyOptions& body = options.bodies[i];
    if (!body.rigid)
      continue;
    result.push_back(rigid::make_body(body.name, body.motion, options.curves));
    if (options.dynamics.active)
      set_inertia(options, mesh, body_of_block, i, result.back());
  }
  return result;
}

} // namespace abut::scene
