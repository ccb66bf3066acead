// SPDX-License-Identifier: BSD-3-Clause
#include "rigid_motion.hpp"

#include "abut/core/tensor.hpp"

#include <cmath>

namespace abut::app {

namespace {

/// Index of the rigid body of each local node, -1: none. Where two meet, the one named first holds.
std::vector<double> body_of_node(const Model& m) {
  std::vector<double> body(m.mesh->node.size(), -1.0);
  for (std::size_t b = 0; b < m.mesh->blocks.size(); ++b) {
    const int i = m.body_of_block[b];
    if (!m.deck.bodies[std::size_t(i)].rigid)
      continue;
    for (Local n : m.mesh->blocks[b].nodes)
      if (body[n] < 0.0 || body[n] > i)
        body[n] = i;
  }
  return body;
}

/// body_of_node with what only other ranks' elements tell.
std::vector<double> agreed_body_of_node(const Model& m) {
  struct Entry {
    Global node;
    double body;
  };
  const mesh::Mesh& mesh = *m.mesh;
  std::vector<double> body = body_of_node(m);
  std::vector<std::vector<Entry>> up(static_cast<std::size_t>(mesh.comm.size()));
  for (Local n = mesh.num_owned; n < mesh.num_local(); ++n)
    if (body[n] >= 0.0)
      up[static_cast<std::size_t>(mesh.owner(mesh.node[n]))].push_back({mesh.node[n], body[n]});
  const Global first = mesh.first_node[static_cast<std::size_t>(mesh.comm.rank())];
  for (const auto& list : mesh.comm.exchange(up))
    for (const Entry& e : list) {
      double& mine = body[static_cast<std::size_t>(e.node - first)];
      if (mine < 0.0 || mine > e.body)
        mine = e.body;
    }
  mesh::GhostExchange(mesh).update(body.data(), 1);
  return body;
}

/// Rotation by the vector w (Rodrigues).
Mat3 rotation(const Vec3& w) {
  const double angle = norm(w);
  Mat3 r = Mat3::identity();
  if (angle == 0.0)
    return r;
  const Vec3 k = (1.0 / angle) * w;
  const Mat3 skew = {{{0, -k[2], k[1]}, {k[2], 0, -k[0]}, {-k[1], k[0], 0}}};
  const Mat3 square = skew * skew;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      r[i][j] += std::sin(angle) * skew[i][j] + (1.0 - std::cos(angle)) * square[i][j];
  return r;
}

} // namespace

std::vector<char> rigid_nodes(const Model& m) {
  std::vector<char> flags;
  for (double b : agreed_body_of_node(m))
    flags.push_back(b >= 0.0);
  return flags;
}

assembly::PrescribedMotion rigid_motion(const Model& m) {
  std::vector<deck::Curve> curves;
  for (const auto& body : m.deck.bodies)
    curves.push_back(m.deck.curve(body.motion.curve));
  return [&m, curves, body = agreed_body_of_node(m)](double t, double* u) {
    std::vector<Mat3> turns;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const auto& w = m.deck.bodies[i].motion.rotation;
      turns.push_back(rotation(curves[i](t) * Vec3{{w[0], w[1], w[2]}}));
    }
    for (std::size_t n = 0; n < body.size(); ++n) {
      if (body[n] < 0.0)
        continue;
      const auto i = static_cast<std::size_t>(body[n]);
      const solid::RigidMotion& motion = m.deck.bodies[i].motion;
      Vec3 arm;
      for (int k = 0; k < 3; ++k)
        arm[k] = m.mesh->x[3 * n + std::size_t(k)] - motion.center[std::size_t(k)];
      const Vec3 turned = turns[i] * arm;
      for (int k = 0; k < 3; ++k)
        u[3 * n + std::size_t(k)] =
            turned[k] - arm[k] + curves[i](t) * motion.displacement[std::size_t(k)];
    }
  };
}

} // namespace abut::app
