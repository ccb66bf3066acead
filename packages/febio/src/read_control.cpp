// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include <algorithm>

namespace abut::febio {

namespace {

void read_time_stepper(Element stepper, Step& step) {
  stepper.attribute("type");
  if (auto largest = stepper.child("dtmax")) {
    step.must_points_curve = largest->curve(); // its text may be empty
    if (!largest->text().empty())
      largest->number();
    largest->note("steps never grow beyond step_size");
  }
  stepper.ignore({"max_retries", "opt_iter", "dtmin", "aggressiveness", "cutback", "dtforce"},
                 "abut has its own rule for the size of steps");
}

/// The rule of a dynamic analysis: rhoi between 0 and 1 is generalised alpha, -1 the trapezoidal
/// rule, all else Newmark's with beta and gamma (and alpha, of which abut has 1).
void read_rule(Element solver, Inertia& inertia) {
  const double rhoi = solver.number_or("rhoi", -2.0), alpha = solver.number_or("alpha", 1.0);
  const double beta = solver.number_or("beta", 0.25), gamma = solver.number_or("gamma", 0.5);
  if (rhoi >= 0.0 && rhoi <= 1.0) {
    inertia.spectral_radius = rhoi;
    return;
  }
  if (rhoi == -1.0)
    return;
  if (alpha != 1.0)
    solver.required_child("alpha").refuse(
        "abut has alpha 1; a rhoi between 0 and 1 gives generalised alpha");
  if (!(gamma >= 0.5 && gamma <= 1.0 && 2.0 * beta >= gamma))
    solver.refuse("abut takes beta and gamma of stable rules, 2 beta >= gamma >= 0.5");
  inertia.beta = beta;
  inertia.gamma = gamma;
}

void read_solver(Element solver, Step& step) {
  solver.attribute("type");
  step.displacement_tolerance = solver.number_or("dtol", step.displacement_tolerance);
  step.energy_tolerance = solver.number_or("etol", step.energy_tolerance);
  if (step.inertia.active)
    read_rule(solver, step.inertia);
  solver.ignore_rest("abut has its own Newton method");
}

} // namespace

void read_control(Element section, Model& model) {
  Step step;
  step.line = section.line();
  if (auto analysis = section.child("analysis")) {
    std::string type = analysis->text();
    std::transform(type.begin(), type.end(), type.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    step.inertia.active = type == "DYNAMIC" || type == "1";
    if (!step.inertia.active && type != "STATIC" && type != "0")
      analysis->refuse("'" + type + "': abut has STATIC and DYNAMIC");
    if (!model.steps.empty() && step.inertia.active != model.is_dynamic())
      analysis->refuse("some steps are DYNAMIC and some are not: abut has one kind of analysis");
  }
  step.count = section.whole_or("time_steps", step.count);
  if (step.count < 1)
    section.required_child("time_steps").fail("expected 1 or more");
  step.size = section.number_or("step_size", step.size);
  if (!(step.size > 0.0))
    section.required_child("step_size").fail("expected a number > 0");
  if (auto stepper = section.child("time_stepper"))
    read_time_stepper(*stepper, step);
  if (auto solver = section.child("solver"))
    read_solver(*solver, step);
  if (step.inertia.active && model.is_dynamic() && !(step.inertia == model.steps[0].inertia))
    section.refuse("another rule of time integration than in the first step: abut has one");
  section.ignore({"plot_zero_state", "plot_range", "plot_level", "output_level", "plot_stride",
                  "output_stride", "adaptor_re_solve", "title"},
                 "abut writes every converged step");
  model.steps.push_back(step);
}

} // namespace abut::febio
