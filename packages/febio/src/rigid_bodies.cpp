// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "deck_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace abut::febio {

namespace {

class Builder {
public:
  Builder(const Model& model, MeshTranslation& mesh, Report& report)
      : model_(model), mesh_(mesh), report_(report) {
    for (const Material& m : model.materials)
      if (m.is_rigid())
        names_.push_back(m.name);
    group_.resize(names_.size());
    std::iota(group_.begin(), group_.end(), std::size_t(0));
  }

  RigidBodies build() {
    members();
    bodies();
    held_.resize(result_.bodies.size());
    for (const RigidCondition& c : model_.rigid_conditions)
      condition(c);
    for (std::size_t b = 0; b < result_.bodies.size(); ++b)
      free_components(b);
    for (const RigidLoad& l : model_.rigid_loads)
      load(l);
    for (const RigidConnector& c : model_.connectors)
      for (const std::string& material : c.bodies)
        if (RigidBody* body = find(material))
          body->is_jointed = true;
    for (const Load& l : model_.loads)
      if (l.kind == Load::Kind::body_force)
        for (RigidBody& body : result_.bodies)
          weight(l, body);
    for (RigidBody& body : result_.bodies) {
      const bool moves = model_.is_dynamic() && is_free(body);
      if (body.turns() || body.is_loaded() || moves)
        body.center = center(body);
      if (moves)
        inertia(body);
    }
    for (const InitialVelocity& v : model_.initial_velocities)
      velocity(v);
    return std::move(result_);
  }

private:
  std::size_t index(const std::string& material) const {
    return static_cast<std::size_t>(std::find(names_.begin(), names_.end(), material) -
                                    names_.begin());
  }

  /// Nodes of each rigid material; two that share a node become one.
  void members() {
    for (std::size_t d = 0; d < model_.mesh.domains.size(); ++d) {
      const Domain& domain = model_.mesh.domains[d];
      if (model_.material(domain.material)->is_rigid())
        for (const Global id : domain.nodes)
          claim(id, index(domain.material));
    }
    for (const RigidTie& tie : model_.ties)
      if (tie.step >= 0 && model_.steps.size() > 1)
        report_.add({tie.line, "Boundary/bc '" + tie.name + "'", Fate::refused,
                     "nodes move with the rigid body in one step alone: put it outside of the "
                     "steps, or make a file of each step"});
    for (const RigidTie& tie : model_.ties)
      for (const Global id : mesh_.nodes_of(tie.place, tie.line))
        claim(id, index(tie.body));
  }
  void claim(Global id, std::size_t material) {
    const auto [it, is_new] = owner_.emplace(id, material);
    const std::size_t a = group_[it->second], b = group_[material];
    if (!is_new && a != b)
      std::replace(group_.begin(), group_.end(), std::max(a, b), std::min(a, b));
  }

  void bodies() {
    body_of_group_.assign(names_.size(), -1);
    for (const auto& entry : owner_)
      body_of_group_[group_[entry.second]] = 0;
    for (std::size_t g = 0; g < names_.size(); ++g) {
      if (body_of_group_[g] < 0)
        continue;
      body_of_group_[g] = static_cast<int>(result_.bodies.size());
      RigidBody body;
      for (std::size_t m = 0; m < names_.size(); ++m)
        if (group_[m] == g)
          body.materials.push_back(names_[m]);
      body.free.fill(true);
      result_.bodies.push_back(std::move(body));
    }
    for (const auto& [id, material] : owner_)
      result_.body_of_node[id] = body_of_group_[group_[material]];
    for (std::size_t d = 0; d < model_.mesh.domains.size(); ++d)
      if (RigidBody* body = find(model_.mesh.domains[d].material))
        body->domains.push_back(d);
    for (const RigidTie& tie : model_.ties) {
      const std::vector<Global> nodes = mesh_.nodes_of(tie.place, tie.line);
      if (!nodes.empty())
        find(tie.body)->sets.push_back(mesh_.set_of(nodes, tie.place));
    }
  }

