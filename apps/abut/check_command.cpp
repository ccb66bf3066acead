// SPDX-License-Identifier: BSD-3-Clause
#include "check_command.hpp"

#include "choices.hpp"
#include "model.hpp"
#include "warnings.hpp"

#include "abut/core/trilinos.hpp"
#include "abut/mesh/info.hpp"
#include "abut/scene/masses.hpp"
#include "abut/scene/names.hpp"
#include "abut/scene/supports.hpp"
#include "abut/solid/resultant.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iostream>
#include <map>

namespace abut::app {

namespace {

class Printer {
public:
  explicit Printer(bool active) : active_(active) {}
  template <class... Args>
  void operator()(fmt::format_string<Args...> format, Args&&... args) const {
    const std::string text = fmt::format(format, std::forward<Args>(args)...);
    if (active_)
      std::cout << text << '\n';
  }

private:
  bool active_;
};

/// " from t = 1 until t = 2"; empty for the whole run.
std::string explain_window(const Window& window) {
  return (window.from > 0.0 ? fmt::format(" from t = {:g}", window.from) : "") +
         (window.until ? fmt::format(" until t = {:g}", *window.until) : "");
}

/// What of a rigid body moves how. Collective.
std::string explain_rigid(const Model& m, std::size_t body) {
  const scene::BodyOptions& options = m.deck.bodies[body];
  std::size_t index = 0;
  while (m.rigid_bodies[index].name != options.name)
    ++index;
  Global nodes = 0;
  for (Local n = 0; n < m.mesh->num_owned; ++n)
    nodes += m.rigid_body_of_node[std::size_t(n)] == static_cast<int>(index);
  std::string free;
  for (std::size_t i = 0; i < 6; ++i)
    if (options.motion.free[i])
      free += std::string(" ") + (i < 3 ? "" : "r") + "xyz"[i % 3];
  std::string held;
  for (const rigid::HoldOptions& hold : options.motion.holds)
    held += ", '" + hold.name + "' holds it" + explain_window(hold.window);
  return fmt::format(
      "{} nodes, {}{}", m.comm.sum(nodes),
      free.empty() ? "rigid obstacle with prescribed motion" : "rigid body, free in" + free, held);
}

const char* name_of(solid::MaterialModel model) {
  using solid::MaterialModel;
  switch (model) {
  case MaterialModel::neo_hookean:
    return "neo-Hookean";
  case MaterialModel::linear_elastic:
    return "linear elastic";
  case MaterialModel::saint_venant_kirchhoff:
    return "Saint Venant-Kirchhoff";
  case MaterialModel::holmes_mow:
    return "Holmes-Mow";
  case MaterialModel::mooney_rivlin:
    return "Mooney-Rivlin";
  case MaterialModel::ogden:
    return "Ogden";
  case MaterialModel::ogden_unconstrained:
    return "Ogden unconstrained";
  }
  return "";
}

const char* name_of(solid::LoadKind kind) {
  using solid::LoadKind;
  switch (kind) {
  case LoadKind::traction:
    return "traction";
  case LoadKind::pressure:
    return "pressure";
  case LoadKind::body_force:
    return "body force";
  case LoadKind::force:
    return "force at each node";
  }
  return "";
}

std::string explain_material(const solid::MaterialOptions& o) {
  using solid::MaterialModel;
  std::string text = name_of(o.model);
  const auto add = [&](const char* what, double value) {
    text += fmt::format(", {} {:g}", what, value);
  };
  if (o.has_young()) {
    add("Young", o.young);
    add("Poisson", o.poisson);
  }
  if (o.model == MaterialModel::holmes_mow)
    add("beta", o.beta);
  if (o.model == MaterialModel::mooney_rivlin) {
    add("c1", o.c1);
    add("c2", o.c2);
  }
  for (std::size_t i = 0; o.has_ogden_terms() && i < o.coefficients.size(); ++i)
    text += fmt::format(", c {:g} with m {:g}", o.coefficients[i], o.exponents[i]);
  if (o.model == MaterialModel::ogden_unconstrained)
    add("lambda", o.lambda);
  if (o.is_uncoupled())
    add("bulk", o.bulk);
  if (!o.has_young())
    add("shear modulus at rest", o.shear_modulus());
  return text;
}

void explain_bodies(const Model& m, const Printer& print) {
  using solid::ElementFormulation;
  print("bodies:");
  for (std::size_t i = 0; i < m.deck.bodies.size(); ++i) {
    const scene::BodyOptions& body = m.deck.bodies[i];
    Global elements = 0;
    std::map<std::string, Global> types;
    for (std::size_t b = 0; b < m.mesh->blocks.size(); ++b) {
      if (m.body_of_block[b] != static_cast<int>(i))
        continue;
      const Global count = m.comm.sum(Global(m.mesh->blocks[b].size()));
      elements += count;
      const bool plain = m.formulation[b].value_or(ElementFormulation::displacement) ==
                         ElementFormulation::displacement;
      types[(plain ? "" : std::string(name_of(*m.formulation[b])) + " ") +
            fem::info(m.mesh->blocks[b].type).name] += count;
    }
    std::string kinds;
    for (const auto& [name, count] : types)
      kinds += fmt::format(" {} {}", count, name);
    print("  {}: {} elements ({} ), {}", body.name, elements, kinds,
          body.rigid ? explain_rigid(m, i) : "material " + body.material);
    if (m.inertia)
      print("    mass {:.6g}",
            body.motion.mass.value_or(scene::body_mass(m.deck, *m.mesh, m.body_of_block, i).mass));
  }
  for (const auto& material : m.deck.materials)
    print("material {}: {}", material.name, explain_material(material));
}

void explain_joints(const Model& m, const Printer& print) {
  for (std::size_t j = 0; j < m.joints.size(); ++j) {
    const rigid::Joint& joint = m.joints[j];
    const auto count = std::count(joint.held.begin(), joint.held.end(), true);
    print("joint {}: of '{}' against '{}', {}", joint.name, m.deck.joints[j].bodies[1],
          m.deck.joints[j].bodies[0],
          joint.is_spring() ? fmt::format("a spring of free length {:g}", joint.free_length)
                            : fmt::format("{} of 6 components held", count));
  }
}

void explain_supports(const Model& m, const Printer& print) {
  print("supports:");
  for (const auto& d : m.deck.displacements) {
    Global nodes = 0;
    for (Local n : scene::nodes_of_set(*m.mesh, d.set))
      nodes += n < m.mesh->num_owned;
    std::string parts;
    for (std::size_t i = 0; i < 3; ++i)
      if (d.components[i])
        parts += fmt::format(" {} = {}", "xyz"[i],
                             d.values[i].function ? d.values[i].expression
                                                  : fmt::format("{:g}", d.values[i].number));
    print("  {}: {} nodes of '{}',{}{}{}", d.name, m.comm.sum(nodes), d.set, parts,
          d.relative ? ", relative" : "", explain_window(d.window));
  }
  const auto free =
      m.deck.dynamics.active ? std::vector<scene::FreePiece>() : scene::free_pieces(m.deck, m);
  if (m.deck.dynamics.active)
    print("  bodies move by inertia: none has to be held");
  else if (free.empty())
    print("  every body is held");
  for (const scene::FreePiece& piece : free)
    for (const std::string& motion : piece.motions)
      print("  FREE: body '{}' can move: {}", piece.body, motion);
}

/// Where a load acts, and its resultant at the end. Collective.
void explain_loads(const Model& m, const Printer& print) {
  if (!m.deck.loads.empty())
    print("loads at t = {:g}, on the bodies as they are at the start:", m.deck.time.end);
  for (const solid::LoadOptions& load : m.deck.loads) {
    Vec3 force =
        solid::resultant(*m.mesh, load, given_curve(m.deck.curves, load.curve), m.deck.time.end);
    for (int i = 0; i < 3; ++i)
      if (std::abs(force[i]) < 1e-12 * norm(force))
        force[i] = 0.0; // rounding
    print("  {}: {} on '{}', resultant ({:.6g}, {:.6g}, {:.6g}){}", load.name, name_of(load.kind),
          load.place, force[0], force[1], force[2],
          load.curve.empty() ? "" : ", curve " + load.curve);
  }
}

void explain_time(const Model& m, const Printer& print) {
  const solver::TimeOptions& time = m.deck.time;
  const double step = time.end / time.steps;
  print("time: t from 0 to {:g} in {} steps of {:g}{}{}", time.end, time.steps, step,
        time.adaptive ? fmt::format(", cut down to {:g} where they fail", step * time.min_fraction)
                      : ", not cut where they fail",
        m.deck.dynamics.active ? "; bodies have inertia" : "");
}

void explain_contact(const Model& m, const Printer& print) {
  for (const auto& c : m.contacts) {
    const contact::ContactSummary s = c->summary();
    print("contact {}: '{}' on '{}', {} points{}", c->name(), c->settings().primary,
          c->settings().secondary, s.points, explain_window(c->settings().window));
    for (const std::string& choice : choices_of(m, c->settings()))
      print("  {}", choice);
    if (!c->acts())
      continue;
    if (s.paired_points > 0)
      print("  {} points have a partner within reach, gap from {:.4g} to {:.4g}", s.paired_points,
            s.min_gap, s.max_gap);
    if (s.paired_points < s.points)
      print("  {} points have no partner within {:g} face sizes", s.points - s.paired_points,
            c->settings().reach);
    if (s.min_gap < 0.0 && s.paired_points > 0)
      print("  note: the surfaces overlap at the start by up to {:.4g}", -s.min_gap);
  }
}

void check(const std::string& deck_file) {
  const Comm comm(MPI_COMM_WORLD);
  std::string mesh_text; // on the root, which prints
  const auto m = build_model(comm, deck_file, [&](const mesh::MeshData& mesh) {
    mesh_text = mesh::text(mesh::info(mesh));
  });
  const Printer print(comm.is_root());
  print("{}", m->deck.title.empty() ? m->deck.file : m->deck.title);
  print("{}unknowns: {}", mesh_text,
        m->equations->dofs().num_global_rows() * m->equations->dofs().fields());
  Vector x(m->equations->dofs().map()), f(m->equations->dofs().map());
  m->equations->residual(x, f);
  explain_bodies(*m, print);
  explain_joints(*m, print);
  explain_supports(*m, print);
  explain_loads(*m, print);
  explain_contact(*m, print);
  for (const std::string& shift : shifts_of_start(*m))
    print("{}", shift);
  explain_time(*m, print);
  for (const auto& list : {m->warnings, warnings_of_start(*m)})
    for (const std::string& warning : list)
      print("WARNING: {}", warning);
  const std::size_t known = m->warnings.size();
  if (!m->deck.dynamics.active)
    scene::require_supports(m->deck, *m, x,
                            [&](const std::string& key) { return m->deck.where(key); });
  for (std::size_t i = known; i < m->warnings.size(); ++i)
    print("WARNING: {}", m->warnings[i]);
  print("the deck is valid");
}

} // namespace

void add_check_command(CLI::App& app) {
  const auto deck = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("check", "Validate a deck and explain its scene");
  command->add_option("DECK", *deck, "YAML or XML deck")->required();
  command->callback([deck] { check(*deck); });
}

} // namespace abut::app
