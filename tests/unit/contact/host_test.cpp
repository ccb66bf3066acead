// SPDX-License-Identifier: BSD-3-Clause
// The host of docs/developer/hosts.md: two passes, friction and multipliers from options alone.
#include "plate_on_springs.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

TEST(Host, PressesAndShearsAPlateByOptionsAlone) {
  const host::Answer answer = host::press_and_shear(abut::Comm(MPI_COMM_WORLD));
  EXPECT_EQ(answer.interfaces, 2);
  EXPECT_GT(answer.augmentations, 0);
  EXPECT_GT(answer.slipping, 0);
  EXPECT_NEAR(answer.pressing, 20.0, host::force_tolerance);
  EXPECT_NEAR(answer.shearing, 6.0, host::force_tolerance);
  EXPECT_NEAR(answer.shift, 0.01, host::force_tolerance / 4000.0);
}
