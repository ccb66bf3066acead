// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include "abut/translation/utf8.hpp"

#include <set>

namespace abut::gmsh {

namespace {

constexpr std::size_t longest_name = 200; // results need some characters more, and Exodus has 255

} // namespace

void read_names(Cursor& cursor, Model& model) {
  const Global count = cursor.count("a number of names", 1);
  for (Global i = 0; i < count; ++i) {
    const std::size_t at = cursor.at();
    const int dim = cursor.integer("the dimension of a group");
    const int tag = cursor.integer("the number of a group");
    const std::string line = cursor.rest_of_line();
    const std::size_t first = line.find('"'), last = line.rfind('"');
    if (dim < 0 || dim > 3)
      cursor.fail("expected a dimension from 0 to 3, got " + std::to_string(dim), at);
    if (first == last)
      cursor.fail("expected a name in quotes behind dimension and number of a group", at);
    const std::string name = translation::utf8(line.substr(first + 1, last - first - 1));
    if (name.size() > longest_name)
      cursor.fail("the name has " + std::to_string(name.size()) + " characters, expected at most " +
                      std::to_string(longest_name),
                  at);
    for (const char c : name)
      if (static_cast<unsigned char>(c) < ' ')
        cursor.fail("the name has a character that cannot be printed", at);
    if (!model.names.emplace(Entity{dim, tag_of(tag)}, name).second)
      cursor.fail("the group of dimension " + std::to_string(dim) + " and number " +
                      std::to_string(tag) + " has a name already",
                  at);
  }
}

Physical read_entities(Cursor& cursor) {
  Physical physical;
  Global counts[4];
  for (Global& count : counts)
    count = cursor.count("a number of entities", 28);
  for (int dim = 0; dim < 4; ++dim)
    for (Global i = 0; i < counts[dim]; ++i) {
      const int tag = cursor.integer("the number of an entity");
      for (int k = 0; k < (dim == 0 ? 3 : 6); ++k)
        cursor.real("a coordinate");
      std::vector<int>& groups = physical[{dim, tag}];
      for (Global k = cursor.count("a number of groups", 4); k > 0; --k)
        if (const int group = tag_of(cursor.integer("the number of a group")); group > 0)
          groups.push_back(group);
      if (dim > 0)
        for (Global k = cursor.count("a number of entities", 4); k > 0; --k)
          cursor.integer("the number of an entity");
    }
  return physical;
}

} // namespace abut::gmsh
