// SPDX-License-Identifier: BSD-3-Clause
#include <Tpetra_Core.hpp>
#include <cstdlib>
#include <gtest/gtest.h>

/// Runs GoogleTest under MPI; ranks other than the root print only failures. Exit status 77, which
/// ctest counts as skipped, when every test skipped itself.
int main(int argc, char** argv) {
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0); // see apps/abut/main.cpp
  Tpetra::ScopeGuard scope(&argc, &argv);
  ::testing::InitGoogleTest(&argc, argv);
  if (Tpetra::getDefaultComm()->getRank() != 0) {
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
