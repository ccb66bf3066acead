// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/contributions.hpp"

#include "abut/core/error.hpp"

#include <algorithm>

namespace abut::assembly {

namespace {

Force kind(const Contribution& contribution) {
  switch (contribution.role()) {
  case Role::internal:
    return Force::internal;
  case Role::inertia:
    return Force::inertial;
  case Role::external:
  case Role::contact:
    break;
  }
  return Force::other;
}

} // namespace

void Contributions::add(std::shared_ptr<Contribution> contribution) {
  parts_.push_back({std::move(contribution), {}, -1, -1});
}

bool Contributions::prepare(const NodalFields& fields) {
  dofs_.mesh().comm.together([&] {
    for (Part& p : parts_) {
      const PhaseTimers::Scope scope(timers_, p.contribution->phase());
      p.contribution->prepare(fields);
    }
  });
  return update_pattern();
}

/// Positions of the cells that changed; false when one lies outside the pattern.
bool Contributions::locate() {
  bool inside = pattern_.version() > 0;
  for (Part& p : parts_) {
    const long version = p.contribution->connectivity_version();
    if (p.connectivity_version == version && p.pattern_version == pattern_.version())
      continue;
    inside = inside && pattern_.locate(p.contribution->connectivity(), p.positions);
    p.connectivity_version = version;
    p.pattern_version = inside ? pattern_.version() : -1;
  }
  return inside;
}

bool Contributions::update_pattern() {
  const PhaseTimers::Scope scope(timers_, Phase::assembly);
  if (!dofs_.mesh().comm.any(!locate()))
    return false;
  std::vector<const Connectivity*> cells;
  for (const Part& p : parts_) {
    cells.push_back(&p.contribution->candidates());
    if (cells.back() != &p.contribution->connectivity())
      cells.push_back(&p.contribution->connectivity());
  }
  pattern_.build(cells);
  ABUT_REQUIRE(locate(), "a cell lies outside the pattern that was built from it");
  return true;
}

std::vector<double> Contributions::zeros() const {
  return std::vector<double>(static_cast<std::size_t>(pattern_.num_rows()) * dofs_.fields(), 0.0);
}

ResidualScatter Contributions::residual_scatter(const Part& p, rigid::Bodies& bodies,
                                                double* values) const {
  ResidualScatter scatter;
  scatter.fields = dofs_.fields();
  scatter.cell_offset = p.contribution->connectivity().offsets.data();
  scatter.row = p.positions.row.data();
  scatter.values = values;
  scatter.rigid = bodies.scatter(p.positions);
  if (p.contribution->role() == Role::inertia)
    scatter.rigid.force = bodies.inertial_forces();
  return scatter;
}

std::vector<double> Contributions::residual(Force which, const NodalFields& fields,
                                            rigid::Bodies& bodies) {
  std::vector<double> buffer = zeros();
  dofs_.mesh().comm.together([&] {
    for (Part& p : parts_) {
      if (kind(*p.contribution) != which)
        continue;
      const PhaseTimers::Scope scope(timers_, p.contribution->phase());
      p.contribution->residual(fields, residual_scatter(p, bodies, buffer.data()));
    }
  });
  return buffer;
}

std::vector<double> Contributions::linear_residual(const NodalFields& about,
                                                   const NodalFields& fields,
                                                   rigid::Bodies& bodies) {
  constexpr double share = 1e-6;
  std::vector<double> near(static_cast<std::size_t>(dofs_.mesh().num_local()) * dofs_.fields());
  for (std::size_t i = 0; i < near.size(); ++i)
    near[i] = about.u[i] + share * (fields.u[i] - about.u[i]);
  std::vector<double> forces = residual(Force::internal, about, bodies);
  const std::vector<double> moved =
      residual(Force::internal, {near.data(), dofs_.fields(), about.time}, bodies);
  for (std::size_t i = 0; i < forces.size(); ++i)
    forces[i] += (moved[i] - forces[i]) / share;
  return forces;
}

/// Leaves what all ranks make of the owned rows.
void Contributions::finish(std::vector<double>& buffer) const {
  pattern_.add_shared_residual(buffer.data());
  buffer.resize(static_cast<std::size_t>(dofs_.num_rows()) * dofs_.fields());
}

std::vector<double> Contributions::loads(const NodalFields& fields, rigid::Bodies& bodies) {
  std::vector<double> buffer = zeros();
  std::vector<double> unused(12 * bodies.size(), 0.0);
  dofs_.mesh().comm.together([&] {
    for (Part& p : parts_) {
      if (p.contribution->role() != Role::external)
        continue;
      ResidualScatter scatter = residual_scatter(p, bodies, buffer.data());
      scatter.rigid.force = unused.data();
      p.contribution->residual(fields, scatter);
    }
  });
  finish(buffer);
  return buffer;
}

std::vector<double> Contributions::residual_of(std::size_t part, const NodalFields& fields,
                                               rigid::Bodies& bodies) {
  std::vector<double> buffer = zeros();
  dofs_.mesh().comm.together([&] {
    Part& p = parts_[part];
    p.contribution->residual(fields, residual_scatter(p, bodies, buffer.data()));
  });
  finish(buffer);
  return buffer;
}

void Contributions::add_tangent(const Part& p, const NodalFields& fields, rigid::Bodies& bodies,
                                double* values) {
  const PhaseTimers::Scope scope(timers_, p.contribution->phase());
  TangentScatter scatter;
  scatter.fields = dofs_.fields();
  scatter.cell_offset = p.contribution->connectivity().offsets.data();
  scatter.row = p.positions.row.data();
  scatter.block_offset = p.positions.block_offset.data();
  scatter.block_position = p.positions.block_position.data();
  scatter.row_length = pattern_.row_length().data();
  scatter.values = values;
  scatter.rigid = bodies.scatter(p.positions);
  p.contribution->tangent(fields, scatter);
}

void Contributions::add_tangents(Force which, const NodalFields& fields, rigid::Bodies& bodies,
                                 double* values) {
  const auto wanted = [&](const Part& p) { return kind(*p.contribution) == which; };
  if (std::none_of(parts_.begin(), parts_.end(), wanted))
    return;
  dofs_.mesh().comm.together([&] {
    for (const Part& p : parts_)
      if (wanted(p))
        add_tangent(p, fields, bodies, values);
  });
}

void Contributions::add_tangent_of(std::size_t part, const NodalFields& fields,
                                   rigid::Bodies& bodies, double* values) {
  dofs_.mesh().comm.together([&] { add_tangent(parts_[part], fields, bodies, values); });
}

void Contributions::begin_step() {
  for (Part& p : parts_)
    p.contribution->begin_step();
}

void Contributions::begin_solve(SolveKind kind) {
  for (Part& p : parts_)
    p.contribution->begin_solve(kind);
}

void Contributions::iterate_taken() {
  for (Part& p : parts_)
    p.contribution->iterate_taken();
}

void Contributions::accept() {
  for (Part& p : parts_)
    p.contribution->accept();
}

void Contributions::reject() {
  for (Part& p : parts_)
    p.contribution->reject();
}

bool Contributions::symmetric() const {
  return std::all_of(parts_.begin(), parts_.end(),
                     [](const Part& p) { return p.contribution->symmetric(); });
}

double Contributions::round_off_force2() const {
  double sum = 0.0;
  for (const Part& p : parts_)
    sum += p.contribution->round_off_force2();
  return sum;
}

long Contributions::state_version() const {
  long sum = 0;
  for (const Part& p : parts_)
    sum += p.contribution->state_version();
  return sum;
}

int Contributions::unsettled() const {
  return static_cast<int>(std::count_if(parts_.begin(), parts_.end(),
                                        [](const Part& p) { return !p.contribution->settled(); }));
}

bool Contributions::land() const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [](const Part& p) { return p.contribution->lands(); });
}

int Contributions::overloaded() const {
  return static_cast<int>(std::count_if(
      parts_.begin(), parts_.end(), [](const Part& p) { return p.contribution->overloaded(); }));
}

} // namespace abut::assembly
