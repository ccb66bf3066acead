// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/equation_system.hpp"

#include "abut/core/trilinos.hpp"
#include "rigid_joints.hpp"
#include "system_parts.hpp"

namespace abut::assembly {

/// Residual of everything that is neither an internal force nor contact, in owned rows. The rigid
/// bodies' sums stay those of the last residual.
std::vector<double> EquationSystem::load_residual() {
  std::vector<double> buffer(static_cast<std::size_t>(pattern_.num_rows()) * dofs_.fields(), 0.0);
  std::vector<double> unused(12 * rigid_->size(), 0.0);
  dofs_.mesh().comm.together([&] {
    for (Part& p : parts_) {
      if (kind(*p.contribution) != Force::other || p.contribution->phase() == Phase::contact)
        continue;
      ResidualScatter scatter = residual_scatter(p, buffer);
      scatter.rigid.force = unused.data();
      p.contribution->residual(fields(), scatter);
    }
  });
  pattern_.add_shared_residual(buffer.data());
  rigid_->add_loads(time_, buffer.data());
  buffer.resize(static_cast<std::size_t>(dofs_.num_rows()) * dofs_.fields());
  return buffer;
}

void EquationSystem::add_work(const Vector& x) {
  std::vector<double> loads = load_residual();
  const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
  std::vector<double> now(loads.size());
  for (std::size_t i = 0; i < now.size(); ++i)
    now[i] = view(i, 0);
  const auto states = rigid_body_states();
  const auto joints = rigid_joint_states();
  WorkState& last = work_state_;
  last.x.resize(now.size(), 0.0);
  last.loads.resize(now.size(), 0.0);
  last.raw.resize(now.size(), 0.0);
  last.bodies.resize(states.size());
  last.joints.resize(joints.size());
  double sums[2] = {0.0, 0.0};
  const auto node_rows = static_cast<std::size_t>(dofs_.num_node_rows()) * dofs_.fields();
  for (std::size_t i = 0; i < now.size(); ++i) {
    const double dx = now[i] - last.x[i];
    sums[0] -= 0.5 * (loads[i] + last.loads[i]) * dx;
    if (i < node_rows && constrained_[i])
      sums[1] += 0.5 * (raw_residual_[i] + last.raw[i]) * dx;
  }
  if (dofs_.mesh().comm.is_root())
    for (std::size_t b = 0; b < states.size(); ++b) {
      const RigidBodyState &a = last.bodies[b], &z = states[b];
      sums[1] += 0.5 * (dot(a.force + z.force, z.displacement - a.displacement) +
                        dot(a.moment + z.moment, z.rotation - a.rotation));
    }
  if (dofs_.mesh().comm.is_root()) {
    const std::array<double, 2> work = joints_->work(last.joints, joints);
    sums[0] += work[0];
    sums[1] += work[1];
  }
  dofs_.mesh().comm.sum(sums, 2);
  external_work_.loads += sums[0];
  external_work_.supports += sums[1];
  last = {std::move(now), std::move(loads), raw_residual_, states, joints};
}

} // namespace abut::assembly
