// SPDX-License-Identifier: BSD-3-Clause
// How many collective operations one residual costs: on many ranks each waits for the slowest.
#include "abut/core/trilinos.hpp"
#include "abut/meshgen/generators.hpp"
#include "abut/scene/scene.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

namespace {
int collectives = 0;
}

// The profiling interface of MPI: every call of these goes through here first.
#define ABUT_COUNTED(name, parameters, arguments)                                                  \
  extern "C" int MPI_##name parameters {                                                           \
    ++collectives;                                                                                 \
    return PMPI_##name arguments;                                                                  \
  }
ABUT_COUNTED(Allreduce, (const void* in, void* out, int n, MPI_Datatype t, MPI_Op op, MPI_Comm c),
             (in, out, n, t, op, c))
ABUT_COUNTED(Alltoall,
             (const void* in, int n, MPI_Datatype t, void* out, int m, MPI_Datatype u, MPI_Comm c),
             (in, n, t, out, m, u, c))
ABUT_COUNTED(Alltoallv,
             (const void* in, const int n[], const int i[], MPI_Datatype t, void* out,
              const int m[], const int o[], MPI_Datatype u, MPI_Comm c),
             (in, n, i, t, out, m, o, u, c))
ABUT_COUNTED(Allgather,
             (const void* in, int n, MPI_Datatype t, void* out, int m, MPI_Datatype u, MPI_Comm c),
             (in, n, t, out, m, u, c))
ABUT_COUNTED(Bcast, (void* data, int n, MPI_Datatype t, int root, MPI_Comm c),
             (data, n, t, root, c))

namespace {

using namespace abut;

/// One block on another, with friction.
scene::Options blocks(contact::Multipliers multipliers) {
  scene::Options o;
  o.materials.resize(1);
  o.materials[0].name = "rubber";
  o.materials[0].young = 2.0;
  for (const char* name : {"lower", "upper"}) {
    scene::BodyOptions& body = o.bodies.emplace_back();
    body.name = name;
    body.blocks = {name};
    body.material = "rubber";
  }
  contact::ContactOptions& c = o.contact.emplace_back();
  c.name = "pair";
  c.primary = "upper_bottom";
  c.secondary = "lower_top";
  c.friction = 0.3;
  c.enforcement = contact::Enforcement::augmented_lagrangian;
  c.multipliers = multipliers;
  return o;
}

/// Of a residual at unknowns that have moved a little, with the pattern and the faces that are
/// there.
int count(contact::Multipliers multipliers) {
  const Comm comm(MPI_COMM_WORLD);
  meshgen::BlockPairOptions o;
  o.gap = -0.01;
  const auto mesh = std::make_shared<const mesh::Mesh>(
      mesh::distribute(comm.is_root() ? meshgen::block_pair(o) : mesh::MeshData{}, comm));
  PhaseTimers timers;
  scene::Scene s = scene::build_scene(blocks(multipliers), mesh, timers,
                                      [](const std::string& path) { return path; });
  Vector x(s.equations->dofs().map()), f(x.getMap());
  s.equations->residual(x, f);
  x.putScalar(1e-4);
  collectives = 0;
  s.equations->residual(x, f);
  const int found = collectives;
  EXPECT_GT(s.contacts.at(0)->summary().active_points, 0);
  return found;
}

} // namespace

TEST(Collectives, OfOneResidual) {
  const int at_points = count(contact::Multipliers::per_point);
  const int at_nodes = count(contact::Multipliers::dual);
  std::printf("collectives of one residual: %d with the law at points, %d at nodes\n", at_points,
              at_nodes);
  EXPECT_GT(at_points, 3) << "they are counted";
  // Of these 4 sum forces of nodes that ranks share, 3 let all ranks fail together, 3 follow the
  // surfaces, 2 ask whether anything has moved or left the pattern, 1 sums norms.
  EXPECT_LE(at_points, 13);
  EXPECT_LE(at_nodes, 15); // and 2 send the rows of nodes that ranks share
}
