// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/deck/parse.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_XMLParameterListCoreHelpers.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace abut;
using namespace abut::deck;
using testing::HasSubstr;
using testing::StartsWith;

namespace {

std::string error_of(const std::string& text, const std::string& file) {
  try {
    parse(text, file);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

} // namespace

TEST(Yaml, KeepsOrderKindsAndPlaces) {
  const Value top = parse_yaml("b: 1\na:\n  - x\n  - \"2\"\nc:\n", "d.yaml");
  ASSERT_EQ(top.entries.size(), 3u);
  EXPECT_EQ(top.entries[0].key, "b");
  EXPECT_EQ(top.entries[0].value.text, "1");
  EXPECT_FALSE(top.entries[0].value.quoted);
  const Value& list = top.entries[1].value;
  ASSERT_EQ(list.items.size(), 2u);
  EXPECT_EQ(list.items[1].where.text(), "d.yaml:4");
  EXPECT_EQ(list.items[1].where.column, 5);
  EXPECT_TRUE(list.items[1].quoted);
  EXPECT_EQ(top.entries[2].where.line, 5);
  EXPECT_EQ(top.entries[2].value.kind, Value::Kind::nothing);
  EXPECT_EQ(top.find("zz"), nullptr);
}

TEST(Yaml, ResolvesAliasesAndMergeKeys) {
  const Value top = parse_yaml("a: &a {x: 1, y: 2}\nb: *a\nc: {<<: *a, y: 3}\n", "d.yaml");
  EXPECT_EQ(top.find("b")->value.find("y")->value.text, "2");
  const Value& merged = top.find("c")->value;
  ASSERT_EQ(merged.entries.size(), 2u);
  EXPECT_EQ(merged.find("x")->value.text, "1");
  EXPECT_EQ(merged.find("y")->value.text, "3");
}

TEST(Yaml, ErrorsNameFileAndLine) {
  EXPECT_THAT(error_of("a: 1\nb: [1, 2\nc: 3\n", "d.yaml"),
              testing::ContainsRegex("^d.yaml:[34]: not valid YAML"));
  EXPECT_EQ(error_of("a: 1\nb: 2\na: 3\n", "d.yaml"),
            "d.yaml:3: key 'a' is given twice, first in line 1");
  EXPECT_THAT(error_of("- a\n- b\n", "d.yaml"),
              StartsWith("d.yaml:1: the top level must be a map (key: value), got a list of 2"));
  EXPECT_THAT(error_of("just words", "d.yaml"), HasSubstr("got 'just words'"));
  EXPECT_EQ(error_of("", "d.yaml"), "d.yaml:1: the deck is empty");
  EXPECT_EQ(error_of("# only this\n", "d.yaml"), "d.yaml:1: the deck is empty");
  EXPECT_THAT(error_of("a: 1\n---\nb: 2\n", "d.yaml"),
              HasSubstr("d.yaml:2: a second YAML document begins here"));
  // yaml-cpp itself would read documents for ever.
  EXPECT_THAT(error_of("{a: 1},\nb: {c: 2}}\n", "d.yaml"),
              HasSubstr("a bracket too many before it"));
  EXPECT_THAT(error_of("a: 1\n[1]: 2\n", "d.yaml"), StartsWith("d.yaml:2: a key must be a word"));
  EXPECT_THAT(error_of("a: *nowhere\n", "d.yaml"), StartsWith("d.yaml:1: not valid YAML"));
}

TEST(Yaml, EndlessAndExplodingAliasesEnd) {
  EXPECT_THAT(error_of("a: &a [*a]\n", "d.yaml"), HasSubstr("d.yaml:1"));
  std::string bomb = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 12; ++i) {
    const std::string below = "*a" + std::to_string(i - 1);
    std::string row = "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + below;
    for (int j = 0; j < 9; ++j)
      row += ", " + below;
    bomb += row + "]\n";
  }
  EXPECT_THAT(error_of(bomb, "d.yaml"), HasSubstr("too many values"));
  EXPECT_THAT(error_of("a: " + std::string(100000, '['), "d.yaml"), HasSubstr("d.yaml:1"));
}

TEST(Xml, GivesTypesAndLines) {
  const Value top =
      parse_xml("<ParameterList name=\"top\">\n"
                "  <!-- <Parameter name=\"b\" -->\n"
                "  <ParameterList name=\"a\">\n"
                "    <Parameter\n"
                "      name=\"x &lt; 1\" type=\"double\" value=\"2\"/>\n"
                "    <Parameter name='s' type='string' value='7'/>\n"
                "  </ParameterList>\n"
                "  <Parameter name=\"t\" type=\"TwoDArray(int)\" value=\"1x2:{3,4}\"/>\n"
                "</ParameterList>\n",
                "d.xml");
  ASSERT_EQ(top.entries.size(), 2u);
  const Value& a = top.find("a")->value;
  EXPECT_EQ(top.find("a")->where.line, 3);
  EXPECT_EQ(a.find("x < 1")->where.line, 4);
  EXPECT_EQ(a.find("x < 1")->value.text, "2.0");
  EXPECT_TRUE(a.find("s")->value.quoted);
  EXPECT_EQ(a.find("s")->where.line, 6);
  ASSERT_EQ(top.find("t")->value.items.size(), 1u);
  EXPECT_EQ(top.find("t")->value.items[0].items[1].text, "4");
}

TEST(Xml, ErrorsNameFileAndLine) {
  const std::string open = "<ParameterList name=\"d\">\n";
  EXPECT_EQ(error_of(open + "<ParameterList name=\"a\">\n</ParameterList>\n", "d.xml"),
            "d.xml:1: not valid XML: <ParameterList> is never closed");
  EXPECT_EQ(error_of(open + "</Parameter>\n", "d.xml"),
            "d.xml:2: not valid XML: </Parameter> closes <ParameterList> of line 1");
  EXPECT_EQ(error_of(open + "<Parameter name=\"a\" type=\"int\" value=\"1\"/>\n"
                            "<Parameter name=\"a\" type=\"int\" value=\"1\"/></ParameterList>",
                     "d.xml"),
            "d.xml:3: key 'a' is given twice, first in line 2");
  EXPECT_THAT(
      error_of(open + "<Parameter name=a type=\"int\" value=\"1\"/></ParameterList>", "d.xml"),
      StartsWith("d.xml:2: not valid XML: the value of 'name' needs quotes"));
  EXPECT_THAT(error_of("words", "d.xml"), StartsWith("d.xml:1: not valid XML: expected one <Para"));
  EXPECT_THAT(error_of("<!-- open", "d.xml"), HasSubstr("no '-->' ends what begins here"));
  const auto typed = [&](const std::string& type, const std::string& value) {
    return error_of(open + "<Parameter name=\"a\" type=\"" + type + "\" value=\"" + value +
                        "\"/></ParameterList>",
                    "d.xml");
  };
  EXPECT_THAT(typed("colour", "1"), StartsWith("d.xml:2: a: unknown type 'colour'; valid: int"));
  EXPECT_EQ(typed("int", "x"), "d.xml:2: a: expected type int, got 'x'");
  EXPECT_EQ(typed("int", "5000000000"), "d.xml:2: a: expected type int, got '5000000000'");
  EXPECT_EQ(typed("double", "1,5"), "d.xml:2: a: expected type double, got '1,5'");
  EXPECT_EQ(typed("bool", "maybe"), "d.xml:2: a: expected type bool, got 'maybe'");
  EXPECT_EQ(typed("Array(double)", "{1, x}"), "d.xml:2: a: expected type double, got ' x'");
  EXPECT_EQ(typed("Array(int)", "1, 2"),
            "d.xml:2: a: expected Array(int) as {a, b, ...}, got '1, 2'");
  EXPECT_THAT(typed("TwoDArray(double)", "3x2:{1, 2}"), StartsWith("d.xml:1: not a valid Param"));
}

TEST(Parse, KindByExtensionThenByFirstCharacter) {
  const std::string xml = "\n <ParameterList name=\"d\"/>";
  EXPECT_EQ(parse(xml, "deck").kind, Value::Kind::map);
  EXPECT_EQ(parse("a: 1", "deck").entries.size(), 1u);
  EXPECT_THROW(parse(xml, "deck.yaml"), InputError);
  EXPECT_THROW(parse("a: 1", "deck.xml"), InputError);
}

TEST(Numbers, AreReadWholeAndPrintedExactly) {
  double x = 0.0;
  for (const char* good : {"1", "-1.5", "+2", "1e-3", ".5", "1.", "1E5"})
    EXPECT_TRUE(parse_number(good, x)) << good;
  for (const char* bad : {"", "+", "abc", "1 2", "1,5", "0x10", "inf", "nan", "+-1", "1e999"})
    EXPECT_FALSE(parse_number(bad, x)) << bad;
  long long n = 0;
  EXPECT_TRUE(parse_number("1e5", n));
  EXPECT_EQ(n, 100000);
  EXPECT_FALSE(parse_number("1.5", n));
  EXPECT_FALSE(parse_number("1e300", n));
  for (const double value : {0.1, 1e-8, 10.0, -1.0 / 3.0, 1e300}) {
    ASSERT_TRUE(parse_number(number_text(value), x));
    EXPECT_EQ(x, value);
  }
}

TEST(TrilinosList, TypesFollowTheValues) {
  const Value map = parse_yaml("n: 3\nbig: 5000000000\nx: 1e-3\nb: true\ns: GMRES\nq: \"3\"\n"
                               "i: [1, 2]\nd: [1, 2.5]\nt: [a, 1]\nsub: {deep: {k: -1}}\n"
                               "\"a < b & 'c'\": 'x > \"y\" & <z>'\n",
                               "d.yaml");
  const auto list = Teuchos::getParametersFromXmlString(to_parameter_list_xml(map, "NOX"));
  EXPECT_EQ(list->get<int>("n"), 3);
  EXPECT_EQ(list->get<long long>("big"), 5000000000LL);
  EXPECT_EQ(list->get<double>("x"), 1e-3);
  EXPECT_TRUE(list->get<bool>("b"));
  EXPECT_EQ(list->get<std::string>("s"), "GMRES");
  EXPECT_EQ(list->get<std::string>("q"), "3");
  EXPECT_EQ(list->get<Teuchos::Array<int>>("i")[1], 2);
  EXPECT_EQ(list->get<Teuchos::Array<double>>("d")[1], 2.5);
  EXPECT_EQ(list->get<Teuchos::Array<std::string>>("t")[1], "1");
  EXPECT_EQ(list->get<std::string>("a < b & 'c'"), "x > \"y\" & <z>");
  EXPECT_EQ(list->sublist("sub").sublist("deep").get<int>("k"), -1);
}
