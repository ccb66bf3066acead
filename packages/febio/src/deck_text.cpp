// SPDX-License-Identifier: BSD-3-Clause
#include "deck_text.hpp"

#include "abut/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace abut::febio {

namespace {

/// Times that a step must end at: ends of the parts, and must points within them.
std::vector<double> must_points(const Model& model) {
  std::vector<double> times;
  for (std::size_t s = 0; s < model.steps.size(); ++s) {
    const Step& step = model.steps[s];
    const double start = model.start(s), end = model.start(s + 1);
    times.push_back(end);
    if (step.must_points_curve == 0)
      continue;
    const auto curve = model.curves.find(step.must_points_curve);
    if (curve == model.curves.end())
      throw InputError(model.where(step.line) + ": there is no load controller " +
                       std::to_string(step.must_points_curve) + " for dtmax");
    for (const auto& p : curve->second.points)
      if (p[0] > start && p[0] < end)
        times.push_back(p[0]);
  }
  return times;
}

/// Steps of one size, the smallest of the file's or finer, that meet all points that must be met.
int step_count(const Model& model, Report& report) {
  constexpr int finest = 20;
  const std::vector<double> times = must_points(model);
  const double end = model.end();
  double size = end;
  for (const Step& step : model.steps)
    size = std::min(size, step.size);
  const int count = static_cast<int>(std::lround(end / size));
  for (int finer = 1; finer <= finest; ++finer) {
    const int steps = finer * count;
    if (std::all_of(times.begin(), times.end(), [&](double t) {
          return std::abs(t / end * steps - std::round(t / end * steps)) < 1e-6;
        }))
      return steps;
  }
  if (model.steps.size() > 1)
    report.add({model.steps[0].line, "Control", Fate::refused,
                "abut's steps have one size, and none above a twentieth of the smallest step_size "
                "meets the ends of all steps: choose sizes that have a common measure"});
  return count;
}

std::string comment(const std::string& name, const std::string& febio, const std::string& more) {
  std::string text = name == febio || febio.empty() ? "" : febio;
  if (!more.empty())
    text += (text.empty() ? "" : ", ") + more;
  return text.empty() ? "" : "  # FEBio: " + text;
}

constexpr const char* components[] = {"x", "y", "z", "rx", "ry", "rz"};

class DeckWriter {
public:
  DeckWriter(const Model& model, MeshTranslation& mesh, Report& report)
      : model_(model), mesh_(mesh), report_(report), curves_(model),
        rigid_(rigid_bodies(model, mesh, report)) {}

  std::string text(const std::string& name) {
    const std::string file = model_.file.substr(model_.file.find_last_of('/') + 1);
    std::string out = "# From FEBio's " + file + "\ntitle: " + quoted(name) +
                      "\nmesh: {file: " + quoted(name + ".exo") + "}\n";
    out += materials();
    out += bodies();
    out += joints_text(model_, rigid_, curves_, report_);
    out += displacements_text(model_, rigid_, mesh_, curves_, report_);
    const std::string loads_part = loads();
    const std::string contact_part = contact_text(model_, mesh_, curves_, report_);
    out += loads_part + curves_.text() + contact_part;
    out += "time: {end: " + number_text(model_.end()) +
           ", steps: " + std::to_string(step_count(model_, report_)) + "}\n";
    out += dynamics() + newton();
    return out + "output: {name: " + quoted(name + "_results") + "}\n";
  }

private:
  /// FEBio's own tolerances, the tightest of all steps.
  std::string newton() const {
    const auto tightest = [&](double Step::*tolerance) {
      double value = model_.steps.front().*tolerance;
      for (const Step& step : model_.steps)
        value = std::min(value, step.*tolerance);
      return value;
    };
    const double correction = tightest(&Step::displacement_tolerance);
    const double energy = tightest(&Step::energy_tolerance);
    if (!(correction > 0.0) || !(energy > 0.0))
      return "";
    FlowMap map;
    map.add("displacement_tolerance", correction);
    if (energy != Step().energy_tolerance) // abut's default is FEBio's
      map.add("energy_tolerance", energy);
    return "newton: " + map.text() + "  # FEBio: dtol, etol\n";
  }

