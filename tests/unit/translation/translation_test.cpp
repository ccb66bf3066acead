// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/translation/report.hpp"
#include "abut/translation/utf8.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::translation;

TEST(Report, PlacesAreLinesOrBytes) {
  Report report;
  report.add({7, "here", Fate::refused, "why"});
  EXPECT_EQ(report.text("f"), "f: 0 constructs used, 0 ignored because harmless, 1 refused\n"
                              "refused  line 7  here: why\n");
  const auto error = [&] {
    try {
      report.require_nothing_refused("f");
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(error(), "f:7: here: why");
  report.count_bytes(true);
  EXPECT_EQ(error(), "f: byte 7: here: why");
}

TEST(Utf8, StaysOrIsTakenForLatin1) {
  EXPECT_EQ(utf8("plain"), "plain");
  EXPECT_EQ(utf8("\xC3\xA4"), "\xC3\xA4");
  EXPECT_EQ(utf8("\xE4"), "\xC3\xA4");
  EXPECT_EQ(utf8("\xED\xA0\x80"), "\xC3\xAD\xC2\xA0\xC2\x80"); // half of a pair is no character
}
