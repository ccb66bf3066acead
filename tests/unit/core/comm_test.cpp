// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/comm.hpp"
#include "abut/core/error.hpp"
#include "abut/core/machine_error.hpp"

#include <gtest/gtest.h>
#include <new>

using namespace abut;

TEST(Comm, Reductions) {
  const Comm comm(MPI_COMM_WORLD);
  const int n = comm.size(), r = comm.rank();
  EXPECT_EQ(comm.sum(Global(r + 1)), n * (n + 1) / 2);
  EXPECT_EQ(comm.max(double(r)), n - 1);
  EXPECT_EQ(comm.min(double(r)), 0);
  EXPECT_TRUE(comm.any(r == n - 1));
  EXPECT_FALSE(comm.any(false));
  EXPECT_EQ(comm.exclusive_scan(2), 2 * r);
}

TEST(Comm, ExchangeSendsEachRankItsOwn) {
  const Comm comm(MPI_COMM_WORLD);
  std::vector<std::vector<int>> send(std::size_t(comm.size()));
  for (int q = 0; q < comm.size(); ++q)
    send[std::size_t(q)].assign(std::size_t(q), 100 * comm.rank() + q);
  const auto got = comm.exchange(send);
  for (int q = 0; q < comm.size(); ++q) {
    ASSERT_EQ(got[std::size_t(q)].size(), std::size_t(comm.rank()));
    for (int v : got[std::size_t(q)])
      EXPECT_EQ(v, 100 * q + comm.rank());
  }
  const auto all = comm.gather(std::vector<int>{comm.rank()});
  EXPECT_EQ(all.size(), comm.is_root() ? std::size_t(comm.size()) : 0u);
}

TEST(Comm, AnErrorOnOneRankReachesAll) {
  const Comm comm(MPI_COMM_WORLD);
  const int last = comm.size() - 1;
  try {
    comm.together([&] {
      if (comm.rank() == last)
        throw InputError("from the last rank");
    });
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "from the last rank");
  }
  EXPECT_THROW(comm.on_root([] { throw SolveError("root"); }), SolveError);
  EXPECT_THROW(comm.together([&] {
    if (comm.rank() == last)
      throw std::bad_alloc();
  }),
               MachineError);
  // The user's mistake is reported before what follows from it.
  EXPECT_THROW(comm.together([&] {
    if (comm.rank() == last)
      throw InputError("input");
    throw SolveError("solve");
  }),
               InputError);
}
