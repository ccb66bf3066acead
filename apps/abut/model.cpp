// SPDX-License-Identifier: BSD-3-Clause
#include "model.hpp"

#include "abut/contact/side_choice.hpp"
#include "abut/core/error.hpp"
#include "abut/io/exodus.hpp"
#include "abut/mesh/surface.hpp"
#include "abut/meshgen/generate.hpp"
#include "abut/solid/face_stiffness.hpp"
#include "abut/solid/load_contribution.hpp"
#include "abut/solid/reference_checks.hpp"
#include "dynamics.hpp"
#include "rigid_joints.hpp"
#include "rigid_motion.hpp"
#include "windows.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <set>

namespace abut::app {

namespace {

mesh::MeshData load_mesh(const deck::Deck& deck) {
  if (!deck.mesh.file.empty()) {
    try {
      return io::read_exodus(deck.mesh_path());
    } catch (const InputError& e) {
      throw InputError(deck.where("mesh.file") + ": " + e.what());
    }
  }
  std::map<std::string, std::string> options;
  for (const auto& p : deck.mesh.parameters)
    options[p.key] = p.text;
  try {
    return meshgen::generate(deck.mesh.kind, options);
  } catch (const InputError& e) {
    throw InputError(deck.where("mesh.generate") + ": " + e.what());
  }
}

template <class Map> std::vector<std::string> names(const Map& map) {
  std::vector<std::string> result;
  for (const auto& entry : map)
    result.push_back(entry.first);
  return result;
}

/// Throws unless `name` is one of `valid`.
void require_name(const deck::Deck& deck, const std::string& path, const std::string& what,
                  const std::string& name, const std::vector<std::string>& valid) {
  if (std::find(valid.begin(), valid.end(), name) != valid.end())
    return;
  throw InputError(deck.where(path) + ": the mesh has no " + what + " '" + name + "'; " +
                   nearest_word_hint(name, valid.data(), valid.size()));
}

void check_names(const Model& m) {
  const deck::Deck& deck = m.deck;
  std::vector<std::string> blocks;
  for (const mesh::Block& b : m.mesh->blocks)
    blocks.push_back(b.name);
  const auto node_sets = names(m.mesh->node_sets), side_sets = names(m.mesh->side_sets);
  std::vector<std::string> sets = node_sets;
  sets.insert(sets.end(), side_sets.begin(), side_sets.end());
  std::sort(sets.begin(), sets.end()); // a name may stand for both
  sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
  for (const auto& b : deck.bodies)
    for (const std::string& block : b.blocks)
      require_name(deck, "bodies." + b.name + ".blocks", "block", block, blocks);
  for (const auto& b : deck.bodies)
    for (const std::string& set : b.node_sets)
      require_name(deck, "bodies." + b.name + ".node_sets", "node set", set, node_sets);
  for (const auto& d : deck.displacements)
    require_name(deck, "displacements." + d.name + ".set", "node set or side set", d.set, sets);
  for (const auto& l : deck.loads) {
    const std::string path = "loads." + l.name;
    if (l.kind == solid::LoadKind::body_force)
      require_name(deck, path + ".block", "block", l.place, blocks);
    else if (l.kind == solid::LoadKind::force)
      require_name(deck, path + ".node_set", "node set", l.place, node_sets);
    else
      require_name(deck, path + ".side_set", "side set", l.place, side_sets);
  }
  for (const auto& c : deck.contact) {
    require_name(deck, "contact." + c.name + ".primary", "side set", c.primary, side_sets);
    require_name(deck, "contact." + c.name + ".secondary", "side set", c.secondary, side_sets);
  }
  for (const auto& v : deck.verify)
    if (!deck::is_contact_quantity(v.quantity) && !deck::is_rigid_quantity(v.quantity) &&
        !deck::is_joint_quantity(v.quantity) && !v.place.empty())
      require_name(deck, "verify." + v.name + ".place", "node set or side set", v.place, sets);
}

void assign_bodies(Model& m) {
  const deck::Deck& deck = m.deck;
  m.body_of_block.assign(m.mesh->blocks.size(), -1);
  m.material.resize(m.mesh->blocks.size());
  for (std::size_t i = 0; i < deck.bodies.size(); ++i) {
    const solid::BodyOptions& body = deck.bodies[i];
    for (const std::string& name : body.blocks)
      for (std::size_t b = 0; b < m.mesh->blocks.size(); ++b) {
        if (m.mesh->blocks[b].name != name)
          continue;
        if (m.body_of_block[b] >= 0)
          throw InputError(deck.where("bodies." + body.name + ".blocks") + ": block '" + name +
                           "' already belongs to body '" +
                           deck.bodies[std::size_t(m.body_of_block[b])].name + "'");
        m.body_of_block[b] = static_cast<int>(i);
        for (const auto& material : deck.materials)
          if (!body.rigid && material.name == body.material)
            m.material[b] = solid::make_material(material);
      }
  }
  for (std::size_t b = 0; b < m.mesh->blocks.size(); ++b)
    if (m.body_of_block[b] < 0)
      throw InputError(deck.where("bodies") + ": block '" + m.mesh->blocks[b].name +
                       "' of the mesh belongs to no body");
}

/// The curve of an entry; empty when it names none.
std::function<double(double)> given_curve(const deck::Deck& deck, const std::string& name) {
  if (name.empty())
    return {};
  return deck.curve(name);
}

/// value(t) of an amount at a place, computed once for each t.
std::function<double(double)> history(const solid::Amount& amount, const Vec3& position,
                                      const std::function<double(double)>& curve) {
  return [=, last = std::numeric_limits<double>::quiet_NaN(), value = 0.0](double t) mutable {
    if (t != last)
      value = amount.at(position, t, curve);
    last = t;
    return value;
  };
}

std::vector<assembly::Constraint> make_constraints(const Model& m) {
  std::vector<assembly::Constraint> result;
  std::map<std::pair<Local, int>, std::vector<Window>> given;
  for (const auto& d : m.deck.displacements) {
    const auto curve = given_curve(m.deck, d.curve);
    for (Local n : nodes_of_set(*m.mesh, d.set)) {
      if (n >= m.mesh->num_owned)
        continue;
      for (int i = 0; i < 3; ++i) {
        if (!d.components[std::size_t(i)])
          continue;
        std::vector<Window>& windows = given[{n, i}];
        if (std::find(windows.begin(), windows.end(), d.window) != windows.end())
          continue; // the same is prescribed already
        windows.push_back(d.window);
        const double* x = m.mesh->x.data() + 3 * std::size_t(n);
        result.push_back({n, i, history(d.values[std::size_t(i)], {{x[0], x[1], x[2]}}, curve),
                          d.window, d.relative});
      }
    }
  }
  return result;
}

/// Two entries that prescribe one unknown differently would silently drop one of them.
void check_conflicts(const Model& m) {
  const auto agree = [](const auto& d, const auto& other, std::size_t i) {
    if (!d.window.overlaps(other.window))
      return true;
    const solid::Amount &a = d.values[i], &b = other.values[i];
    const bool same_start =
        d.relative == other.relative && (!d.relative || d.window.from == other.window.from);
    return same_start && a == b && (a == solid::Amount() || d.curve == other.curve);
  };
  std::map<std::pair<Local, int>, std::vector<const solid::DisplacementOptions*>> given;
  for (const auto& d : m.deck.displacements)
    for (Local n : nodes_of_set(*m.mesh, d.set))
      for (int i = 0; i < 3; ++i) {
        if (!d.components[std::size_t(i)])
          continue;
        auto& others = given[{n, i}];
        for (const auto* other : others)
          if (!agree(d, *other, std::size_t(i)))
            throw InputError(m.deck.where("displacements." + d.name) + ": node " +
                             std::to_string(m.mesh->node_id[n]) + " has its " + "xyz"[i] +
                             " displacement prescribed differently by '" + other->name + "'");
        others.push_back(&d);
      }
}

/// For each node of a surface bits 1, 2, 4 where its displacement along x, y, z is prescribed all
/// the time.
std::vector<char> prescribed_directions(const Model& m, const mesh::Surface& surface) {
  std::vector<char> of_node(static_cast<std::size_t>(m.mesh->num_local()), 0), result;
  for (const assembly::Constraint& c : m.constraints)
    if (c.window.is_whole_run())
      of_node[std::size_t(c.node)] = static_cast<char>(of_node[std::size_t(c.node)] | 1 << c.field);
  for (Local i : surface.field_index)
    result.push_back(of_node[std::size_t(i)]);
  return result;
}

/// Swaps the sides when the deck leaves the choice, and warns of a primary that is stiff and fine.
void choose_sides(Model& m, const mesh::Surface& primary, const mesh::Surface& secondary,
                  contact::ContactOptions& options) {
  const contact::SideComparison sides = contact::compare_sides(m.comm, primary, secondary);
  if (options.primary_side == contact::PrimarySide::automatic) {
    if (sides.prefers_swap())
      std::swap(options.primary, options.secondary);
  } else if (sides.is_poor() && !options.two_pass) {
    m.warnings.push_back(fmt::format(
        "contact.{}: the primary '{}' is {:.3g} times as stiff as the secondary and its faces are "
        "{:.3g} times their size: pressures will oscillate. Swap primary and secondary, or give "
        "'primary_side: automatic'",
        options.name, options.primary, sides.stiffness, sides.size));
  }
}

void add_contact(Model& m, contact::ContactOptions options) {
  solid::BlockMaterials materials;
  for (const auto& material : m.material)
    materials.push_back(material ? &*material : nullptr);
  const auto surface = [&](const std::string& name) {
    mesh::Surface s = mesh::extract_surface(*m.mesh, name);
    const auto stiffness =
        solid::face_stiffness(*m.mesh, mesh::sorted_sides(*m.mesh, name), materials);
    s.modulus = stiffness.modulus;
    s.inverse_depth = stiffness.inverse_depth;
    return s;
  };
  const auto add = [&](const contact::ContactOptions& pass, double share) {
    m.contacts.push_back(std::make_shared<contact::Interaction>(
        m.comm, surface(pass.primary), surface(pass.secondary), pass, m.timers, share));
    contact::Interaction& contact = *m.contacts.back();
    contact.set_schedules(given_curve(m.deck, pass.penalty_curve),
                          given_curve(m.deck, pass.friction_curve));
    contact.set_end(m.deck.time.end);
    contact.set_prescribed(prescribed_directions(m, contact.primary()));
  };
  try {
    choose_sides(m, surface(options.primary), surface(options.secondary), options);
    add(options, options.two_pass ? 0.5 : 1.0);
    if (!options.two_pass)
      return;
    contact::ContactOptions second = options;
    std::swap(second.primary, second.secondary);
    second.name += "_second_pass";
    add(second, 0.5);
  } catch (const InputError& e) {
    throw InputError(m.deck.where("contact." + options.name) + ": " + e.what());
  }
}

void add_equations(Model& m) {
  assembly::RigidNodes rigid{m.rigid_body_of_node, {}, rigid_links(m.joints)};
  for (const auto& body : m.rigid_bodies)
    rigid.has_unknowns.push_back(body.has_unknowns());
  m.equations = std::make_unique<assembly::EquationSystem>(
      assembly::DofMap(*m.mesh, {"displacement_x", "displacement_y", "displacement_z"}, rigid),
      m.timers);
  for (std::size_t b = 0; b < m.mesh->blocks.size(); ++b) {
    if (!m.material[b])
      continue;
    m.solids.push_back(
        std::make_shared<solid::SolidContribution>(*m.mesh, static_cast<int>(b), *m.material[b]));
    m.equations->add(m.solids.back());
  }
  for (const auto& load : m.deck.loads)
    m.equations->add(
        std::make_shared<solid::LoadContribution>(*m.mesh, load, given_curve(m.deck, load.curve)));
  for (const auto& contact : m.contacts)
    m.equations->add(contact);
  if (m.deck.dynamics.active) {
    m.inertia = make_inertia(m);
    m.equations->add(m.inertia);
  }
  m.equations->set_constraints(m.constraints);
  m.equations->set_rigid_bodies(m.rigid_bodies);
  m.equations->set_rigid_joints(m.joints);
  for (const auto& [joint, component] : m.equations->implied_constraints())
    m.warnings.push_back("joints." + joint + ": its " + component +
                         " is held by other joints or supports already. It carries no force of "
                         "its own, and the run stops where it would have to move");
}

/// Impact with multipliers brings energy in, which rules near the trapezoidal one keep.
void warn_of_impact(Model& m) {
  const solver::DynamicsOptions& dynamics = m.deck.dynamics;
  const bool damped = dynamics.spectral_radius == 0.0 || dynamics.gamma.value_or(0.5) > 0.5;
  for (const auto& c : m.deck.contact)
    if (dynamics.active && !damped && c.enforcement == contact::Enforcement::augmented_lagrangian)
      m.warnings.push_back(fmt::format(
          "contact.{}: multipliers bring energy in where surfaces hit each other; watch "
          "energy_imbalance, and take 'spectral_radius: 0' or 'enforcement: penalty' with "
          "'penalty_factor: 1' where they do",
          c.name));
}

} // namespace

std::vector<Local> nodes_of_set(const mesh::Mesh& mesh, const std::string& name) {
  const auto set = mesh.node_sets.find(name);
  if (set != mesh.node_sets.end())
    return set->second;
  std::set<Local> nodes;
  for (const mesh::Side& s : mesh.side_sets.at(name)) {
    const mesh::Block& block = mesh.blocks[std::size_t(s.block)];
    const fem::CellSide& face = fem::side(block.type, s.side);
    for (int a = 0; a < fem::face_nodes(face.type); ++a)
      nodes.insert(block.nodes[std::size_t(s.element) * fem::info(block.type).nodes +
                               std::size_t(face.nodes[a])]);
  }
  return {nodes.begin(), nodes.end()};
}

std::unique_ptr<Model> build_model(const Comm& comm, const std::string& deck_file) {
  auto m = std::make_unique<Model>(comm, deck::read_deck(comm, deck_file));
  mesh::MeshData data;
  comm.on_root([&] { data = load_mesh(m->deck); });
  m->mesh = std::make_unique<mesh::Mesh>(mesh::distribute(data, comm));
  data = {};
  comm.together([&] {
    check_names(*m);
    assign_bodies(*m);
    check_conflicts(*m);
  });
  try {
    solid::check_elements(*m->mesh);
  } catch (const InputError& e) {
    throw InputError(m->deck.where("mesh") + ": " + e.what());
  }
  m->rigid_bodies = rigid_bodies(*m);
  m->joints = rigid_joints(m->deck, m->rigid_bodies);
  m->rigid_body_of_node = rigid_nodes(*m);
  m->constraints = make_constraints(*m);
  for (const auto& options : m->deck.contact)
    add_contact(*m, options);
  const std::vector<std::string> between = windows_between_steps(m->deck);
  m->warnings.insert(m->warnings.end(), between.begin(), between.end());
  add_equations(*m);
  warn_of_impact(*m);
  return m;
}

} // namespace abut::app
