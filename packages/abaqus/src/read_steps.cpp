// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include "abut/core/error.hpp"

#include <algorithm>

namespace abut::abaqus {

namespace {

/// Initial increment, period, smallest and largest increment.
void read_increments(Card& card, Step& step) {
  if (card.lines.empty())
    return;
  const DataLine& line = card.lines[0];
  const auto fields = line.fields();
  step.period = card.number(line, fields, 1, "the period of the step", 1.0);
  if (step.period == 0.0)
    step.period = 1.0;
  step.increment = card.number(line, fields, 0, "the first increment", step.period);
  const double largest = card.number(line, fields, 3, "the largest increment", step.period);
  if (step.increment == 0.0)
    step.increment = step.period;
  if (largest > 0.0)
    step.increment = std::min(step.increment, largest);
  step.increment = std::min(step.increment, step.period);
  if (!(step.period > 0.0) || !(step.increment > 0.0))
    card.fail(line.place, "expected an increment and a period > 0");
  if (step.period / step.increment > 1e6)
    card.fail(line.place, "expected at most a million increments");
}

} // namespace

void read_step(Card& card, Model& model) {
  Step step;
  step.place = card.place();
  const auto finite = card.parameter("NLGEOM");
  step.finite = finite && key_of(*finite) != "NO";
  if (!model.steps.empty() && model.steps.back().finite)
    step.finite = true;
  if (card.has("PERTURBATION"))
    card.refuse("PERTURBATION: abut has no linear perturbations");
  step.at_once = card.word("AMPLITUDE", {"RAMP", "STEP"}, "") == "STEP";
  card.ignore({"INC", "NAME", "UNSYMM", "EXTRAPOLATION", "SOLVER", "CONVERT SDI"}, "abut's own");
  model.steps.push_back(step);
}

void read_static(Card& card, Step& step) {
  card.use();
  step.direct = card.has("DIRECT");
  read_increments(card, step);
  card.ignore({"SOLVER"}, "abut's own");
  card.ignore({"STABILIZE", "ALLSDTOL", "CONTINUE", "FACTOR"},
              "damping against what is free to move; abut holds bodies that are about to touch");
  for (const char* other :
       {"RIKS", "EXPLICIT", "FULLY PLASTIC", "TIME RESET", "TOTAL TIME AT START", "ADIABATIC"})
    if (card.has(other))
      card.refuse(std::string(other) + ": abut has not");
}

void read_dynamic(Card& card, Step& step) {
  card.use();
  step.dynamic = true;
  read_increments(card, step);
  const std::string application =
      card.word("APPLICATION", {"TRANSIENT FIDELITY", "MODERATE DISSIPATION", "QUASI-STATIC"},
                "TRANSIENT FIDELITY");
  if (application == "MODERATE DISSIPATION")
    step.alpha = -0.41421;
  if (application == "QUASI-STATIC")
    card.refuse("APPLICATION=QUASI-STATIC: take *STATIC");
  if (const auto alpha = card.number_parameter("ALPHA"))
    step.alpha = *alpha;
  if (!(step.alpha >= -0.5 && step.alpha <= 0.0))
    card.fail("expected ALPHA from -1/3 to 0");
  card.ignore({"DIRECT", "HAFTOL", "HALFINC SCALE FACTOR", "NOHAF", "SOLVER", "IMPACT", "INITIAL"},
              "abut cuts steps that do not converge");
  for (const char* other : {"EXPLICIT", "ADIABATIC", "SUBSPACE", "RELATIVE TO ABSOLUTE"})
    if (card.has(other))
      card.refuse(std::string(other) + ": abut has not");
}

namespace {

/// Between two points x^3 (10 - 15 x + 6 x^2) of the way, in sixteen pieces.
std::vector<std::array<double, 2>> smooth(const std::vector<std::array<double, 2>>& points) {
  constexpr int pieces = 16;
  std::vector<std::array<double, 2>> result = {points[0]};
  for (std::size_t i = 1; i < points.size(); ++i)
    for (int k = 1; k <= pieces; ++k) {
      const auto &a = points[i - 1], &b = points[i];
      const double x = static_cast<double>(k) / pieces;
      const double t = k == pieces ? b[0] : a[0] + x * (b[0] - a[0]);
      if (t > result.back()[0])
        result.push_back({t, a[1] + x * x * x * (10.0 + x * (6.0 * x - 15.0)) * (b[1] - a[1])});
    }
  return result;
}

} // namespace

void read_amplitude(Card& card, Model& model) {
  card.use();
  Amplitude a;
  a.name = name_of(card, card.required("NAME"));
  a.place = card.place();
  a.total_time = card.word("TIME", {"STEP TIME", "TOTAL TIME"}, "STEP TIME") == "TOTAL TIME";
  if (card.word("VALUE", {"RELATIVE", "ABSOLUTE"}, "RELATIVE") == "ABSOLUTE")
    card.refuse("VALUE=ABSOLUTE: abut's curves are factors");
  const std::string kind =
      card.word("DEFINITION", {"TABULAR", "SMOOTH STEP", "PERIODIC", "DECAY", "MODULATED", "USER"},
                "TABULAR");
  if (kind != "TABULAR" && kind != "SMOOTH STEP") {
    if (!kind.empty())
      card.refuse("DEFINITION=" + kind +
                  ": abut's curves are linear between points, TABULAR or SMOOTH STEP");
    a.points = {{0.0, 0.0}}; // what names it shall still find it
    model.amplitudes.emplace(key_of(a.name), std::move(a));
    return;
  }
  card.ignore({"SMOOTH"}, "abut's curves are linear between points");
  const std::vector<double> x = card.numbers();
  // A line may end with commas, so that zeros stand at the end.
  for (std::size_t i = 0; i + 1 < x.size(); i += 2) {
    if (!a.points.empty() && x[i] <= a.points.back()[0]) {
      if (x[i] == 0.0 && x[i + 1] == 0.0)
        continue;
      card.fail("expected times that grow");
    }
    a.points.push_back({x[i], x[i + 1]});
  }
  if (a.points.empty())
    card.fail("expected a line of times and factors");
  if (kind == "SMOOTH STEP")
    a.points = smooth(a.points);
  require_new(card, model.amplitudes, a.name);
  model.amplitudes.emplace(key_of(a.name), std::move(a));
}

namespace {

std::string read_amplitude_name(Card& card, const Model& model) {
  const auto name = card.parameter("AMPLITUDE");
  if (!name)
    return "";
  if (!model.amplitudes.count(key_of(*name))) {
    std::vector<std::string> names;
    for (const auto& entry : model.amplitudes)
      names.push_back(entry.second.name);
    card.fail("there is no amplitude '" + *name + "'; " +
              nearest_word_hint(*name, names.data(), names.size()));
  }
  return key_of(*name);
}

void read_op(Card& card, int step, Renewal::Kind kind, Model& model) {
  const std::string op = card.word("OP", {"MOD", "NEW"}, "MOD");
  const auto same = [&](const Renewal& r) { return r.kind == kind && r.step == step; };
  if (op == "NEW" && step >= 0 && std::none_of(model.renewals.begin(), model.renewals.end(), same))
    model.renewals.push_back({kind, step});
}

/// Words of the form SET, ENCASTRE: the components of which a solid has x, y, z alone.
bool read_word(const std::string& key, Condition& c, std::vector<int>& components) {
  struct Word {
    const char* name;
    std::vector<int> components;
  };
  static const Word words[] = {{"ENCASTRE", {1, 2, 3, 4, 5, 6}},
                               {"PINNED", {1, 2, 3}},
                               {"XSYMM", {1, 5, 6}},
                               {"YSYMM", {2, 4, 6}},
                               {"ZSYMM", {3, 4, 5}},
                               {"XASYMM", {2, 3, 4}},
                               {"YASYMM", {1, 3, 5}},
                               {"ZASYMM", {1, 2, 6}}};
  for (const Word& w : words)
    if (key == w.name) {
      components = w.components;
      c.value = 0.0;
      return true;
    }
  return false;
}

/// What a data line of *BOUNDARY or *CLOAD demands of the nodes that it begins with.
Condition condition_at(const Card& card, const DataLine& line, const Scope& scope, int step,
                       const std::string& amplitude, Lookup& lookup) {
  const std::string set = line.fields()[0];
  Condition c;
  c.place = line.place;
  c.step = step;
  c.set = set;
  c.nodes = lookup.nodes(card, line, set, scope);
  c.amplitude = amplitude;
  return c;
}

} // namespace

void read_boundary(Card& card, const Scope& scope, int step, Lookup& lookup) {
  card.use();
  Model& model = lookup.model();
  const std::string amplitude = read_amplitude_name(card, model);
  read_op(card, step, Renewal::Kind::boundary, model);
  const bool stays = card.has("FIXED");
  if (card.word("TYPE", {"DISPLACEMENT", "VELOCITY", "ACCELERATION"}, "DISPLACEMENT") !=
      "DISPLACEMENT")
    card.refuse("abut prescribes displacements alone");
  for (const DataLine& line : card.lines) {
    const auto fields = line.fields();
    Condition c = condition_at(card, line, scope, step, amplitude, lookup);
    c.stays = stays;
    std::vector<int> components;
    if (fields.size() > 1 && read_word(key_of(fields[1]), c, components)) {
      for (const int i : components) {
        c.first = c.last = i;
        model.boundaries.push_back(c);
      }
      continue;
    }
    c.first = static_cast<int>(
        card.whole(line, fields.size() > 1 ? fields[1] : "", "a component or a word as ENCASTRE"));
    c.last = fields.size() > 2 && !fields[2].empty()
                 ? static_cast<int>(card.whole(line, fields[2], "a component"))
                 : c.first;
    c.value = card.number(line, fields, 3, "a displacement", 0.0);
    if (c.first < 1 || c.last < c.first)
      card.fail(line.place, "expected components from 1 to 6, the first and the last");
    if (c.last > 6) {
      card.refuse("component " + std::to_string(c.last) +
                  ": abut has displacements alone, 1 to 3, "
                  "and rotations of rigid bodies, 4 to 6");
      continue;
    }
    model.boundaries.push_back(std::move(c));
  }
}

void read_forces(Card& card, const Scope& scope, int step, Lookup& lookup) {
  card.use();
  Model& model = lookup.model();
  const std::string amplitude = read_amplitude_name(card, model);
  read_op(card, step, Renewal::Kind::nodal, model);
  if (card.has("FOLLOWER"))
    card.refuse("FOLLOWER: abut's nodal forces keep their direction");
  if (step < 0)
    card.fail("expected within a *STEP");
  for (const DataLine& line : card.lines) {
    const auto fields = line.fields();
    Condition c = condition_at(card, line, scope, step, amplitude, lookup);
    c.first = c.last =
        static_cast<int>(card.whole(line, fields.size() > 1 ? fields[1] : "", "a component"));
    c.value = card.number(line, fields, 2, "a force", 0.0);
    if (c.first < 1 || c.first > 6)
      card.fail(line.place, "expected a component from 1 to 6");
    model.forces.push_back(std::move(c));
  }
}

namespace {

/// Direction i to i + 2 of the fields, of length one.
std::array<double, 3> direction(const Card& card, const DataLine& line,
                                const std::vector<std::string>& fields, std::size_t i) {
  std::array<double, 3> d{};
  double length = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    d[k] = card.number(line, fields, i + k, "a direction", 0.0);
    length += d[k] * d[k];
  }
  if (!(length > 0.0))
    card.fail(line.place, "expected a direction of three numbers that are not all zero");
  for (double& x : d)
    x /= std::sqrt(length);
  return d;
}

void read_element_load(Card& card, const DataLine& line, const Scope& scope, Load load,
                       Lookup& lookup) {
  Model& model = lookup.model();
  const auto fields = line.fields();
  load.name = fields[0];
  if (fields[0].empty())
    for (std::size_t e = 0; e < model.elements.size(); ++e)
      load.elements.push_back(static_cast<int>(e));
  else
    load.elements = lookup.elements(card, line, fields[0], scope);
  const std::string label = fields.size() > 1 ? key_of(fields[1]) : "";
  load.value = card.number(line, fields, 2, "a number", 0.0);
  if (label.size() == 2 && label[0] == 'P' && label[1] >= '1' && label[1] <= '6') {
    load.kind = Load::Kind::pressure;
    add_faces(card, line, load.elements, label[1] - '1', model, load.faces);
    load.label = label;
  } else if (label == "GRAV") {
    load.kind = Load::Kind::gravity;
    load.direction = direction(card, line, fields, 3);
  } else if (label == "BX" || label == "BY" || label == "BZ") {
    load.kind = Load::Kind::body_force;
    load.direction[std::size_t(label[1] - 'X')] = 1.0;
  } else {
    card.refuse("'" + label.substr(0, 20) + "': abut has P1 to P6, GRAV, BX, BY and BZ");
    return;
  }
  model.loads.push_back(std::move(load));
}

void read_surface_load(Card& card, const DataLine& line, const Scope& scope, Load load,
                       Lookup& lookup) {
  const auto fields = line.fields();
  const Surface& surface = lookup.surface(card, line.place, fields[0], scope);
  const std::string label = fields.size() > 1 ? key_of(fields[1]) : "";
  if (surface.of_nodes) {
    card.refuse("surface '" + surface.name + "' is of nodes: abut needs faces");
    return;
  }
  load.on_surface = true;
  load.name = surface.name;
  load.faces = surface.faces;
  load.value = card.number(line, fields, 2, "a number", 0.0);
  if (label == "P") {
    load.kind = Load::Kind::pressure;
  } else if (label == "TRVEC") {
    load.kind = Load::Kind::traction;
    load.direction = direction(card, line, fields, 3);
    const auto follower = card.parameter("FOLLOWER");
    const bool turns = !follower || key_of(*follower) != "NO";
    if (turns && lookup.model().steps.back().finite)
      card.refuse(
          "TRVEC turns with the surface: abut's tractions keep their direction, FOLLOWER=NO");
  } else {
    card.refuse("'" + label.substr(0, 20) + "': abut has P and TRVEC");
    return;
  }
  lookup.model().loads.push_back(std::move(load));
}

} // namespace

