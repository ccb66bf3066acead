// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include <algorithm>
#include <cmath>

namespace abut::febio {

namespace {

/// A plane that a surface cannot pass, with the unit normal n that points at the surface: FEBio's
/// pressure is stiffness (place + shift - n.x), reference area, at the nodes.
struct Wall {
  std::string name;
  int line = 0;
  Vec3 normal = Vec3::zero();
  double place = 0.0;
  double scale = 1.0; ///< what FEBio's penalty is multiplied with, and its offset divided by
  Value offset;
};

/// FEBio does not normalise the plane in its gap, only in its normal.
Wall read_plane(Element constraint) {
  Wall wall;
  wall.line = constraint.line();
  const std::vector<double> p = constraint.required_child("plane").numbers(4);
  const Vec3 a = {{p[0], p[1], p[2]}};
  const double length = norm(a);
  if (!(length > 1e-6 && length < 1e6))
    constraint.required_child("plane").fail("expected a, b, c, d with a normal (a, b, c)");
  wall.normal = 1.0 / length * a;
  wall.place = p[3] / length;
  wall.scale = length * length;
  wall.offset = constraint.value_or("offset", 0.0);
  return wall;
}

/// A brick behind the plane, rigid, much larger than all that is there.
class WallBuilder {
public:
  explicit WallBuilder(Model& model) : model_(model) {}

  void add(const Wall& wall, const std::string& surface, Contact contact) {
    const std::string name = free_name(wall.name);
    const std::vector<Global> nodes = brick(wall);
    Domain domain;
    domain.name = name;
    domain.line = wall.line;
    domain.id = {next_element()};
    domain.lines = {wall.line};
    domain.nodes = nodes;
    domain.material = name;
    model_.mesh.domains.push_back(domain);
    Material material;
    material.name = name;
    material.type = "rigid body";
    material.line = wall.line;
    material.numbers = {{"density", 1.0}, {"E", 1.0}, {"v", 0.0}};
    model_.materials.push_back(material);
    Facet face{wall.line, {nodes.begin() + 4, nodes.end()}, 4};
    model_.mesh.surfaces.push_back({name, wall.line, {face}});
    model_.mesh.pairs.push_back({name, surface, name, wall.line});
    contact.pair = name;
    model_.contacts.push_back(std::move(contact));
    move(wall, name);
  }

private:
  std::string free_name(std::string name) const {
    const auto taken = [&](const auto& list) {
      return std::any_of(list.begin(), list.end(), [&](const auto& x) { return x.name == name; });
    };
    while (taken(model_.mesh.domains) || taken(model_.materials) || taken(model_.mesh.surfaces) ||
           taken(model_.mesh.node_sets) || taken(model_.mesh.pairs))
      name += "_";
    return name;
  }

  Global next_element() const {
    Global last = 0;
    for (const Domain& d : model_.mesh.domains)
      for (const Global id : d.id)
        last = std::max(last, id);
    return last + 1;
  }

  /// Four nodes behind, then four in the plane, seen from the normal's tip counter-clockwise.
  std::vector<Global> brick(const Wall& wall) {
    Mesh& mesh = model_.mesh;
    Vec3 low = Vec3::zero(), high = Vec3::zero();
    for (std::size_t n = 0; n < mesh.x.size(); ++n) {
      const int i = static_cast<int>(n % 3);
      low[i] = n < 3 ? mesh.x[n] : std::min(low[i], mesh.x[n]);
      high[i] = n < 3 ? mesh.x[n] : std::max(high[i], mesh.x[n]);
    }
    const double half = std::max(norm(high - low), 1e-6);
    const Vec3 middle = 0.5 * (low + high), n = wall.normal;
    const Vec3 center = middle + (wall.place - dot(n, middle)) * n;
    const int least = std::abs(n[0]) < 0.6 ? 0 : 1;
    Vec3 axis = Vec3::zero();
    axis[least] = 1.0;
    const Vec3 across = cross(n, axis);
    const Vec3 t = half / norm(across) * across, s = cross(n, t);
    std::vector<Global> ids;
    Global id =
        mesh.node_id.empty() ? 0 : *std::max_element(mesh.node_id.begin(), mesh.node_id.end());
    for (const double depth : {-0.5 * half, 0.0})
      for (const auto& [a, b] :
           {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
        const Vec3 x = center + double(a) * t + double(b) * s + depth * n;
        mesh.node_id.push_back(++id);
        mesh.x.insert(mesh.x.end(), {x[0], x[1], x[2]});
        ids.push_back(id);
      }
    return ids;
  }

  void move(const Wall& wall, const std::string& name) {
    RigidCondition held;
    held.name = wall.name;
    held.body = name;
    held.line = wall.line;
    held.fixed = true;
    held.components.fill(true);
    model_.rigid_conditions.push_back(held);
    for (int i = 0; i < 3; ++i) {
      RigidCondition moved = held;
      moved.fixed = false;
      moved.components = {};
      moved.components[static_cast<std::size_t>(i)] = true;
      moved.value = wall.offset;
      moved.value.number *= wall.normal[i] / wall.scale;
      if (!moved.value.is_zero())
        model_.rigid_conditions.push_back(moved);
    }
  }

  Model& model_;
};

void read_wall(Element constraint, Model& model) {
  const std::string surface = constraint.required_attribute("surface");
  const auto same = [&](const Surface& s) { return s.name == surface; };
  if (std::none_of(model.mesh.surfaces.begin(), model.mesh.surfaces.end(), same))
    constraint.fail("there is no surface '" + surface + "'");
  Wall wall = read_plane(constraint);
  wall.name = constraint.attribute_or("name", "");
  if (wall.name.empty())
    wall.name = "rigid_wall";
  Contact c;
  c.line = wall.line;
  c.name = wall.name;
  c.type = "sliding-node-on-facet";
  for (const char* key : {"tolerance", "auto_penalty", "two_pass", "gaptol", "minaug", "seg_up",
                          "node_reloc", "fric_coeff", "fric_penalty", "search_radius"})
    c.values[key] = {0.0, 0, wall.line};
  c.values["maxaug"] = {20.0, 0, wall.line};
  c.values["search_tol"] = {0.01, 0, wall.line};
  const bool augments = read_augmentation(constraint);
  c.values["laugon"] = {augments ? 1.0 : 0.0, 0, wall.line};
  c.values["tolerance"].number = constraint.number_or("tolerance", 0.0);
  if (augments && !(c.number("tolerance") > 0.0))
    constraint.fail("AUGLAG expects a <tolerance> > 0");
  c.values["penalty"] = constraint.required_child("penalty").value();
  if (!(c.number("penalty") > 0.0))
    constraint.required_child("penalty").fail("expected a number > 0");
  c.values["penalty"].number *= wall.scale;
  constraint.note("a rigid brick and a contact of nodes with its face");
  WallBuilder(model).add(wall, surface, std::move(c));
}

} // namespace

void read_constraints(Element section, Model& model) {
  for (Element constraint : section.children("constraint")) {
    const std::string type = constraint.required_attribute("type");
    if (type == "rigid_wall")
      read_wall(constraint, model);
    else
      constraint.refuse("type '" + type + "': abut has rigid_wall");
  }
}

} // namespace abut::febio
