// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/assembled_system.hpp"

namespace abut::solver {

std::vector<RowPlace> AssembledSystem::row_places() const {
  const std::vector<double> x = equations_.row_coordinates();
  std::vector<RowPlace> places(x.size() / 3);
  for (std::size_t i = 0; i < x.size(); ++i)
    places[i / 3].point[i % 3] = x[i];
  const rigid::Bodies& bodies = equations_.bodies();
  const auto fields = static_cast<std::size_t>(equations_.dofs().fields());
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (bodies.owns(b)) {
      const std::size_t row = bodies.first_owned_row(b) / fields;
      places[row].kind = multigrid::RowKind::translation;
      places[row + 1].kind = multigrid::RowKind::rotation;
      places[row + 1].unit = bodies.length(b);
    }
  return places;
}

} // namespace abut::solver
