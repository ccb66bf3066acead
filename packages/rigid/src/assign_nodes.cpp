// SPDX-License-Identifier: BSD-3-Clause
#include "abut/rigid/assign_nodes.hpp"

#include <algorithm>
#include <limits>

namespace abut::rigid {

namespace {

/// Bodies of nodes by what this rank knows.
class Assignment {
public:
  Assignment(const mesh::Mesh& mesh, const std::vector<BodyNodes>& bodies, const Where& where)
      : mesh_(mesh), bodies_(bodies), where_(where), body_(mesh.node.size(), -1) {}

  void blocks_and_sets() {
    std::vector<int> of_block(mesh_.blocks.size(), -1);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      for (const int block : bodies_[i].blocks)
        of_block[std::size_t(block)] = static_cast<int>(i);
    for (std::size_t b = 0; b < of_block.size(); ++b)
      for (const Local n : mesh_.blocks[b].nodes)
        if (of_block[b] >= 0)
          assign(n, of_block[b]);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      for (const std::string& set : bodies_[i].node_sets)
        for (const Local n : mesh_.node_sets.at(set))
          assign(n, static_cast<int>(i));
  }

  void assign(Local n, int body) {
    int& mine = body_[std::size_t(n)];
    if (mine >= 0 && mine != body)
      throw InputError(where_("bodies." + name(std::max(mine, body))) + ": node " +
                       std::to_string(mesh_.node_id[n]) + " already belongs to rigid body '" +
                       name(std::min(mine, body)) + "'");
    mine = body;
  }

  std::vector<int>& body() { return body_; }

private:
  const std::string& name(int body) const { return bodies_[std::size_t(body)].name; }

  const mesh::Mesh& mesh_;
  const std::vector<BodyNodes>& bodies_;
  const Where& where_;
  std::vector<int> body_;
};

} // namespace

std::vector<int> assign_nodes(const mesh::Mesh& mesh, const std::vector<BodyNodes>& bodies,
                              const Where& where) {
  Assignment nodes(mesh, bodies, where);
  mesh.comm.together([&] { nodes.blocks_and_sets(); });
  const NodeExchange ghosts = mesh::node_exchange(mesh);
  std::vector<int> first = nodes.body(), last = nodes.body();
  for (int& body : first)
    body = body < 0 ? std::numeric_limits<int>::max() : body;
  ghosts.min_to_owners(first.data());
  ghosts.max_to_owners(last.data());
  mesh.comm.together([&] {
    for (Local n = 0; n < mesh.num_owned; ++n)
      for (const int body : {first[std::size_t(n)], last[std::size_t(n)]})
        if (last[std::size_t(n)] >= 0)
          nodes.assign(n, body);
  });
  ghosts.to_ghosts(nodes.body().data());
  return nodes.body();
}

} // namespace abut::rigid