  RigidBody* find(const std::string& material) {
    const std::size_t m = index(material);
    if (m == names_.size() || body_of_group_[group_[m]] < 0)
      return nullptr;
    return &result_.bodies[static_cast<std::size_t>(body_of_group_[group_[m]])];
  }

  void without_nodes(int line, const std::string& name) {
    report_.add({line, "Rigid '" + name + "'", Fate::ignored,
                 "the rigid body has neither elements nor nodes"});
  }

  /// Adds a value that holds in one step, or in all, to what is there. False: a step has one.
  bool add(Course& course, const Value& value, int step) const {
    const Course more = model_.course(value, step);
    if (course.size() < more.size())
      course = Course(more.size(), course.empty() ? Value{} : course[0]);
    for (std::size_t s = 0; s < course.size(); ++s) {
      const Value& v = more[more.size() == 1 ? 0 : s];
      if (v.is_zero())
        continue;
      if (!course[s].is_zero())
        return false;
      course[s] = v;
    }
    return true;
  }

  void condition(const RigidCondition& c) {
    RigidBody* body = find(c.body);
    if (!body)
      return without_nodes(c.line, c.name);
    Holders& held = held_[static_cast<std::size_t>(body - result_.bodies.data())];
    for (std::size_t i = 0; i < 6; ++i) {
      if (!c.components[i])
        continue;
      held[i].push_back(&c);
      if (!c.value.is_zero() && !add(body->motion[i], c.value, c.step))
        throw InputError(model_.where(c.line) + ": component " + "xyzuvw"[i] + " of rigid body '" +
                         c.body + "' is prescribed twice");
    }
  }

  using InSteps = std::vector<const RigidCondition*>; ///< (steps) null: free

  /// What rules a component in each step: a prescribed motion before one that is fixed.
  InSteps in_steps(const std::vector<const RigidCondition*>& list) const {
    InSteps result(model_.steps.size(), nullptr);
    for (const RigidCondition* c : list)
      for (std::size_t s = 0; s < result.size(); ++s)
        if ((c->step < 0 || c->step == static_cast<int>(s)) && (!result[s] || result[s]->fixed))
          result[s] = c;
    return result;
  }

  /// Whether one function of time says where the component is: it is held in all steps, from the
  /// reference configuration, and not stopped where it happens to be.
  static bool is_function(const InSteps& in_steps) {
    bool moved = false;
    for (const RigidCondition* c : in_steps) {
      if (!c || c->relative || (c->fixed && moved))
        return false;
      moved = moved || !c->value.is_zero();
    }
    return true;
  }

  void free_components(std::size_t b) {
    RigidBody& body = result_.bodies[b];
    for (std::size_t i = 0; i < 6; ++i) {
      const InSteps steps = in_steps(held_[b][i]);
      body.free[i] = !is_function(steps);
      if (!body.free[i])
        continue;
      body.motion[i].clear();
      for (std::size_t s = 0; s < steps.size(); ++s) {
        const RigidCondition* c = steps[s];
        if (!c)
          continue;
        const std::size_t first = s;
        while (c->fixed && s + 1 < steps.size() && steps[s + 1] && steps[s + 1]->fixed)
          ++s;
        body.holds[i].push_back(
            {c, model_.window(first, s), c->relative || (c->fixed && first > 0)});
      }
    }
  }

  void load(const RigidLoad& l) {
    RigidBody* body = find(l.body);
    if (!body)
      return without_nodes(l.line, l.name);
    if (l.value.is_zero())
      return;
    const std::size_t i = static_cast<std::size_t>(l.component);
    if (!body->free[i])
      throw InputError(model_.where(l.line) + ": rigid body '" + l.body +
                       "' is held in the component that is loaded");
    if (body->is_loaded() && body->follower != l.follower)
      report_.add({l.line, "Rigid '" + l.name + "'", Fate::refused,
                   "loads of one body are all of load_type LOAD or all FOLLOW"});
    body->follower = l.follower;
    if (!add(body->load[i], l.value, l.step))
      report_.add({l.line, "Rigid '" + l.name + "'", Fate::refused,
                   "another load acts on this component: give their sum"});
  }

  static bool is_free(const RigidBody& body) {
    return std::find(body.free.begin(), body.free.end(), true) != body.free.end();
  }

