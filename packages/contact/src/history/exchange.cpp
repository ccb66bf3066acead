// SPDX-License-Identifier: BSD-3-Clause
#include "history/exchange.hpp"

namespace abut::contact {

template <class V> void list_state(V& v, StoredTraction& t) {
  v(t.component, t.frame);
}
template <class V> void list_state(V& v, SiteIterate& i) {
  v(i.last.pressed, i.last.slips, i.last.line.direction, i.last.line.turning, i.frozen, i.rule,
    i.touching, i.flips);
}
template <class V> void list_state(V& v, SiteStart& s) {
  v(s.overlap, s.shift, s.fit);
}
template <class V> void list_state(V& v, PointHistory& h) {
  v(h.multiplier, h.carried, h.anchor, h.anchor_xi, h.rest, h.in_contact, h.torn, h.gap, h.rise,
    h.start, h.path, h.sliding, h.dissipated);
}
template <class V> void list_state(V& v, PointIterate& i) {
  v(i.site, i.near, i.near_xi, i.left, i.returns, i.losses);
}
template <class V> void list_state(V& v, NodeHistory& h) {
  v(h.multiplier, h.in_contact, h.gap, h.start, h.sliding);
}

namespace {

std::vector<Global> point_keys(const InterfaceData& data) {
  std::vector<Global> keys;
  for (Local i = 0; i < data.points.size(); ++i)
    keys.push_back(data.point_key(i));
  return keys;
}

/// Keys of the corners of faces, with the node that each is: nodes have no number of their own that
/// all ranks would know, and those of several faces are given more than once.
struct Corners {
  explicit Corners(const InterfaceData& data) {
    for (Local f = 0; f < data.primary().faces(); ++f)
      for (int a = 0; a < data.corners.corners(f); ++a) {
        keys.push_back(data.surface().face_id[std::size_t(f)] * max_corners + a);
        node.push_back(data.corners.nodes(f)[a]);
      }
  }

  template <class T>
  void exchange(StateArchive& archive, const std::string& name, const View<T>& of_nodes) const {
    std::vector<T> values;
    for (const Local n : node)
      values.push_back(of_nodes(n));
    archive.items(name, keys, values.data());
    for (std::size_t i = 0; i < node.size(); ++i)
      of_nodes(node[i]) = values[i];
  }

  std::vector<Global> keys;
  std::vector<Local> node;
};

void exchange_nodes(StateArchive& archive, const std::string& path, const InterfaceData& data,
                    const std::vector<Global>& points) {
  const NodalArrays& nodes = data.nodal->arrays();
  const Corners corners(data);
  corners.exchange(archive, path + "node_history", nodes.history);
  corners.exchange(archive, path + "node_iterate", nodes.iterate);
  Kokkos::deep_copy(nodes.converged, nodes.history);
  if (data.settings.friction == 0.0)
    return;
  std::vector<Global> keys;
  for (const Global point : points)
    for (int a = 0; a < max_corners; ++a)
      keys.push_back(point * max_corners + a);
  archive.items(path + "carried", keys, nodes.carried.data());
  Kokkos::deep_copy(nodes.carried_converged, nodes.carried);
}

} // namespace

void exchange_history(StateArchive& archive, const std::string& path, InterfaceData& data) {
  const std::vector<Global> points = point_keys(data);
  archive.items(path + "history", points, data.points.history.data());
  archive.items(path + "iterate", points, data.points.iterate.data());
  Kokkos::deep_copy(data.points.converged, data.points.history);
  if (data.settings.update_penalty)
    archive.items(path + "stretch", data.surface().face_id, data.primary().stretch.data());
  if (data.nodal)
    exchange_nodes(archive, path, data, points);
}

} // namespace abut::contact