  std::string dynamics() {
    for (const InitialVelocity& v : model_.initial_velocities)
      if (!model_.is_dynamic())
        report_.add({v.line, "initial velocity '" + v.name + "'", Fate::ignored,
                     "the analysis is STATIC: a velocity means nothing"});
    if (!model_.is_dynamic())
      return "";
    const Inertia& inertia = model_.steps[0].inertia;
    FlowMap map;
    if (inertia.spectral_radius != 1.0)
      map.add("spectral_radius", inertia.spectral_radius);
    if (inertia.beta != 0.25)
      map.add("beta", inertia.beta);
    if (inertia.gamma != 0.5)
      map.add("gamma", inertia.gamma);
    return "dynamics: " + map.text() + "\n";
  }

  /// Velocity at the start of a deformable domain, all of whose nodes have the same.
  std::array<double, 3> initial_velocity(const Domain& domain) {
    std::array<double, 3> result{};
    for (const InitialVelocity& v : model_.initial_velocities) {
      if (v.place.empty() || !model_.is_dynamic())
        continue;
      const std::vector<Global> list = mesh_.nodes_of(v.place, v.line);
      const std::set<Global> nodes(list.begin(), list.end());
      const auto has = [&](Global id) { return nodes.count(id) > 0; };
      if (std::all_of(domain.nodes.begin(), domain.nodes.end(), has))
        result = v.value;
      else if (std::any_of(domain.nodes.begin(), domain.nodes.end(), has))
        report_.add({v.line, "Initial/ic '" + v.name + "'", Fate::refused,
                     "it holds for some nodes of <Elements> '" + domain.name +
                         "': abut takes one velocity for all of a body"});
    }
    return result;
  }

  std::string law(const Material& m) const {
    FlowMap map;
    const auto& x = m.numbers;
    if (m.is_mooney_rivlin()) {
      map.add("model", "mooney_rivlin");
      map.add("c1", x.at("c1"));
      if (x.at("c2") != 0.0)
        map.add("c2", x.at("c2"));
      map.add("bulk", x.at("k"));
    } else if (m.type == "Ogden" || m.type == "Ogden unconstrained") {
      map.add("model", m.type == "Ogden" ? "ogden" : "ogden_unconstrained");
      std::vector<std::string> c, power;
      for (const char k : {'1', '2', '3', '4', '5', '6'})
        if (x.at(std::string("c") + k) != 0.0) {
          c.push_back(number_text(x.at(std::string("c") + k)));
          power.push_back(number_text(x.at(std::string("m") + k)));
        }
      map.add("coefficients", list_text(c));
      map.add("exponents", list_text(power));
      if (m.type == "Ogden")
        map.add("bulk", x.at("k"));
      else
        map.add("lambda", x.at("cp"));
    } else {
      if (m.type == "Holmes-Mow")
        map.add("model", "holmes_mow");
      else if (m.type != "neo-Hookean")
        map.add("model", "saint_venant_kirchhoff");
      map.add("young", x.at("E"));
      map.add("poisson", x.at("v"));
      if (m.type == "Holmes-Mow")
        map.add("beta", x.at("beta"));
    }
    if (model_.is_dynamic())
      map.add("density", x.at("density"));
    return map.text();
  }

  std::string materials() {
    std::string out;
    for (const Material& m : model_.materials) {
      const bool used = std::any_of(model_.mesh.domains.begin(), model_.mesh.domains.end(),
                                    [&](const Domain& d) { return d.material == m.name; });
      if (m.is_rigid())
        continue;
      if (!used) {
        report_.add({m.line, "Material/material '" + m.name + "'", Fate::ignored,
                     "no <SolidDomain> is made of it"});
        continue;
      }
      const std::string name = material_name_[m.name] = material_names_.make(m.name, "material");
      out += "  " + name + ": " + law(m) + comment(name, m.name, m.type) + "\n";
    }
    return out.empty() ? "" : "materials:\n" + out;
  }

  /// FEBio's default: a three-field hexahedron for uncoupled materials.
  std::string element(const Domain& d) const {
    const bool uncoupled = model_.material(d.material)->numbers.count("k") > 0;
    return uncoupled && d.cell == fem::CellType::hex8 ? "mean_dilatation" : "displacement";
  }

