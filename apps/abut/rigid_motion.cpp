// SPDX-License-Identifier: BSD-3-Clause
#include "rigid_motion.hpp"

#include "abut/core/error.hpp"
#include "dynamics.hpp"

#include <algorithm>

namespace abut::app {

namespace {

/// Options of the rigid bodies, in the order of the deck.
std::vector<const solid::BodyOptions*> rigid_options(const Model& m) {
  std::vector<const solid::BodyOptions*> rigid;
  for (const auto& body : m.deck.bodies)
    if (body.rigid)
      rigid.push_back(&body);
  return rigid;
}

class Assignment {
public:
  explicit Assignment(const Model& m)
      : m_(m), rigid_(rigid_options(m)), body_(m.mesh->node.size(), -1) {}

  void blocks_and_sets() {
    for (std::size_t b = 0; b < m_.mesh->blocks.size(); ++b) {
      const auto& options = m_.deck.bodies[std::size_t(m_.body_of_block[b])];
      const auto found = std::find(rigid_.begin(), rigid_.end(), &options);
      for (Local n : m_.mesh->blocks[b].nodes)
        if (found != rigid_.end())
          assign(n, static_cast<int>(found - rigid_.begin()));
    }
    for (std::size_t i = 0; i < rigid_.size(); ++i)
      for (const std::string& set : rigid_[i]->node_sets)
        for (Local n : m_.mesh->node_sets.at(set))
          assign(n, static_cast<int>(i));
  }

  struct Entry {
    Global node;
    int body;
  };
  /// What this rank knows of nodes that others own.
  std::vector<std::vector<Entry>> for_owners() const {
    const mesh::Mesh& mesh = *m_.mesh;
    std::vector<std::vector<Entry>> up(static_cast<std::size_t>(mesh.comm.size()));
    for (Local n = mesh.num_owned; n < mesh.num_local(); ++n)
      if (body_[n] >= 0)
        up[static_cast<std::size_t>(mesh.owner(mesh.node[n]))].push_back({mesh.node[n], body_[n]});
    return up;
  }
  void receive(const std::vector<std::vector<Entry>>& lists) {
    const Global first = m_.mesh->first_node[static_cast<std::size_t>(m_.mesh->comm.rank())];
    for (const auto& list : lists)
      for (const Entry& e : list)
        assign(static_cast<Local>(e.node - first), e.body);
  }

  void check_displacements() const {
    for (const auto& d : m_.deck.displacements)
      for (Local n : nodes_of_set(*m_.mesh, d.set))
        if (body_[n] >= 0)
          throw InputError(m_.deck.where("displacements." + d.name) + ": node " +
                           std::to_string(m_.mesh->node_id[n]) + " moves with rigid body '" +
                           name(body_[n]) + "', which alone prescribes it");
  }

  std::vector<int> take() {
    std::vector<double> values(body_.begin(), body_.end());
    mesh::GhostExchange(*m_.mesh).update(values.data(), 1);
    for (std::size_t n = 0; n < values.size(); ++n)
      body_[n] = static_cast<int>(values[n]);
    return body_;
  }

private:
  const std::string& name(int body) const { return rigid_[std::size_t(body)]->name; }

  void assign(Local n, int body) {
    int& mine = body_[std::size_t(n)];
    if (mine >= 0 && mine != body)
      throw InputError(m_.deck.where("bodies." + name(std::max(mine, body))) + ": node " +
                       std::to_string(m_.mesh->node_id[n]) + " already belongs to rigid body '" +
                       name(std::min(mine, body)) + "'");
    mine = body;
  }

  const Model& m_;
  std::vector<const solid::BodyOptions*> rigid_;
  std::vector<int> body_;
};

} // namespace

std::vector<int> rigid_nodes(const Model& m) {
  Assignment nodes(m);
  m.comm.together([&] { nodes.blocks_and_sets(); });
  const auto received = m.comm.exchange(nodes.for_owners());
  m.comm.together([&] { nodes.receive(received); });
  const std::vector<int> body = nodes.take();
  m.comm.together([&] { nodes.check_displacements(); });
  return body;
}

std::vector<assembly::RigidBody> rigid_bodies(const Model& m) {
  std::vector<assembly::RigidBody> result;
  for (const solid::BodyOptions* options : rigid_options(m)) {
    const solid::RigidMotion& motion = options->motion;
    assembly::RigidBody body;
    body.name = options->name;
    for (std::size_t i = 0; i < 6; ++i) {
      const deck::Curve curve =
          m.deck.curve(motion.curves[i].empty() ? motion.curve : motion.curves[i]);
      const double value = i < 3 ? motion.displacement[i] : motion.rotation[i - 3];
      if (!motion.free[i])
        body.prescribed[i] = [curve, value](double t) { return value * curve(t); };
    }
    for (const solid::RigidHold& hold : motion.holds)
      for (int i = 0; i < 6; ++i) {
        if (!hold.components[std::size_t(i)])
          continue;
        const deck::Curve curve = m.deck.curve(hold.curve);
        const double value = hold.values[std::size_t(i)];
        body.holds.push_back(
            {i, [curve, value](double t) { return value * curve(t); }, hold.window, hold.relative});
      }
    for (int i = 0; i < 3; ++i) {
      body.center[i] = motion.center[std::size_t(i)];
      body.force[i] = motion.force[std::size_t(i)];
      body.moment[i] = motion.moment[std::size_t(i)];
    }
    for (std::size_t i = 0; i < 6; ++i)
      body.load_factor[i] =
          m.deck.curve(motion.load_curves[i].empty() ? motion.load_curve : motion.load_curves[i]);
    body.follower = motion.follower;
    set_inertia(m, *options, body);
    result.push_back(std::move(body));
  }
  return result;
}

} // namespace abut::app
