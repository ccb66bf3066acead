// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tree.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

/// Files of older specifications, rewritten as the next one has them. What a step does not know it
/// leaves where it is: the readers of 4.0 refuse it by its name and line.
namespace abut::febio {

/// Words of before 3.0 for the two sides of a contact.
constexpr const char* old_primary = "sla"
                                    "ve";
constexpr const char* old_secondary = "ma"
                                      "ster";

/// Rewrites the tree of a file of specification 2.0, 2.5 or 3.0 as one of 4.0. Throws InputError
/// for other versions and for what contradicts itself.
void to_specification_4(Tree& tree);

void from_2_0(Tree& tree);
void from_2_5(Tree& tree);
void from_3_0(Tree& tree);

/// <Geometry>, with the materials of <Elements> in it, as <Mesh> and <MeshDomains>.
void geometry_to_mesh(Tree& tree);

/// The root and its steps, which hold conditions, loads and contacts.
std::vector<pugi::xml_node> phases(const Tree& tree);

/// Names that no child of a kind has: BASE, BASE_2, ...
class FreeNames {
public:
  FreeNames(pugi::xml_node parent, const char* kind);
  std::string make(const std::string& base);

private:
  std::set<std::string> taken_;
  std::map<std::string, int> last_;
};

/// The degrees of freedom of a word such as "xyz", "x,y" or "Rx": each as one word.
std::vector<std::string> dofs_of(const std::string& text);
/// Whether a word is a rotation or an extension of a shell, which nodes of solids do not have.
bool is_of_shells(const std::string& dof);

/// <scale lc="1">1</scale> and <value>3</value> as one <scale>. Refuses two that are not 1.
void merge_scale_and_value(Tree& tree, pugi::xml_node node);

} // namespace abut::febio
