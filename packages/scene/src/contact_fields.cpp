// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/contact_fields.hpp"

namespace abut::scene {

ContactFields contact_fields(const mesh::Mesh& mesh,
                             const std::vector<std::shared_ptr<contact::Interaction>>& contacts) {
  constexpr std::size_t width = 7; // weight, pressure, gap, status, traction
  std::vector<double> sums(width * mesh.node.size(), 0.0);
  for (const auto& contact : contacts) {
    const contact::NodalSums of_face_nodes = contact->nodal_sums();
    for (std::size_t i = 0; i < of_face_nodes.weight.size(); ++i) {
      double* sum = &sums[width * std::size_t(contact->primary().field_index[i])];
      sum[0] += of_face_nodes.weight[i];
      sum[1] += of_face_nodes.pressure[i];
      sum[2] += of_face_nodes.gap[i];
      sum[3] += of_face_nodes.status[i];
      for (std::size_t k = 0; k < 3; ++k)
        sum[4 + k] += of_face_nodes.traction[3 * i + k];
    }
  }
  mesh::node_exchange(mesh).add_to_owners(sums.data(), int(width));
  const auto owned = static_cast<std::size_t>(mesh.num_owned);
  ContactFields f;
  f.pressure.assign(owned, 0.0);
  f.gap = f.status = f.pressure;
  f.traction.assign(3 * owned, 0.0);
  for (std::size_t n = 0; n < owned; ++n) {
    const double* sum = &sums[width * n];
    if (sum[0] <= 0.0)
      continue;
    f.pressure[n] = sum[1] / sum[0];
    f.gap[n] = sum[2] / sum[0];
    f.status[n] = sum[3] <= 0.0 ? 0.0 : sum[3] < 1.5 * sum[0] ? 1.0 : 2.0;
    for (std::size_t k = 0; k < 3; ++k)
      f.traction[3 * n + k] = sum[4 + k] / sum[0];
  }
  return f;
}

} // namespace abut::scene