  std::string bodies() {
    std::string out;
    DeckNames names;
    for (const Domain& d : model_.mesh.domains) {
      if (model_.material(d.material)->is_rigid())
        continue;
      const std::string name = names.make(d.name, "body");
      FlowMap map;
      map.add("blocks", list_text({quoted(d.name)}));
      map.add("material", material_name_.at(d.material));
      map.add("element", element(d));
      add_vector(map, "initial_velocity", initial_velocity(d));
      out += "  " + name + ": " + map.text() + "\n";
    }
    for (RigidBody& body : rigid_.bodies) {
      if (body.is_displacement())
        continue;
      const std::string name = body.deck_name = names.make(body.materials[0], "rigid");
      std::string febio;
      for (const std::string& m : body.materials)
        febio += (febio.empty() ? "" : " and ") + m;
      out += "  " + name + ":" + comment(name, febio, "") + "\n" + members(body) + "    rigid:";
      const FlowMap map = motion(body);
      const std::string held = holds(body);
      out += held.empty() ? " " + map.text() + "\n" : "\n" + map.lines("      ") + held;
      if (body.velocity != std::array<double, 3>{})
        out += "    initial_velocity: " + vector_text(body.velocity) + "\n";
      if (body.spin != std::array<double, 3>{})
        out += "    initial_angular_velocity: " + vector_text(body.spin) + "\n";
    }
    return "bodies:\n" + out;
  }

  std::string members(const RigidBody& body) const {
    std::vector<std::string> blocks, sets;
    for (const std::size_t d : body.domains)
      blocks.push_back(quoted(model_.mesh.domains[d].name));
    for (const std::string& set : body.sets)
      sets.push_back(quoted(set));
    return (blocks.empty() ? "" : "    blocks: " + list_text(blocks) + "\n") +
           (sets.empty() ? "" : "    node_sets: " + list_text(sets) + "\n");
  }

  /// Unless it is zero.
  static void add_vector(FlowMap& map, const char* key, const std::array<double, 3>& v) {
    if (v != std::array<double, 3>{})
      map.add(key, vector_text(v));
  }