void read_loads(Card& card, const Scope& scope, int step, Lookup& lookup) {
  card.use();
  Model& model = lookup.model();
  const bool on_surface = card.is("DSLOAD");
  Load load;
  load.step = step;
  load.amplitude = read_amplitude_name(card, model);
  read_op(card, step, on_surface ? Renewal::Kind::surface : Renewal::Kind::element, model);
  card.ignore({"CONSTANT RESULTANT"}, "of a pressure it means nothing");
  if (step < 0)
    card.fail("expected within a *STEP");
  for (const DataLine& line : card.lines) {
    load.place = line.place;
    if (on_surface)
      read_surface_load(card, line, scope, load, lookup);
    else
      read_element_load(card, line, scope, load, lookup);
  }
  if (on_surface)
    card.parameter("FOLLOWER");
}

void read_initial(Card& card, const Scope& scope, Lookup& lookup) {
  card.use();
  const std::string type = key_of(card.required("TYPE"));
  if (type == "TEMPERATURE") {
    card.note("it counts only with *TEMPERATURE in a step");
    return;
  }
  if (type != "VELOCITY") {
    card.refuse("TYPE=" + type.substr(0, 40) + ": abut has VELOCITY");
    return;
  }
  for (const DataLine& line : card.lines) {
    const auto fields = line.fields();
    InitialVelocity v;
    v.place = line.place;
    v.nodes = lookup.nodes(card, line, fields[0], scope);
    const Global component =
        card.whole(line, fields.size() > 1 ? fields[1] : "", "a component from 1 to 3");
    if (component < 1 || component > 3)
      card.fail(line.place, "expected a component from 1 to 3");
    v.component = static_cast<int>(component);
    v.value = card.number(line, fields, 2, "a velocity", 0.0);
    lookup.model().initial_velocities.push_back(std::move(v));
  }
}

} // namespace abut::abaqus
