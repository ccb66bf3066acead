// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/abaqus/import.hpp"
#include "abut/core/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

namespace abut::abaqus_test {

/// Two unit cubes on each other, nodes 1 to 8 and 11 to 18, elements 1 and 2.
inline const std::string cubes = R"(*NODE, NSET=ALL
 1, 0., 0., 0.
 2, 1., 0., 0.
 3, 1., 1., 0.
 4, 0., 1., 0.
 5, 0., 0., 1.
 6, 1., 0., 1.
 7, 1., 1., 1.
 8, 0., 1., 1.
11, 0., 0., 1.
12, 1., 0., 1.
13, 1., 1., 1.
14, 0., 1., 1.
15, 0., 0., 2.
16, 1., 0., 2.
17, 1., 1., 2.
18, 0., 1., 2.
*ELEMENT, TYPE=C3D8, ELSET=LOWER
1, 1, 2, 3, 4, 5, 6, 7, 8
*ELEMENT, TYPE=C3D8, ELSET=UPPER
2, 11, 12, 13, 14, 15, 16, 17, 18
*NSET, NSET=FOOT
1, 2, 3, 4
*NSET, NSET=HEAD, GENERATE
15, 18
*ELSET, ELSET=BOTH
LOWER, UPPER
*SURFACE, NAME=LID
LOWER, S2
*SURFACE, NAME=SOLE
2, S1
)";
inline const std::string material = R"(*MATERIAL, NAME=STEEL
*ELASTIC
1000., .3
*SOLID SECTION, ELSET=BOTH, MATERIAL=STEEL
)";
inline const std::string pair = R"(*CONTACT PAIR, INTERACTION=SOFT, TYPE=SURFACE TO SURFACE
SOLE, LID
*SURFACE INTERACTION, NAME=SOFT
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
5000.
)";
inline const std::string held = R"(*BOUNDARY
FOOT, 1, 3
HEAD, 1, 2
)";
inline const std::string step = R"(*STEP
*STATIC
*BOUNDARY
HEAD, 3, 3, -.01
*END STEP
)";
inline const std::string two_cubes = cubes + material + pair + held + step;

inline std::string with(std::string text, const std::string& old, const std::string& changed) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), changed);
}

inline abaqus::Scene scene_of(const std::string& text) {
  return abaqus::import(text, "a.inp", "a");
}

inline std::string error_of(const std::string& text) {
  try {
    scene_of(text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

inline void expect_line(const std::string& deck, const std::string& line) {
  EXPECT_NE(deck.find(line + "\n"), std::string::npos) << "no line '" << line << "' in\n" << deck;
}

} // namespace abut::abaqus_test
