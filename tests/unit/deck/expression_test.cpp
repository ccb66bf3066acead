// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/deck/deck.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

using namespace abut;
using namespace abut::deck;

namespace {

const std::string head = "mesh: {file: a.exo}\n"
                         "materials: {steel: {young: 210, poisson: 0.3}}\n"
                         "bodies: {ball: {blocks: [1], material: steel}}\n";
const Vec3 place{{0.25, -2.0, 3.0}};

Amount amount(const std::string& text) {
  return parse_deck(head + "loads: {l: {side_set: s, pressure: " + text + "}}\n", "d.yaml")
      .loads.at(0)
      .pressure;
}

double value(const std::string& text, double t = 0.5) {
  return amount(text).at(place, t, {});
}

std::string error_of(const std::string& text) {
  try {
    value(text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

} // namespace

TEST(Expression, KnowsPlaceTimeAndFunctions) {
  const double x = place[0], y = place[1], z = place[2], t = 0.5;
  EXPECT_EQ(value("\"0.01*sin(pi*x)*t\""), 0.01 * std::sin(3.14159265358979323846 * x) * t);
  EXPECT_EQ(value("\"x + 10*y + 100*z + 1000*t\""), x + 10 * y + 100 * z + 1000 * t);
  EXPECT_EQ(value("\"abs(y) < 0.5 ? 1 : max(0, 1 - x^2)^2\""), std::pow(1 - x * x, 2));
  EXPECT_EQ(value("\"exp(-x)*(y <= -2)*(t >= 0.5)*(z == 3)*(x != 1)\""), std::exp(-x));
}

TEST(Expression, TakesACurveOnlyWhereOneIsGiven) {
  const auto twice = [](double t) { return 2.0 * t; };
  EXPECT_EQ(amount("\"3*y\"").at(place, 0.25, {}), -6.0);
  EXPECT_EQ(amount("\"3*y\"").at(place, 0.25, twice), -3.0);
  EXPECT_EQ(amount("8").at(place, 0.25, {}), 2.0);
  EXPECT_EQ(amount("8").at(place, 0.25, twice), 4.0);
}

TEST(Expression, StandsForEachComponentByItself) {
  const Deck d = parse_deck(head + "loads:\n"
                                   "  l: {side_set: s, traction: [1, \"2*x\", \"z*t\"]}\n"
                                   "displacements:\n"
                                   "  d: {set: s, x: \"x*y\", z: 4, fix: [y]}\n",
                            "d.yaml");
  EXPECT_EQ(d.loads[0].vector[0].at(place, 0.5, {}), 0.5);
  EXPECT_EQ(d.loads[0].vector[1].at(place, 0.5, {}), 0.5);
  EXPECT_EQ(d.loads[0].vector[2].at(place, 0.5, {}), 1.5);
  const auto& values = d.displacements[0].values;
  EXPECT_EQ(values[0].at(place, 0.5, {}), -0.5);
  EXPECT_EQ(values[1].at(place, 0.5, {}), 0.0);
  EXPECT_EQ(values[2].at(place, 0.5, {}), 2.0);
  const Deck again = parse_deck(to_yaml(d), "e.yaml");
  EXPECT_EQ(again.loads[0].vector, d.loads[0].vector);
  EXPECT_EQ(again.displacements[0].values, d.displacements[0].values);
  EXPECT_EQ(again.loads[0].vector[2].at(place, 0.5, {}), 1.5);
}

TEST(Expression, IsReadFromXml) {
  const Deck d = parse_deck(R"xml(<ParameterList name="deck">
  <ParameterList name="mesh"><Parameter name="file" type="string" value="a.exo"/></ParameterList>
  <ParameterList name="materials"><ParameterList name="m">
    <Parameter name="young" type="double" value="1"/>
    <Parameter name="poisson" type="double" value="0"/></ParameterList></ParameterList>
  <ParameterList name="bodies"><ParameterList name="b">
    <Parameter name="blocks" type="Array(string)" value="{b}"/>
    <Parameter name="material" type="string" value="m"/></ParameterList></ParameterList>
  <ParameterList name="loads"><ParameterList name="l">
    <Parameter name="body_force" type="Array(string)" value="{x*y, t, 1+z}"/>
    <Parameter name="block" type="string" value="b"/></ParameterList></ParameterList>
</ParameterList>)xml",
                            "d.xml");
  EXPECT_EQ(d.loads[0].vector[0].at(place, 0.5, {}), -0.5);
  EXPECT_EQ(d.loads[0].vector[2].at(place, 0.5, {}), 4.0);
}

TEST(Expression, ErrorsNameFileLineKeyAndWhatIsKnown) {
  const std::string key = "d.yaml:4: loads.l.pressure: ";
  const std::string unknown = error_of("\"2*sqr(x)\"");
  EXPECT_EQ(unknown.find(key + "expression '2*sqr(x)': unknown name 'sqr'; did you mean 'sqrt'? "
                               "valid: x, y, z, t, pi, "),
            0u)
      << unknown;
  EXPECT_EQ(error_of("\"1/(x - 0.25)\""),
            key + "expression '1/(x - 0.25)': not finite at x = 0.25, y = -2, z = 3, t = 0.5");
  EXPECT_EQ(error_of("\"x, y\""),
            key + "expression 'x, y': expected one value, got 2 separated by commas");
  EXPECT_EQ(error_of("\"x = 1\""), key + "expression 'x = 1': '=' assigns, comparison is '=='");
  for (const char* wrong : {"\"sin(x\"", "\"2*\"", "\"\"", "\"x y\"", "\"sin()\"", "\"1,5\""}) {
    const std::string message = error_of(wrong);
    EXPECT_EQ(message.find(key + "expression '"), 0u) << message;
  }
  EXPECT_EQ(error_of("\"2\""), key + "expected a number, got the text '2'");
  EXPECT_EQ(error_of("[1]"), key + "expected a number, got a list of 1 item");
}
