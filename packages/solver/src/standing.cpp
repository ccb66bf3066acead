// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solver/standing.hpp"

#include "abut/core/trilinos.hpp"

namespace abut::solver {

void exchange_state(StateArchive& archive, const RCP<const Map>& map,
                    const std::vector<Global>& rows, Standing& standing) {
  std::array<bool, 2> known{};
  for (std::size_t i = 0; i < 2; ++i)
    known[i] = !standing.motions[i].velocity.is_null();
  archive.numbers("steps", [&](auto& v) {
    v(standing.t, standing.dt, standing.nominal, standing.counters, known, standing.motions[0].dt,
      standing.motions[1].dt);
  });
  for (std::size_t i = 0; i < 2; ++i) {
    StepMotion& motion = standing.motions[i];
    if (!known[i]) {
      motion.velocity = Teuchos::null;
      continue;
    }
    const auto velocity =
        archive.takes() ? rcp(new Vector(map)) : rcp(new Vector(*motion.velocity, Teuchos::Copy));
    archive.rows(i == 0 ? "steps.velocity" : "steps.velocity_before", rows, 3,
                 velocity->getLocalViewHost(Tpetra::Access::ReadWrite).data());
    motion.velocity = velocity;
  }
}

} // namespace abut::solver
