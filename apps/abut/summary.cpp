// SPDX-License-Identifier: BSD-3-Clause
#include "summary.hpp"

#include "choices.hpp"

#include "abut/core/error.hpp"
#include "abut/core/machine_error.hpp"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

namespace abut::app {

namespace {

using Json = nlohmann::ordered_json;

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

const char* formulation_name(contact::Formulation formulation) {
  switch (formulation) {
  case contact::Formulation::node_on_facet:
    return "node_on_facet";
  case contact::Formulation::facet_on_facet:
    return "facet_on_facet";
  case contact::Formulation::sliding_elastic:
    return "sliding_elastic";
  }
  throw Defect("a formulation without a name");
}

Json contact_json(const Model& m, const scene::State& s, const scene::PenaltyError& penalty) {
  Json all = Json::object();
  for (std::size_t i = 0; i < s.contacts.size(); ++i) {
    const contact::ContactSummary& c = s.contacts[i];
    const bool augmented = m.contacts[i]->settings().augmented();
    all[m.contacts[i]->name()] = {
        {"formulation", formulation_name(m.contacts[i]->settings().formulation)},
        {"enforcement", augmented ? "augmented_lagrangian" : "penalty"},
        {"active_points", c.active_points},
        {"stick_points", c.stick_points},
        {"slip_points", c.slip_points},
        {"force", c.force},
        {"max_pressure", c.max_pressure},
        {"max_penetration", c.max_penetration},
        {"max_penetration_over_face_size", c.max_penetration_over_face_size},
        {"max_slip", c.max_slip},
        {"flips", c.flips},
        {"friction_dissipation", c.dissipation},
        {"penalty_energy", c.penalty_energy},
        {"penalty_error", penalty.contacts[i]},
        {"penetration_over_approach", penalty.penetration_over_approach[i]},
        {"initial_overlap", c.initial_overlap},
        {"shifted_points", c.shifted_points},
        {"max_shift", c.max_shift},
        {"penalty_factor", c.penalty_factor},
        {"primary", m.contacts[i]->settings().primary},
        {"secondary", m.contacts[i]->settings().secondary},
        {"choices", choices_of(m, m.contacts[i]->settings())}};
  }
  return all;
}

Json list(const Vec3& v) {
  return Json{v[0], v[1], v[2]};
}

Json joints_json(const Model& m, const scene::State& s) {
  Json all = Json::object();
  for (std::size_t i = 0; i < s.joints.size(); ++i)
    all[m.joints[i].name] = {{"force", list(s.joints[i].force)},
                             {"moment", list(s.joints[i].moment)},
                             {"translation", s.joints[i].translation},
                             {"rotation", s.joints[i].rotation}};
  return all;
}

Json rigid_json(const Model& m, const scene::State& s) {
  Json all = Json::object();
  for (std::size_t i = 0; i < s.rigid_bodies.size(); ++i) {
    const rigid::BodyState& body = s.rigid_bodies[i];
    all[m.rigid_bodies[i].name] = {{"displacement", list(body.displacement)},
                                   {"rotation", list(body.rotation)},
                                   {"force", list(body.force)},
                                   {"moment", list(body.moment)}};
  }
  return all;
}

Json audit_json(const RunFacts& facts, double seconds) {
  return {{"overlap", facts.audit.overlap},
          {"overlap_over_face_size", facts.audit.overlap_over_face_size},
          {"unseen_overlap", facts.audit.unseen_overlap},
          {"tension", facts.audit.tension},
          {"cone", facts.audit.cone},
          {"balance", facts.audit.balance},
          {"seconds", seconds}};
}

Json convergence_json(const Convergence& convergence) {
  Json steps = Json::array();
  for (const StepCost& step : convergence.steps())
    steps.push_back({{"step", step.step},
                     {"t", step.t},
                     {"newton_iterations", step.iterations},
                     {"augmentations", step.augmentations},
                     {"cut_backs", step.cuts},
                     {"residuals", step.solves}});
  return {{"steps", steps}, {"failed_residuals", convergence.failed()}};
}

/// Seconds are the largest over the ranks.
Json linear_json(const Comm& comm, const std::vector<solver::LinearUse>& uses) {
  Json all = Json::object();
  for (const solver::LinearUse& use : uses)
    all[use.method] = {{"systems", use.systems},
                       {"solves", use.solves},
                       {"iterations", use.iterations},
                       {"setups", use.setups},
                       {"failures", use.failures},
                       {"seconds", comm.max(use.seconds)},
                       {"setup_seconds", comm.max(use.setup_seconds)},
                       {"apply_seconds", comm.max(use.apply_seconds)}};
  return all;
}

Json phases_json(const Model& m) {
  Json phases = Json::object();
  for (int p = 0; p < phase_count; ++p)
    phases[phase_name(static_cast<Phase>(p))] =
        m.comm.max(m.timers->seconds(static_cast<Phase>(p)));
  return phases;
}

Json energy_json(const scene::Energy& energy) {
  return {{"work_in", energy.work_in},
          {"stored", energy.stored},
          {"penalty", energy.penalty},
          {"friction", energy.friction},
          {"imbalance", energy.imbalance()}};
}

} // namespace

void write_summary(const Model& m, const scene::State& s, const RunFacts& facts,
                   const std::vector<Verdict>& verdicts, const std::string& file) {
  const Json phases = phases_json(m);
  const Json linear = linear_json(m.comm, facts.linear);
  const double audit_seconds = m.comm.max(facts.audit_seconds);
  const Json waiting = {m.comm.min(facts.waiting_seconds), m.comm.max(facts.waiting_seconds)};
  const double memory = m.comm.sum(peak_memory_mb());
  if (file.empty())
    return;
  Json json = {{"status", facts.converged ? "converged" : "stopped"},
               {"deck", m.deck.file},
               {"title", m.deck.title},
               {"results", std::filesystem::path(facts.results).filename().string()},
               {"ranks", m.comm.size()},
               {"unknowns", m.equations->dofs().num_global_rows() * m.equations->dofs().fields()},
               {"steps", s.counters.steps},
               {"t", s.time},
               {"extrapolated_steps", s.counters.extrapolated_steps},
               {"newton_iterations", s.counters.newton_iterations},
               {"augmentations", s.counters.augmentations},
               {"linear_iterations", s.counters.linear_iterations},
               {"linear_solver", linear},
               {"cut_backs", s.counters.cut_backs},
               {"wall_seconds", facts.wall_seconds},
               {"phase_seconds", phases},
               {"waiting_seconds", waiting},
               {"peak_memory_mb", memory},
               {"contact", contact_json(m, s, facts.penalty)},
               {"energy", energy_json(s.energy)},
               {"penalty_error", facts.penalty.whole},
               {"audit", audit_json(facts, audit_seconds)},
               {"verify", Json::array()}};
  if (m.inertia) {
    json["energy"]["kinetic"] = s.energy.kinetic;
    json["momentum"] = list(s.momentum);
    json["angular_momentum"] = list(s.angular_momentum);
  }
  if (!m.rigid_bodies.empty())
    json["rigid_bodies"] = rigid_json(m, s);
  if (!m.joints.empty())
    json["joints"] = joints_json(m, s);
  json["warnings"] = facts.warnings;
  if (!facts.converged)
    json["reason"] = facts.reason;
  for (const Verdict& v : verdicts)
    json["verify"].push_back({{"name", v.name},
                              {"value", v.value},
                              {"expected", v.expected},
                              {"tolerance", v.tolerance},
                              {"ok", v.ok}});
  json["convergence"] = convergence_json(*facts.convergence);
  m.comm.on_root([&] {
    std::ofstream out(file);
    // Names from a mesh may be in any encoding.
    out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    if (!out.flush())
      throw MachineError("cannot write the summary '" + file + "': is the disk full?");
  });
}

} // namespace abut::app
