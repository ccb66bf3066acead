// SPDX-License-Identifier: BSD-3-Clause
#include "spaces/corner_space.hpp"

#include "abut/fem/face_map.hpp"

#include <algorithm>
#include <map>

namespace abut::contact {

CornerSpace::CornerSpace(const Comm& comm, const mesh::Surface& surface)
    : comm_(comm), surface_(surface), is_shared_(surface.node.size(), 0),
      owner_(surface.node.size(), comm.rank()) {
  const auto ranks = static_cast<std::size_t>(comm.size());
  // A node's home, picked by its number, tells every holder who the others are.
  std::vector<std::vector<Global>> held(ranks);
  std::map<Global, Local> here;
  for (Local n = 0; n < surface.num_nodes(); ++n) {
    const Global id = surface.node[n];
    here[id] = n;
    held[static_cast<std::size_t>(id) % ranks].push_back(id);
  }
  std::map<Global, std::vector<Global>> holders; // of the nodes at home here
  const auto asked = comm.exchange(held);
  for (std::size_t r = 0; r < ranks; ++r)
    for (Global id : asked[r])
      holders[id].push_back(static_cast<Global>(r));
  std::vector<std::vector<Global>> answer(ranks); // node, number of holders, holders
  for (const auto& [id, list] : holders)
    if (list.size() > 1)
      for (Global r : list) {
        auto& to = answer[static_cast<std::size_t>(r)];
        to.push_back(id);
        to.push_back(static_cast<Global>(list.size()));
        to.insert(to.end(), list.begin(), list.end());
      }
  std::map<int, std::map<Global, Local>> with; // rank -> shared nodes
  for (const auto& part : comm.exchange(answer))
    for (std::size_t i = 0; i < part.size(); i += 2 + static_cast<std::size_t>(part[i + 1])) {
      const Local n = here.at(part[i]);
      shared_.push_back(n);
      is_shared_[n] = 1;
      for (Global k = 0; k < part[i + 1]; ++k)
        with[static_cast<int>(part[i + 2 + static_cast<std::size_t>(k)])][part[i]] = n;
    }
  for (const auto& [rank, nodes] : with) {
    neighbours_.push_back({rank, {}});
    for (const auto& [id, n] : nodes) {
      neighbours_.back().nodes.push_back(n);
      owner_[n] = std::min(owner_[n], rank);
    }
  }
}

void CornerSpace::values(Local face, const double xi[2], double* N) const {
  fem::dispatch_face(fem::is_triangle(surface_.type[face]) ? fem::FaceType::tri3
                                                           : fem::FaceType::quad4,
                     [&](auto shape) { decltype(shape)::values(xi, N); });
}

double CornerSpace::interpolate(Local face, const double* N, const std::vector<double>& data,
                                int component, int components) const {
  double value = 0.0;
  for (int a = 0; a < corners(face); ++a)
    value += N[a] * data[static_cast<std::size_t>(nodes(face)[a] * components + component)];
  return value;
}

void CornerSpace::sum(double* data, int components) const {
  if (comm_.size() == 1)
    return;
  const auto at = [&](Local node) {
    return data + static_cast<std::ptrdiff_t>(node) * components;
  };
  std::vector<std::vector<double>> send(static_cast<std::size_t>(comm_.size()));
  for (const Neighbour& other : neighbours_)
    for (Local n : other.nodes)
      send[static_cast<std::size_t>(other.rank)].insert(
          send[static_cast<std::size_t>(other.rank)].end(), at(n), at(n) + components);
  const auto received = comm_.exchange(send);
  for (Local n : shared_)
    std::fill_n(at(n), components, 0.0);
  for (const Neighbour& other : neighbours_) { // in the order of ranks: the same digits everywhere
    const double* value = received[static_cast<std::size_t>(other.rank)].data();
    for (Local n : other.nodes)
      for (int c = 0; c < components; ++c)
        at(n)[c] += *value++;
  }
}

} // namespace abut::contact
