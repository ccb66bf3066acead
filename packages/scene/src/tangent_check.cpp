// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/tangent_check.hpp"

#include "abut/assembly/tangent_check.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace abut::scene {

namespace {

constexpr double step_share = 1e-7; ///< of the mesh's extent: differences are good to some 1e-7
constexpr double suspicious = 1e-4; ///< relative error beyond what differences explain

double extent(const mesh::Mesh& mesh) {
  double diagonal = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    double low = 1e300, high = -1e300;
    for (std::size_t n = i; n < mesh.x.size(); n += 3) {
      low = std::min(low, mesh.x[n]);
      high = std::max(high, mesh.x[n]);
    }
    diagonal += std::pow(mesh.comm.max(high) - mesh.comm.min(low), 2);
  }
  return std::sqrt(diagonal);
}

} // namespace

solver::AugmentCallback with_tangent_check(Scene& scene, solver::AugmentCallback then,
                                           std::function<void(const std::string&)> print) {
  const double step = step_share * extent(*scene.mesh);
  return [&scene, then = std::move(then), print = std::move(print), step](int number) {
    for (const auto& contact : scene.contacts)
      contact->set_exact_tangent(true);
    const auto mismatches = assembly::check_tangent(*scene.equations, step);
    for (const auto& contact : scene.contacts)
      contact->set_exact_tangent(false);
    for (const assembly::TangentMismatch& m : mismatches) {
      std::string text = fmt::format("tangent of {:<24} error {:.1e}", m.part, m.error);
      if (m.node >= 0)
        text += fmt::format("  worst at node {} {}", m.node, "xyz"[m.field]);
      if (m.error > suspicious)
        text += "  (a change of status within the differences, or a wrong tangent)";
      print(text);
    }
    return then ? then(number) : solver::AugmentReport();
  };
}

} // namespace abut::scene
