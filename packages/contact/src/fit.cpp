// SPDX-License-Identifier: BSD-3-Clause
#include "fit.hpp"

#include "abut/contact/interaction.hpp"
#include "kinematics/facet_rise.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace abut::contact {

namespace {

constexpr double small_share = 0.1; ///< a smaller sagitta changes a fit by less
constexpr double grazing = 0.01;    ///< less than this of the sagitta is no fit that was meant

bool is_flat(const Comm& comm, const mesh::Surface& surface) {
  const std::vector<double> rises = facet_rises(comm, surface);
  return !comm.any(std::any_of(rises.begin(), rises.end(), [](double r) { return r != 0.0; }));
}

/// The interface evaluated once, where it starts.
ContactSummary at_start(Interaction& probe, const mesh::Surface& primary,
                        const mesh::Surface& secondary) {
  Local rows = 0;
  for (const mesh::Surface* s : {&primary, &secondary})
    for (const Local n : s->field_index)
      rows = std::max(rows, n + 1);
  const std::vector<double> u(3 * std::size_t(rows), 0.0);
  probe.prepare({u.data(), 3, probe.settings().window.from});
  return probe.summary();
}

} // namespace

std::string warn_of_facets(const Comm& comm, const mesh::Surface& primary,
                           const mesh::Surface& secondary, const ContactOptions& options) {
  const bool flat = is_flat(comm, primary) && is_flat(comm, secondary);
  const std::string entry = "contact." + options.name + ": ";
  if (options.initial_gap == InitialGap::round)
    return flat ? entry + "'initial_gap: round' changes nothing: '" + primary.name + "' and '" +
                      secondary.name + "' have no flat faces with four corners that bend"
                : "";
  if (flat || options.tied || options.interference)
    return "";
  PhaseTimers timers;
  Interaction probe(comm, primary, secondary, options, timers);
  if (probe.settings().initial_gap == InitialGap::round)
    return "";
  const ContactSummary start = at_start(probe, primary, secondary);
  const bool resolves = options.initial_overlap == InitialOverlap::resolve;
  const double meshes =
      options.initial_overlap == InitialOverlap::adjust ? 0.0 : start.initial_overlap;
  const double fit = resolves ? meshes : meshes + std::fabs(options.offset);
  if (start.facet_rise <= small_share * fit || (!resolves && fit < grazing * start.facet_rise))
    return "";
  char numbers[160];
  std::snprintf(numbers, sizeof numbers,
                "by up to %.3g, and the fit at the start is %.3g: ", start.facet_rise, fit);
  return entry + "the flat faces of '" + primary.name + "' and '" + secondary.name +
         "' miss the gap of the round surfaces that they stand for " + numbers +
         (probe.settings().initial_gap == InitialGap::close ? "'initial_overlap: adjust'"
                                                            : "'initial_gap: round'") +
         " takes that out, where the bodies slide little";
}

} // namespace abut::contact
