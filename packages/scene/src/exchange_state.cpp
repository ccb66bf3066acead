// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/trilinos.hpp"
#include "abut/scene/scene.hpp"

namespace abut::scene {

void exchange_state(StateArchive& archive, Scene& scene, Vector& x) {
  assembly::EquationSystem& equations = *scene.equations;
  equations.exchange_state(archive, x);
  const std::vector<double> u = equations.nodal_values(x);
  const NodalFields accepted{u.data(), 3, equations.time()};
  for (const auto& interface : scene.contacts)
    contact::exchange_state(archive, *interface, accepted);
  if (scene.inertia)
    scene.inertia->motion().exchange_state(archive, scene.mesh->node_input);
  if (!archive.takes())
    return;
  Vector f(x.getMap());
  scene.mesh->comm.together([&] { equations.residual(x, f); });
  equations.tangent(x); // its size tells what rounding makes of the residuals to come
}

} // namespace abut::scene
