// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include "abut/translation/number.hpp"
#include "element_type.hpp"

namespace abut::gmsh {

namespace {

double coordinate(Cursor& cursor) {
  const std::size_t at = cursor.at();
  const double x = cursor.real("a coordinate");
  if (!translation::is_sane(x))
    cursor.fail("expected a coordinate, got one beyond all measure", at);
  return x;
}

Global positive(Cursor& cursor, const char* what, Global value, std::size_t at) {
  if (value < 1)
    cursor.fail(std::string("expected ") + what + " from 1 on, got " + std::to_string(value), at);
  return value;
}

Global node_number(Cursor& cursor, bool is_int) {
  const std::size_t at = cursor.at();
  const Global n = is_int ? cursor.integer("a node number") : cursor.size("a node number");
  return positive(cursor, "a node number", n, at);
}

const ElementType& type_of(Cursor& cursor, int number, std::size_t at) {
  const ElementType* type = element_type(number);
  if (!type)
    cursor.fail("elements of Gmsh's type " + std::to_string(number) + " are not known", at);
  return *type;
}

/// The list that an element of this kind goes to, a new one unless it is the last.
Elements& list_for(Model& model, int type, Entity entity, const std::vector<int>& physical) {
  std::vector<Elements>& lists = model.elements;
  if (lists.empty() || lists.back().type != type || lists.back().entity != entity ||
      lists.back().physical != physical) {
    Elements& list = lists.emplace_back();
    list.type = type;
    list.entity = entity;
    list.physical = physical;
  }
  return lists.back();
}

} // namespace

void read_nodes(Cursor& cursor, Model& model) {
  Global blocks = cursor.count("a number of blocks", 20);
  cursor.count("a number of nodes", 8);
  cursor.size("the smallest node number");
  cursor.size("the largest node number");
  for (; blocks > 0; --blocks) {
    const int dim = cursor.integer("the dimension of an entity");
    cursor.integer("the number of an entity");
    const bool parametric = cursor.integer("0 or 1") != 0;
    const Global count = cursor.count("a number of nodes", 32);
    for (Global i = 0; i < count; ++i)
      model.node_id.push_back(node_number(cursor, false));
    for (Global i = 0; i < count; ++i) {
      for (int k = 0; k < 3; ++k)
        model.x.push_back(coordinate(cursor));
      for (int k = 0; parametric && k < dim; ++k)
        cursor.real("a parameter");
    }
  }
}

void read_elements(Cursor& cursor, const Physical& physical, Model& model) {
  Global blocks = cursor.count("a number of blocks", 20);
  cursor.count("a number of elements", 16);
  cursor.size("the smallest element number");
  cursor.size("the largest element number");
  for (; blocks > 0; --blocks) {
    const int dim = cursor.integer("the dimension of an entity");
    const int tag = cursor.integer("the number of an entity");
    const std::size_t at = cursor.at();
    const ElementType& type = type_of(cursor, cursor.integer("a type of elements"), at);
    const Global count = cursor.count("a number of elements", 16);
    const auto groups = physical.find({dim, tag});
    Elements& list = list_for(model, type.number, {type.dim, tag},
                              groups == physical.end() ? std::vector<int>() : groups->second);
    for (Global i = 0; i < count; ++i) {
      list.at.push_back(cursor.at());
      const Global id = cursor.size("an element number");
      list.id.push_back(positive(cursor, "an element number", id, list.at.back()));
      for (int a = 0; a < type.nodes; ++a)
        list.nodes.push_back(node_number(cursor, false));
    }
  }
}

void read_nodes_2(Cursor& cursor, Model& model) {
  const Global count = cursor.count("a number of nodes", 28);
  if (model.binary) {
    cursor.skip_line();
    cursor.set_binary(true);
  }
  for (Global i = 0; i < count; ++i) {
    model.node_id.push_back(node_number(cursor, true));
    for (int k = 0; k < 3; ++k)
      model.x.push_back(coordinate(cursor));
  }
}

namespace {

/// Tags of an element: its physical group, 0 in none, its entity, and what parts need.
void read_element_2(Cursor& cursor, const ElementType& type, int tags, std::size_t at, int id,
                    Model& model) {
  const std::size_t at_tags = cursor.at();
  int physical = 0, entity = 0;
  for (int k = 0; k < tags; ++k) {
    const int tag = cursor.integer("a tag");
    if (k == 0)
      physical = tag_of(tag);
    if (k == 1)
      entity = tag;
    if (k == 2 && tag > 1)
      cursor.fail(in_parts, at_tags);
  }
  Elements& list = list_for(model, type.number, {type.dim, entity},
                            physical > 0 ? std::vector<int>{physical} : std::vector<int>());
  list.at.push_back(at);
  list.id.push_back(positive(cursor, "an element number", id, at));
  for (int a = 0; a < type.nodes; ++a)
    list.nodes.push_back(node_number(cursor, true));
}

int tag_count(Cursor& cursor) {
  const std::size_t at = cursor.at();
  const int tags = cursor.integer("a number of tags");
  constexpr int most = 1000; // of an element between as many parts
  if (tags < 0 || tags > most)
    cursor.fail("expected a number of tags, got " + std::to_string(tags), at);
  return tags;
}

} // namespace

void read_elements_2(Cursor& cursor, Model& model) {
  const Global count = cursor.count("a number of elements", 8);
  if (!model.binary) {
    for (Global i = 0; i < count; ++i) {
      const std::size_t at = cursor.at();
      const int id = cursor.integer("an element number");
      const ElementType& type = type_of(cursor, cursor.integer("a type of elements"), at);
      read_element_2(cursor, type, tag_count(cursor), at, id, model);
    }
    return;
  }
  cursor.skip_line();
  cursor.set_binary(true);
  for (Global read = 0; read < count;) {
    const std::size_t at = cursor.at();
    const ElementType& type = type_of(cursor, cursor.integer("a type of elements"), at);
    const int following = cursor.integer("a number of elements");
    const int tags = tag_count(cursor);
    if (following < 1 || following > count - read)
      cursor.fail("expected a number of elements up to " + std::to_string(count - read) + ", got " +
                      std::to_string(following),
                  at);
    for (int i = 0; i < following; ++i) {
      const std::size_t at_element = cursor.at();
      const int id = cursor.integer("an element number");
      read_element_2(cursor, type, tags, at_element, id, model);
    }
    read += following;
  }
}

} // namespace abut::gmsh
