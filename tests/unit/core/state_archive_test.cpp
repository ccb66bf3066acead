// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/core/state_archive.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace {

using abut::Comm;
using abut::Global;
using abut::InputError;
using abut::StateArchive;

enum class Word : signed char { one, two, three };

struct Thing {
  Word word = Word::one;
  bool flag = false;
  Global id = -1;
  double pair[2] = {0.0, 0.0};
  abut::Vec3 place = abut::Vec3::zero();
};

template <class V> void list_state(V& v, Thing& t) {
  v(t.word, t.flag, t.id, t.pair, t.place);
}

Thing thing(Global key) {
  const auto x = static_cast<double>(key);
  return {key % 2 ? Word::three : Word::two,
          key % 3 == 0,
          (Global(1) << 53) - key,
          {x, 1.0 / 3.0 * x},
          {{-x, 0.1, std::numeric_limits<double>::denorm_min()}}};
}

/// What rank r of n holds of 20 rows; neighbours share one.
std::vector<Global> keys_of(const Comm& comm, int offset) {
  std::vector<Global> keys;
  for (Global key = 0; key < 20; ++key)
    if ((key / 3 + offset) % comm.size() == comm.rank() ||
        (key % 3 == 0 && (key / 3 + offset + 1) % comm.size() == comm.rank()))
      keys.insert(keys.begin(), 7 * key); // in no order
  return keys;
}

std::vector<StateArchive::Array> written(const Comm& comm) {
  StateArchive archive(comm);
  const std::vector<Global> keys = keys_of(comm, 0);
  std::vector<Thing> things;
  for (const Global key : keys)
    things.push_back(thing(key));
  archive.items("things", keys, things.data());
  std::vector<double> list{1.0, 2.0};
  std::array<bool, 2> flags{true, false};
  archive.numbers("numbers", [&](auto& v) { v(list, flags); });
  return archive.gathered();
}

TEST(StateArchive, GivesEveryRankItsRowsWhereverTheyWere) {
  const Comm comm(MPI_COMM_WORLD);
  StateArchive archive(comm, written(comm));
  const std::vector<Global> keys = keys_of(comm, 1);
  std::vector<Thing> things(keys.size());
  archive.items("things", keys, things.data());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Thing expected = thing(keys[i]);
    EXPECT_EQ(things[i].word, expected.word);
    EXPECT_EQ(things[i].flag, expected.flag);
    EXPECT_EQ(things[i].id, expected.id);
    EXPECT_EQ(things[i].pair[1], expected.pair[1]);
    EXPECT_EQ(things[i].place[2], expected.place[2]);
  }
  std::vector<double> list;
  std::array<bool, 2> flags{};
  archive.numbers("numbers", [&](auto& v) { v(list, flags); });
  EXPECT_EQ(list, (std::vector<double>{1.0, 2.0}));
  EXPECT_TRUE(flags[0] && !flags[1]);
}

TEST(StateArchive, RowsAreSortedAndThereOnce) {
  const Comm comm(MPI_COMM_WORLD);
  const auto arrays = written(comm);
  ASSERT_EQ(arrays.size(), comm.is_root() ? 2u : 0u);
  if (!comm.is_root())
    return;
  ASSERT_EQ(arrays[0].keys.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i)
    EXPECT_EQ(arrays[0].keys[i], static_cast<Global>(7 * i));
  EXPECT_EQ(arrays[0].values.size(), 20u * static_cast<std::size_t>(arrays[0].width));
}

TEST(StateArchive, RefusesOnAllRanksWhatItDoesNotHold) {
  const Comm comm(MPI_COMM_WORLD);
  StateArchive archive(comm, written(comm));
  Thing none;
  double number = 0.0;
  EXPECT_FALSE(archive.holds("others"));
  EXPECT_THROW(archive.items("others", {}, &none), InputError);
  const std::vector<Global> missing(comm.is_root() ? 1 : 0, Global(3)); // on one rank alone
  EXPECT_THROW(archive.items("things", missing, &none), InputError);
  EXPECT_THROW(archive.items("things", {}, &number), InputError) << "another width";
  EXPECT_THROW(archive.numbers("numbers", [&](auto& v) { v(number); }), InputError);
}

} // namespace
