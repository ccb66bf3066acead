// SPDX-License-Identifier: BSD-3-Clause
#include <Kokkos_Core.hpp>
#include <cstdlib>
#include <gtest/gtest.h>
#include <mpi.h>

namespace {

/// Exit status 77, which ctest counts as skipped, when every test skipped itself.
int run_tests() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank != 0) {
    auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
  }
  const int failed = RUN_ALL_TESTS();
  int any = failed;
  MPI_Allreduce(&failed, &any, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  const auto& all = *::testing::UnitTest::GetInstance();
  constexpr int all_skipped = 77;
  const bool none_ran = all.skipped_test_count() > 0 && all.successful_test_count() == 0;
  return any == 0 && none_ran ? all_skipped : any;
}

} // namespace

/// Runs GoogleTest under MPI; ranks other than the root print only failures.
int main(int argc, char** argv) {
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0); // see apps/abut/process_start.cpp
  MPI_Init(&argc, &argv);
  int status = 0;
  {
    const Kokkos::ScopeGuard kokkos(argc, argv);
    ::testing::InitGoogleTest(&argc, argv);
    status = run_tests();
  }
  MPI_Finalize();
  return status;
}
