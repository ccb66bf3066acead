// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "readers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace abut::febio {

namespace {

enum class Range { any, not_negative, count, flag };

/// A parameter of a contact interface.
struct Parameter {
  const char* name;
  double initial; ///< FEBio's default
  Range range = Range::any;
  bool scheduled = false; ///< may follow a load curve
};

constexpr Parameter common[] = {{"tolerance", 0.01},
                                {"penalty", 1.0, Range::any, true},
                                {"auto_penalty", 0, Range::flag},
                                {"two_pass", 0, Range::flag},
                                {"gaptol", 0},
                                {"minaug", 0, Range::count},
                                {"maxaug", 10, Range::count},
                                {"search_tol", 0.01, Range::not_negative},
                                {"seg_up", 0, Range::count},
                                {"node_reloc", 0, Range::flag}};

Value read_value(Element child, Range range) {
  constexpr double most = 1e9;
  if (range == Range::flag)
    return {child.flag() ? 1.0 : 0.0, 0, child.line()};
  const Value v = child.value();
  const bool whole = v.number == std::floor(v.number) && std::abs(v.number) <= most;
  if (range == Range::count && !(whole && v.number >= 0.0))
    child.fail("expected a whole number from 0 to a billion, got '" + child.text() + "'");
  if (range == Range::not_negative && !(v.number >= 0.0))
    child.fail("expected a number >= 0, got '" + child.text() + "'");
  return v;
}

void read_numbers(Element contact, Contact& c, const Parameter& p) {
  if (auto child = contact.child(p.name)) {
    c.values[p.name] = read_value(*child, p.range);
    if (c.values[p.name].curve > 0 && !p.scheduled)
      child->refuse("abut keeps it constant: remove lc");
  } else {
    c.values[p.name] = {p.initial, 0, contact.line()};
  }
}

void refuse_smooth_aug(Element contact) {
  contact.expect("smooth_aug", 0,
                 "multipliers from the stresses of elements: set 0, and 'multipliers: smoothed' in "
                 "the deck for smooth ones");
}

void read_node_on_facet(Element contact, Contact& c) {
  read_numbers(contact, c, {"fric_coeff", 0, Range::not_negative, true});
  read_numbers(contact, c, {"fric_penalty", 0, Range::not_negative});
  read_numbers(contact, c, {"search_radius", 0});
  contact.ignore({"ktmult", "knmult"}, "abut takes the exact tangent");
  contact.ignore("update_penalty", "has no effect in FEBio either");
}

void read_facet_on_facet(Element contact, Contact& c) {
  read_numbers(contact, c, {"search_radius", 0});
  contact.ignore({"knmult"}, "abut takes the exact tangent");
  contact.ignore({"update_penalty", "dxtol"}, "has no effect in FEBio either");
  contact.ignore({"fric_coeff", "fric_penalty"}, "FEBio has no friction here");
  refuse_smooth_aug(contact);
}

void read_sliding_elastic(Element contact, Contact& c) {
  read_numbers(contact, c, {"fric_coeff", 0, Range::not_negative, true});
  read_numbers(contact, c, {"search_radius", 1.0});
  read_numbers(contact, c, {"tension", 0, Range::flag});
  read_numbers(contact, c, {"offset", 0});
  read_numbers(contact, c, {"flip_primary", 0, Range::flag});
  read_numbers(contact, c, {"flip_secondary", 0, Range::flag});
  contact.ignore({"knmult", "symmetric_stiffness"}, "abut takes the exact tangent");
  contact.ignore("update_penalty", "has no effect in FEBio while materials do not change");
  contact.expect("shell_bottom_primary", 0, "abut has no shells");
  contact.expect("shell_bottom_secondary", 0, "abut has no shells");
  refuse_smooth_aug(contact);
}

/// What a type does not have stays at a value that does nothing.
void read_tied_to_closest(Element contact, Contact& c) {
  for (const Parameter p :
       {Parameter{"tolerance", 0.01}, Parameter{"penalty", 1.0, Range::any, true},
        Parameter{"minaug", 0, Range::count}, Parameter{"maxaug", 10, Range::count}})
    read_numbers(contact, c, p);
  read_numbers(contact, c, {"search_tolerance", 0.0001, Range::not_negative});
  c.values["search_tol"] = c.values["search_tolerance"];
  for (const char* key : {"auto_penalty", "two_pass", "gaptol", "seg_up", "node_reloc"})
    c.values[key] = {0.0, 0, contact.line()};
  for (const char* key : {"max_distance", "moves_nodes"})
    c.values[key] = {0.0, 0, contact.line()};
  if (c.is_sticky()) {
    read_numbers(contact, c, {"max_traction", 0});
    read_numbers(contact, c, {"snap_tol", 0, Range::not_negative});
  }
  contact.ignore({"knmult", "ktmult"}, "abut takes the exact tangent");
  contact.ignore("update_penalty", "has no effect in FEBio either");
  if (c.type == "tied-facet-on-facet")
    c.values["moves_nodes"].number = contact.flag_or("gap_offset", false) ? 1.0 : 0.0;
  if (c.type != "tied-node-on-facet")
    return;
  read_numbers(contact, c, {"max_distance", 0});
  contact.expect("offset_shells", 0, "abut has no shells");
  contact.ignore("special", "abut's search has its own care for edges and corners");
  if (auto moves = contact.child("node_reloc")) {
    c.values["moves_nodes"].number = moves->flag() ? 1.0 : 0.0;
    moves->note("abut moves no nodes: their distance strains nothing");
  }
}

void read_tied_elastic(Element contact, Contact& c) {
  for (Parameter p : common) {
    const std::string name = p.name;
    if (name == "tolerance")
      p.initial = 0.1;
    if (name == "seg_up" || name == "node_reloc")
      c.values[name] = {0.0, 0, contact.line()};
    else
      read_numbers(contact, c, p);
  }
  read_numbers(contact, c, {"search_radius", 1.0});
  contact.ignore({"knmult", "symmetric_stiffness"}, "abut takes the exact tangent");
  contact.ignore("update_penalty", "has no effect in FEBio while materials do not change");
  contact.ignore({"flip_primary", "flip_secondary"}, "ties hold both ways");
  contact.expect("shell_bottom_primary", 0, "abut has no shells");
  contact.expect("shell_bottom_secondary", 0, "abut has no shells");
}

/// FEBio scales the penalty with the number of augmentations where these ask for it.
void expect_plain_penalty(Element contact) {
  contact.expect("max_penalty_sf", 0, "abut's penalty does not grow with augmentations: set 0");
  contact.ignore("penalty_sf", "has no effect while max_penalty_sf is 0");
}

void read_sliding(Element contact, Contact& c) {
  for (Parameter p : common) {
    if (c.type == "sliding-elastic" && std::string(p.name) == "tolerance")
      p.initial = 0.1;
    read_numbers(contact, c, p);
  }
  if (c.type == "sliding-node-on-facet")
    read_node_on_facet(contact, c);
  else if (c.type == "sliding-facet-on-facet")
    read_facet_on_facet(contact, c);
  else
    read_sliding_elastic(contact, c);
}

void read_one(Element contact, Model& model) {
  static const std::string types[] = {
      "sliding-node-on-facet", "sliding-facet-on-facet", "sliding-elastic", "tied-node-on-facet",
      "tied-facet-on-facet",   "tied-elastic",           "sticky"};
  Contact c;
  c.line = contact.line();
  c.type = contact.required_attribute("type");
  c.pair = contact.required_attribute("surface_pair");
  c.name = contact.attribute_or("name", c.pair);
  if (std::find(std::begin(types), std::end(types), c.type) == std::end(types)) {
    contact.refuse("type '" + c.type + "'; " + nearest_word_hint(c.type, types, std::size(types)));
    return;
  }
  const auto same = [&](const SurfacePair& p) { return p.name == c.pair; };
  if (std::none_of(model.mesh.pairs.begin(), model.mesh.pairs.end(), same))
    contact.fail("there is no <SurfacePair> '" + c.pair + "'");
  expect_plain_penalty(contact);
  c.values["laugon"] = {read_augmentation(contact) ? 1.0 : 0.0, 0, contact.line()};
  if (c.type == "tied-node-on-facet" || c.type == "tied-facet-on-facet" || c.is_sticky())
    read_tied_to_closest(contact, c);
  else if (c.type == "tied-elastic")
    read_tied_elastic(contact, c);
  else
    read_sliding(contact, c);
  if (!(c.number("penalty") > 0.0))
    contact.required_child("penalty").fail("expected a number > 0");
  if (c.number("maxaug") < c.number("minaug"))
    contact.required_child("maxaug").fail("expected no less than minaug");
  model.contacts.push_back(std::move(c));
}

} // namespace

bool read_augmentation(Element contact) {
  auto child = contact.child("laugon");
  std::string text = child ? child->text() : "PENALTY";
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  const bool augmented = text == "AUGLAG" || text == "1";
  if (!augmented && text != "PENALTY" && text != "0")
    child->refuse("'" + text + "': abut has PENALTY and AUGLAG");
  return augmented;
}

void read_contacts(Element section, Model& model) {
  for (Element contact : section.children("contact"))
    read_one(contact, model);
}

} // namespace abut::febio
