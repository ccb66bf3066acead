// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include <algorithm>

namespace abut::febio {

namespace {

/// A parameter of a contact interface.
struct Parameter {
  const char* name;
  double initial; ///< FEBio's default
  bool scheduled; ///< may follow a load curve
};

constexpr Parameter common[] = {{"tolerance", 0.01, false}, {"penalty", 1.0, true},
                                {"auto_penalty", 0, false}, {"two_pass", 0, false},
                                {"gaptol", 0, false},       {"minaug", 0, false},
                                {"maxaug", 10, false},      {"search_tol", 0.01, false},
                                {"seg_up", 0, false},       {"node_reloc", 0, false}};

void read_numbers(Element contact, Contact& c, const Parameter& p) {
  if (auto child = contact.child(p.name)) {
    c.values[p.name] = child->value();
    if (c.values[p.name].curve > 0 && !p.scheduled)
      child->refuse("abut keeps it constant: remove lc");
  } else {
    c.values[p.name] = {p.initial, 0, contact.line()};
  }
}

void read_laugon(Element contact, Contact& c) {
  auto child = contact.child("laugon");
  const std::string text = child ? child->text() : "PENALTY";
  const bool augmented = text == "AUGLAG" || text == "1";
  if (!augmented && text != "PENALTY" && text != "0")
    child->refuse("'" + text + "': abut has PENALTY and AUGLAG");
  c.values["laugon"] = {augmented ? 1.0 : 0.0, 0, contact.line()};
}

void refuse_smooth_aug(Element contact) {
  contact.expect("smooth_aug", 0,
                 "multipliers from element stresses; abut smooths them by 'multipliers: smoothed'");
}

void read_node_on_facet(Element contact, Contact& c) {
  read_numbers(contact, c, {"fric_coeff", 0, true});
  read_numbers(contact, c, {"fric_penalty", 0, false});
  read_numbers(contact, c, {"search_radius", 0, false});
  contact.ignore({"ktmult", "knmult"}, "abut takes the exact tangent");
  contact.ignore("update_penalty", "has no effect in FEBio either");
}

void read_facet_on_facet(Element contact, Contact& c) {
  read_numbers(contact, c, {"search_radius", 0, false});
  contact.ignore({"knmult"}, "abut takes the exact tangent");
  contact.ignore({"update_penalty", "dxtol"}, "has no effect in FEBio either");
  contact.ignore({"fric_coeff", "fric_penalty"}, "FEBio has no friction here");
  refuse_smooth_aug(contact);
}

void read_sliding_elastic(Element contact, Contact& c) {
  read_numbers(contact, c, {"fric_coeff", 0, true});
  read_numbers(contact, c, {"search_radius", 1.0, false});
  read_numbers(contact, c, {"tension", 0, false});
  read_numbers(contact, c, {"offset", 0, false});
  read_numbers(contact, c, {"flip_primary", 0, false});
  read_numbers(contact, c, {"flip_secondary", 0, false});
  contact.ignore({"knmult", "symmetric_stiffness"}, "abut takes the exact tangent");
  contact.ignore("update_penalty", "has no effect in FEBio while materials do not change");
  contact.expect("shell_bottom_primary", 0, "abut has no shells");
  contact.expect("shell_bottom_secondary", 0, "abut has no shells");
  refuse_smooth_aug(contact);
}

void read_one(Element contact, Model& model) {
  Contact c;
  c.line = contact.line();
  c.type = contact.required_attribute("type");
  c.pair = contact.required_attribute("surface_pair");
  c.name = contact.attribute_or("name", c.pair);
  const bool known = c.type == "sliding-node-on-facet" || c.type == "sliding-facet-on-facet" ||
                     c.type == "sliding-elastic";
  if (!known) {
    contact.refuse("type '" + c.type +
                   "': abut reads sliding-node-on-facet, sliding-facet-on-facet, sliding-elastic");
    return;
  }
  const auto same = [&](const SurfacePair& p) { return p.name == c.pair; };
  if (std::none_of(model.mesh.pairs.begin(), model.mesh.pairs.end(), same))
    contact.fail("there is no <SurfacePair> '" + c.pair + "'");
  read_laugon(contact, c);
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
  if (!(c.number("penalty") > 0.0))
    contact.required_child("penalty").fail("expected a number > 0");
  if (c.number("maxaug") < c.number("minaug"))
    contact.required_child("maxaug").fail("expected no less than minaug");
  model.contacts.push_back(std::move(c));
}

} // namespace

void read_contacts(Element section, Model& model) {
  for (Element contact : section.children("contact"))
    read_one(contact, model);
}

} // namespace abut::febio