  double mass(std::size_t domain) const {
    return mesh_.bulk(domain).volume *
           model_.material(model_.mesh.domains[domain].material)->numbers.at("density");
  }

  /// A body force on a rigid body is a force on its center: minus the mass times what is given.
  void weight(const Load& l, RigidBody& body) {
    double mass_of_all = 0.0;
    for (const std::size_t d : body.domains)
      if (l.place.empty() || l.place == model_.mesh.domains[d].name)
        mass_of_all += mass(d);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!body.free[i] || l.vector[i].is_zero() || mass_of_all == 0.0)
        continue;
      Value force = l.vector[i];
      force.number = rounded(-mass_of_all * force.number, 12);
      if (!add(body.load[i], force, l.step))
        report_.add({l.line, "Loads/body_load '" + l.name + "'", Fate::refused,
                     "another load acts on rigid body '" + body.materials[0] +
                         "': give their sum as a rigid_force"});
    }
  }

  Vec3 centroid(const RigidBody& body) const {
    double all = 0.0;
    Vec3 moment = Vec3::zero();
    for (const std::size_t d : body.domains) {
      all += mass(d);
      moment += mass(d) * mesh_.bulk(d).centroid;
    }
    if (!(all > 0.0))
      return Vec3::zero();
    Vec3 center = 1.0 / all * moment;
    const double noise = 1e-12 * norm(center);
    for (double& x : center.v)
      x = std::abs(x) > noise ? rounded(x, 12) : 0.0; // the digits that are known
    return center;
  }

  Vec3 center(const RigidBody& body) const {
    for (const std::string& name : body.materials)
      if (const auto& given = model_.material(name)->center_of_mass)
        return *given;
    return centroid(body);
  }

  void inertia(RigidBody& body) {
    const int line = model_.material(body.materials[0])->line;
    const std::string where = "Material/material '" + body.materials[0] + "'";
    for (const std::size_t d : body.domains) {
      if (model_.mesh.domains[d].is_shell)
        report_.add({model_.mesh.domains[d].line, "Elements '" + model_.mesh.domains[d].name + "'",
                     Fate::refused,
                     "a free rigid body of shells with inertia, which abut takes from solid "
                     "elements: extrude it to hex8 or penta6"});
      const double density =
          model_.material(model_.mesh.domains[d].material)->numbers.at("density");
      if (body.density != 0.0 && density != body.density)
        report_.add({line, where, Fate::refused,
                     "rigid bodies that are one have different densities: abut has one a body"});
      body.density = density;
    }
    if (!(body.density > 0.0))
      report_.add({line, where, Fate::refused,
                   "the rigid body is free and has no mass: give it elements and a density"});
    const Vec3 off = body.center - centroid(body);
    if (body.turns() && norm(off) > 1e-6 * (norm(body.center) + norm(off)))
      report_.add({line, where, Fate::refused,
                   "center_of_mass is not that of the elements, which abut takes for inertia"});
  }

  void velocity(const InitialVelocity& v) {
    if (v.body.empty() || !model_.is_dynamic())
      return;
    RigidBody* body = find(v.body);
    if (!body)
      return without_nodes(v.line, v.name);
    auto& value = v.turns ? body->spin : body->velocity;
    for (std::size_t i = 0; i < 3; ++i)
      if (body->free[i + (v.turns ? 3 : 0)])
        value[i] = v.value[i];
  }

  const Model& model_;
  MeshTranslation& mesh_;
  Report& report_;
  std::vector<std::string> names_; ///< of rigid materials
  std::vector<std::size_t> group_; ///< first material of the merged ones
  std::vector<int> body_of_group_; ///< -1: no nodes
  std::map<Global, std::size_t> owner_;
  using Holders = std::array<std::vector<const RigidCondition*>, 6>;
  std::vector<Holders> held_; ///< (bodies)
  RigidBodies result_;
};

} // namespace

RigidBodies rigid_bodies(const Model& model, MeshTranslation& mesh, Report& report) {
  return Builder(model, mesh, report).build();
}

} // namespace abut::febio
