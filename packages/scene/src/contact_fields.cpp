// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/contact_fields.hpp"

#include <algorithm>
#include <limits>

namespace abut::scene {

namespace {

enum Column { pressed, status, seen, gap, pressure, traction, columns = traction + 3 };

/// One side of one interface.
struct Side {
  const mesh::Surface* surface = nullptr;
  std::vector<double> area;     ///< (face nodes) of each face in each of its nodes
  std::vector<char> presses_at; ///< (N) this rank's nodes, ghosts included
};

/// Sums of one side at all nodes of this rank, complete at owned ones: (N, columns).
std::vector<double> sums_at_nodes(const contact::NodalSums& s, std::size_t nodes,
                                  const NodeExchange& exchange) {
  const mesh::Surface& surface = *s.surface;
  std::vector<double> sums(columns * nodes, 0.0);
  for (std::size_t i = 0; i < surface.node.size(); ++i) {
    double* sum = &sums[columns * std::size_t(surface.field_index[i])];
    sum[pressed] = s.pressed[i];
    sum[status] = s.status[i];
    sum[seen] = s.seen[i];
    sum[gap] = s.gap[i];
    sum[pressure] = s.share * s.pressure[i];
    for (std::size_t k = 0; k < 3; ++k)
      sum[traction + k] = s.share * s.traction[3 * i + k];
  }
  exchange.add_to_owners(sums.data(), columns);
  return sums;
}

/// Adds a side to the fields, whose pressure and traction are forces as yet.
void add(const std::vector<double>& sums, ContactFields& f) {
  for (std::size_t n = 0; n < f.pressure.size(); ++n) {
    const double* sum = &sums[columns * n];
    f.pressure[n] += sum[pressure];
    for (std::size_t k = 0; k < 3; ++k)
      f.traction[3 * n + k] += sum[traction + k];
    if (sum[seen] > 0.0)
      f.gap[n] = std::min(f.gap[n], sum[gap] / sum[seen]);
    if (sum[pressed] > 0.0)
      f.status[n] = std::max(f.status[n], sum[status] < 1.5 * sum[pressed] ? 1.0 : 2.0);
  }
}

std::vector<char> pressed_nodes(std::vector<double> sums, std::size_t nodes,
                                const NodeExchange& exchange) {
  exchange.to_ghosts(sums.data(), columns);
  std::vector<char> result(nodes);
  for (std::size_t n = 0; n < nodes; ++n)
    result[n] = sums[columns * n + pressed] > 0.0;
  return result;
}

/// Area at this rank's nodes of the faces of sides that press there: (N), complete at owned ones.
std::vector<double> pressed_area(const std::vector<Side>& sides, std::size_t nodes,
                                 const NodeExchange& exchange) {
  struct Face {
    Global id;
    const Side* side;
    Local index;
  };
  std::vector<Face> faces;
  for (const Side& s : sides)
    for (Local f = 0; f < s.surface->num_faces(); ++f)
      faces.push_back({s.surface->face_id[f], &s, f});
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Face& a, const Face& b) { return a.id < b.id; });
  std::vector<double> area(nodes, 0.0);
  for (auto first = faces.begin(), last = first; first != faces.end(); first = last) {
    last = std::find_if(first, faces.end(), [&](const Face& f) { return f.id != first->id; });
    const mesh::Surface& surface = *first->side->surface;
    const Local count = surface.offset[first->index + 1] - surface.offset[first->index];
    for (Local a = 0; a < count; ++a) {
      const auto n =
          std::size_t(surface.field_index[surface.nodes[surface.offset[first->index] + a]]);
      const auto presses =
          std::find_if(first, last, [&](const Face& f) { return f.side->presses_at[n] != 0; });
      if (presses != last)
        area[n] += presses->side->area[presses->side->surface->offset[presses->index] + a];
    }
  }
  exchange.add_to_owners(area.data());
  return area;
}

} // namespace

ContactFields contact_fields(const mesh::Mesh& mesh,
                             const std::vector<std::shared_ptr<contact::Interaction>>& contacts) {
  const auto owned = static_cast<std::size_t>(mesh.num_owned), nodes = mesh.node.size();
  const NodeExchange exchange = mesh::node_exchange(mesh);
  constexpr double none = std::numeric_limits<double>::max();
  ContactFields f;
  f.pressure.assign(owned, 0.0);
  f.status = f.pressure;
  f.traction.assign(3 * owned, 0.0);
  f.gap.assign(owned, none);
  std::vector<Side> sides;
  for (const auto& c : contacts)
    for (const contact::Side side : {contact::Side::primary, contact::Side::secondary}) {
      const contact::NodalSums s = c->nodal_sums(side);
      const std::vector<double> sums = sums_at_nodes(s, nodes, exchange);
      add(sums, f);
      sides.push_back({s.surface, s.area, pressed_nodes(sums, nodes, exchange)});
    }
  const std::vector<double> area = pressed_area(sides, nodes, exchange);
  for (std::size_t n = 0; n < owned; ++n) {
    const double per_area = area[n] > 0.0 ? 1.0 / area[n] : 0.0;
    f.pressure[n] *= per_area;
    for (std::size_t k = 0; k < 3; ++k)
      f.traction[3 * n + k] *= per_area;
    f.gap[n] = f.gap[n] == none ? 0.0 : f.gap[n];
  }
  return f;
}

} // namespace abut::scene
