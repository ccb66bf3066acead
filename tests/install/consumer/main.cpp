// SPDX-License-Identifier: BSD-3-Clause
// A host code with meshes, equations and solver of its own takes the contact component alone: a
// unit square held 0.01 inside another, penalty 100, so pressure 1, force 1 and stiffness 100; and
// the plate of plate_on_springs.hpp, solved.
#include "abut/contact/interaction.hpp"
#include "plate_on_springs.hpp"

#include <Kokkos_Core.hpp>
#include <cmath>
#include <cstdio>

namespace {

bool close(double value, double expected) {
  return std::fabs(value - expected) < 1e-10;
}

bool contact_is_right(const abut::Comm& comm) {
  abut::contact::ContactOptions options;
  options.name = "press";
  options.penalty = 100.0;
  abut::PhaseTimers timers;
  abut::contact::Interaction contact(comm, host::square(comm, 0, -0.01, false, 0),
                                     host::square(comm, comm.size() - 1, 0.0, true, 4), options, timers);
  const std::vector<double> displacement(8 * 3, 0.0);
  const abut::NodalFields fields{displacement.data(), 3, 0.0};
  contact.prepare(fields);

  // One pair on the primary's rank: its eight nodes are the rows of a dense system.
  const abut::Local pairs = contact.connectivity().cells();
  if (pairs != (comm.is_root() ? 1 : 0))
    return false;
  constexpr int nodes = 8, size = 3 * nodes;
  std::vector<double> force(size, 0.0), stiffness(size * size, 0.0);
  std::vector<abut::Local> row(nodes), row_length(nodes, size);
  std::vector<std::int64_t> position(nodes * nodes);
  for (int a = 0; a < nodes; ++a) {
    row[a] = a;
    for (int b = 0; b < nodes; ++b)
      position[a * nodes + b] = 3 * (size * a + b);
  }
  const abut::Local offset[] = {0, nodes};
  const std::int64_t block_offset[] = {0, nodes * nodes};
  contact.residual(fields, {3, offset, row.data(), force.data()});
  contact.tangent(fields, {3, offset, row.data(), block_offset, position.data(), row_length.data(),
                           stiffness.data()});

  double on_primary = 0.0, on_secondary = 0.0, spring = 0.0;
  for (int a = 0; a < nodes; ++a)
    (a < 4 ? on_primary : on_secondary) += force[3 * a + 2];
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      spring += stiffness[size * (3 * a + 2) + 3 * b + 2];
  const double expected = comm.is_root() ? 1.0 : 0.0;
  const auto summary = contact.summary();
  return close(on_primary, -expected) && close(on_secondary, expected) &&
         close(spring, 100.0 * expected) && close(summary.force[2], 1.0) &&
         close(summary.max_pressure, 1.0) && close(summary.max_penetration, 0.01);
}

} // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  bool right = false;
  {
    const Kokkos::ScopeGuard kokkos(argc, argv);
    const abut::Comm comm(MPI_COMM_WORLD);
    const host::Answer plate = host::press_and_shear(comm);
    constexpr double off = host::force_tolerance;
    const bool plate_is_right =
        close(plate.shift, 0.01) && std::fabs(plate.pressing - 20.0) < off &&
        std::fabs(plate.shearing - 6.0) < off && plate.interfaces == 2 &&
        plate.augmentations > 0 && plate.slipping > 0;
    right = !comm.any(!contact_is_right(comm)) && plate_is_right;
    if (comm.is_root())
      std::puts(right ? "consumer: all right" : "consumer: wrong contact values");
  }
  MPI_Finalize();
  return right ? 0 : 1;
}
