// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include <algorithm>

namespace abut::febio {

namespace {

void read_time_stepper(Element stepper, Step& step) {
  stepper.attribute("type");
  if (auto largest = stepper.child("dtmax")) {
    step.must_points_curve = largest->value().curve;
    largest->note("steps never grow beyond step_size");
  }
  stepper.ignore({"max_retries", "opt_iter", "dtmin", "aggressiveness", "cutback", "dtforce"},
                 "abut has its own rule for the size of steps");
}

void read_solver(Element solver, Step& step) {
  solver.attribute("type");
  step.displacement_tolerance = solver.number_or("dtol", step.displacement_tolerance);
  step.energy_tolerance = solver.number_or("etol", step.energy_tolerance);
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
    if (type != "STATIC" && type != "0")
      analysis->refuse("'" + type + "': abut is static; set STATIC when inertia does not matter");
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
  section.ignore({"plot_zero_state", "plot_range", "plot_level", "output_level", "plot_stride",
                  "output_stride", "adaptor_re_solve", "title"},
                 "abut writes every converged step");
  model.steps.push_back(step);
}

} // namespace abut::febio
