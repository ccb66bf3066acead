// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/external_work.hpp"

namespace abut::assembly {

void WorkLedger::add(State now, const std::vector<char>& constrained, std::size_t node_rows,
                     const rigid::Joints& joints, const Comm& comm) {
  State& last = last_;
  last.x.resize(now.x.size(), 0.0);
  last.loads.resize(now.x.size(), 0.0);
  last.raw.resize(now.x.size(), 0.0);
  last.bodies.resize(now.bodies.size());
  last.joints.resize(now.joints.size());
  double sums[2] = {0.0, 0.0};
  for (std::size_t i = 0; i < now.x.size(); ++i) {
    const double dx = now.x[i] - last.x[i];
    sums[0] -= 0.5 * (now.loads[i] + last.loads[i]) * dx;
    if (i < node_rows && constrained[i])
      sums[1] += 0.5 * (now.raw[i] + last.raw[i]) * dx;
  }
  if (comm.is_root()) {
    for (std::size_t b = 0; b < now.bodies.size(); ++b) {
      const rigid::BodyState &a = last.bodies[b], &z = now.bodies[b];
      sums[1] += 0.5 * (dot(a.force + z.force, z.displacement - a.displacement) +
                        dot(a.moment + z.moment, z.rotation - a.rotation));
    }
    const std::array<double, 2> work = joints.work(last.joints, now.joints);
    sums[0] += work[0];
    sums[1] += work[1];
  }
  comm.sum(sums, 2);
  work_.loads += sums[0];
  work_.supports += sums[1];
  last = std::move(now);
}

void WorkLedger::exchange_state(StateArchive& archive, const std::vector<Global>& rows) {
  archive.numbers("work",
                  [&](auto& v) { v(work_.loads, work_.supports, last_.bodies, last_.joints); });
  for (auto* list : {&last_.x, &last_.loads, &last_.raw})
    list->resize(3 * rows.size(), 0.0);
  archive.rows("work.unknowns", rows, 3, last_.x.data());
  archive.rows("work.loads", rows, 3, last_.loads.data());
  archive.rows("work.forces", rows, 3, last_.raw.data());
}

} // namespace abut::assembly