  /// What holds free components for a time.
  std::string holds(const RigidBody& body) {
    struct Entry {
      PartHold hold;
      std::string curve;
      std::vector<std::size_t> components;
    };
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < 6; ++i)
      for (const PartHold& hold : body.holds[i]) {
        auto same = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) {
          return e.hold.condition == hold.condition && e.hold.window == hold.window;
        });
        if (same == entries.end()) {
          const bool fixed = hold.condition->fixed;
          entries.push_back({hold, fixed ? "" : curves_.of(hold.condition->value), {}});
          same = entries.end() - 1;
        }
        same->components.push_back(i);
      }
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return a.hold.window.from < b.hold.window.from;
    });
    std::string out;
    DeckNames names;
    for (const Entry& e : entries) {
      FlowMap map;
      std::vector<std::string> fixed;
      for (const std::size_t i : e.components)
        if (e.hold.condition->fixed)
          fixed.push_back(components[i]);
        else
          map.add(components[i], e.hold.condition->value.number);
      if (!fixed.empty())
        map.add("fix", list_text(fixed));
      else
        map.add("curve", e.curve);
      add_window(map, e.hold.window);
      if (e.hold.relative)
        map.add("relative", "true");
      const std::string name = names.make(e.hold.condition->name, "hold");
      out +=
          "        " + name + ": " + map.text() + comment(name, e.hold.condition->name, "") + "\n";
    }
    return out.empty() ? "" : "      holds:\n" + out;
  }

  FlowMap motion(const RigidBody& body) {
    FlowMap map;
    const auto part = [](const std::array<Timed, 6>& a, std::size_t first) {
      return std::array<double, 3>{a[first].number, a[first + 1].number, a[first + 2].number};
    };
    const auto add = [&](const char* key, const std::array<double, 3>& v) {
      add_vector(map, key, v);
    };
    const std::array<Timed, 6> motion = timed(body.motion);
    add("displacement", part(motion, 0));
    add("rotation", part(motion, 3));
    add("center", {body.center[0], body.center[1], body.center[2]});
    add_curves(map, motion, "curve");
    std::vector<std::string> free;
    for (std::size_t i = 0; i < 6; ++i)
      if (body.free[i])
        free.push_back(components[i]);
    if (!free.empty())
      map.add("free", list_text(free));
    const std::array<Timed, 6> load = timed(body.load);
    add("force", part(load, 0));
    add("moment", part(load, 3));
    add_curves(map, load, "load_curve");
    if (body.is_loaded() && body.follower)
      map.add("follower", "true");
    if (body.density > 0.0)
      map.add("density", body.density);
    return map;
  }

  std::array<Timed, 6> timed(const std::array<Course, 6>& courses) {
    std::array<Timed, 6> result;
    for (std::size_t i = 0; i < 6; ++i)
      if (!courses[i].empty())
        result[i] = curves_.of(courses[i]);
    return result;
  }

  /// One curve, or a map of curves where components differ.
  static void add_curves(FlowMap& map, const std::array<Timed, 6>& values, const std::string& key) {
    FlowMap each;
    std::set<std::string> names;
    for (std::size_t i = 0; i < 6; ++i)
      if (!values[i].curve.empty()) {
        each.add(components[i], values[i].curve);
        names.insert(values[i].curve);
      }
    if (names.size() == 1)
      map.add(key, *names.begin());
    else if (names.size() > 1)
      map.add(key + "s", each.text());
  }

  /// Entries of one load: components that follow one curve stand together.
  void add_load(const Load& l, const std::string& name, const char* key, double factor,
                const std::string& place_key, const std::string& place) {
    std::map<int, std::array<double, 3>> parts;
    for (std::size_t i = 0; i < 3; ++i)
      if (!l.vector[i].is_zero())
        parts[l.vector[i].curve][i] = factor * l.vector[i].number;
    for (const auto& [curve, vector] : parts) {
      FlowMap map;
      map.add(key, vector_text(vector));
      map.add(place_key, quoted(place));
      if (l.current_area)
        map.add("current_area", "true");
      map.add("curve", curves_.of(model_.course({1.0, curve, l.line}, l.step)).curve);
      const std::string unique = load_names_.make(name, "load");
      loads_ += "  " + unique + ": " + map.text() + comment(unique, l.name, "") + "\n";
    }
  }

  void require_outward(const Load& l) {
    if (!mesh_.points_outwards(l.place))
      report_.add({l.line, "Loads/surface_load '" + l.name + "'", Fate::refused,
                   "the faces of surface '" + l.place + "' point into their bodies"});
  }

  std::string loads() {
    for (const Load& l : model_.loads) {
      switch (l.kind) {
      case Load::Kind::pressure: {
        require_outward(l);
        FlowMap map;
        const Value factor = {1.0, l.vector[0].curve, l.line};
        map.add("pressure", l.vector[0].number);
        map.add("side_set", quoted(l.place));
        map.add("curve", curves_.of(model_.course(factor, l.step)).curve);
        const std::string name = load_names_.make(l.name, "pressure");
        loads_ += "  " + name + ": " + map.text() + comment(name, l.name, "") + "\n";
        break;
      }
      case Load::Kind::traction:
        add_load(l, l.name.empty() ? "traction" : l.name, "traction", 1.0, "side_set", l.place);
        break;
      case Load::Kind::nodal:
        add_load(l, l.name.empty() ? "force" : l.name, "force", 1.0, "node_set", node_set(l));
        break;
      case Load::Kind::body_force:
        for (const Domain& d : model_.mesh.domains)
          if (!model_.material(d.material)->is_rigid() && (l.place.empty() || l.place == d.name))
            add_load(l, (l.name.empty() ? "weight" : l.name) + "_of_" + d.name, "body_force",
                     -model_.material(d.material)->numbers.at("density"), "block", d.name);
        break;
      }
    }
    return loads_.empty() ? "" : "loads:\n" + loads_;
  }

  /// A node set that is not a side set.
  std::string node_set(const Load& l) {
    const std::string name = mesh_.set_of(mesh_.nodes_of(l.place, l.line), l.place);
    if (!mesh_.data().node_sets.count(name))
      throw InputError(model_.where(l.line) + ": a nodal load needs a node set, not '" + l.place +
                       "'");
    return name;
  }

  const Model& model_;
  MeshTranslation& mesh_;
  Report& report_;
  DeckCurves curves_;
  RigidBodies rigid_;
  DeckNames material_names_, load_names_;
  std::map<std::string, std::string> material_name_;
  std::string loads_;
};

} // namespace

std::string deck_text(const Model& model, const std::string& name, MeshTranslation& mesh,
                      Report& report) {
  return DeckWriter(model, mesh, report).text(name);
}

} // namespace abut::febio
