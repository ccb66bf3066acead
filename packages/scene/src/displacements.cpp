// SPDX-License-Identifier: BSD-3-Clause
#include "displacements.hpp"

#include "abut/scene/names.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace abut::scene {

namespace {

/// value(t) of an amount at a place, computed once for each t.
std::function<double(double)> history(const Amount& amount, const Vec3& position,
                                      const std::function<double(double)>& curve) {
  return [=, last = std::numeric_limits<double>::quiet_NaN(), value = 0.0](double t) mutable {
    if (t != last)
      value = amount.at(position, t, curve);
    last = t;
    return value;
  };
}

/// Whether two entries say the same of direction i, or not at the same time.
bool agree(const DisplacementOptions& d, const DisplacementOptions& other, std::size_t i) {
  if (!d.window.overlaps(other.window))
    return true;
  const Amount &a = d.values[i], &b = other.values[i];
  const bool same_start =
      d.relative == other.relative && (!d.relative || d.window.from == other.window.from);
  return same_start && a == b && (a == Amount() || d.curve == other.curve);
}

/// (displacements) nodes of each. Collective: to be called before anything may be thrown on one
/// rank.
std::vector<std::vector<Local>> prescribed_nodes(const Options& options, const mesh::Mesh& mesh) {
  std::vector<std::vector<Local>> nodes;
  for (const auto& d : options.displacements)
    nodes.push_back(nodes_of_set(mesh, d.set));
  return nodes;
}

} // namespace

void check_conflicts(const Options& options, const mesh::Mesh& mesh, const Where& where) {
  std::map<std::pair<Local, int>, std::vector<const DisplacementOptions*>> given;
  const auto nodes = prescribed_nodes(options, mesh);
  auto nodes_of = nodes.begin();
  for (const auto& d : options.displacements)
    for (Local n : *nodes_of++)
      for (int i = 0; i < 3; ++i) {
        if (!d.components[std::size_t(i)])
          continue;
        auto& others = given[{n, i}];
        for (const auto* other : others)
          if (!agree(d, *other, std::size_t(i)))
            throw InputError(where("displacements." + d.name) + ": node " +
                             std::to_string(mesh.node_id[n]) + " has its " + "xyz"[i] +
                             " displacement prescribed differently by '" + other->name + "'");
        others.push_back(&d);
      }
}

void check_rigid_nodes(const Options& options, const mesh::Mesh& mesh,
                       const std::vector<int>& body_of_node, const Where& where) {
  std::vector<std::string> rigid;
  for (const BodyOptions& body : options.bodies)
    if (body.rigid)
      rigid.push_back(body.name);
  const auto nodes = prescribed_nodes(options, mesh);
  auto nodes_of = nodes.begin();
  for (const auto& d : options.displacements)
    for (Local n : *nodes_of++)
      if (body_of_node[n] >= 0)
        throw InputError(where("displacements." + d.name) + ": node " +
                         std::to_string(mesh.node_id[n]) + " moves with rigid body '" +
                         rigid[std::size_t(body_of_node[n])] + "', which alone prescribes it");
}

std::vector<assembly::Constraint> make_constraints(const Options& options, const mesh::Mesh& mesh) {
  std::vector<assembly::Constraint> result;
  std::map<std::pair<Local, int>, std::vector<Window>> given;
  for (std::size_t group = 0; group < options.displacements.size(); ++group) {
    const DisplacementOptions& d = options.displacements[group];
    const auto curve = given_curve(options.curves, d.curve);
    for (Local n : nodes_of_set(mesh, d.set)) {
      if (n >= mesh.num_owned)
        continue;
      for (int i = 0; i < 3; ++i) {
        if (!d.components[std::size_t(i)])
          continue;
        std::vector<Window>& windows = given[{n, i}];
        if (std::find(windows.begin(), windows.end(), d.window) != windows.end())
          continue; // the same is prescribed already
        windows.push_back(d.window);
        const double* x = mesh.x.data() + 3 * std::size_t(n);
        result.push_back({n, i, history(d.values[std::size_t(i)], {{x[0], x[1], x[2]}}, curve),
                          d.window, d.relative, static_cast<int>(group)});
      }
    }
  }
  return result;
}

} // namespace abut::scene
