// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/mesh/mesh.hpp"

namespace abut::mesh {

GhostExchange::GhostExchange(const Mesh& mesh) : comm_(mesh.comm) {
  const std::size_t ranks = static_cast<std::size_t>(comm_.size());
  std::vector<std::vector<Global>> wanted(ranks);
  receive_.resize(ranks);
  send_.resize(ranks);
  for (Local i = mesh.num_owned; i < mesh.num_local(); ++i) {
    const int owner = mesh.owner(mesh.node[i]);
    wanted[owner].push_back(mesh.node[i]);
    receive_[owner].push_back(i);
  }
  const auto asked = comm_.exchange(wanted);
  for (std::size_t r = 0; r < ranks; ++r)
    for (Global n : asked[r]) {
      ABUT_REQUIRE(mesh.owner(n) == comm_.rank(), "asked for another rank's node");
      send_[r].push_back(static_cast<Local>(n - mesh.first_node[comm_.rank()]));
    }
}

void GhostExchange::update(double* values, int width) const {
  std::vector<std::vector<double>> out(send_.size());
  for (std::size_t r = 0; r < send_.size(); ++r)
    for (Local i : send_[r]) {
      const double* v = values + static_cast<std::size_t>(i) * width;
      out[r].insert(out[r].end(), v, v + width);
    }
  const auto in = comm_.exchange(out);
  for (std::size_t r = 0; r < receive_.size(); ++r)
    for (std::size_t k = 0; k < receive_[r].size(); ++k)
      for (int w = 0; w < width; ++w)
        values[static_cast<std::size_t>(receive_[r][k]) * width + w] = in[r][k * width + w];
}

} // namespace abut::mesh
