// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/passes.hpp"

#include "abut/contact/option_error.hpp"
#include "fit.hpp"

#include <cstdio>
#include <utility>

namespace abut::contact {

namespace {

std::string warn_of_side(const Settings& settings, const SideComparison& sides) {
  char numbers[160];
  std::snprintf(numbers, sizeof numbers,
                "is %.3g times as stiff as the secondary and its faces are %.3g times their size",
                sides.stiffness, sides.size);
  return "contact." + settings.name + ": the primary '" + settings.primary + "' " + numbers +
         ": pressures will oscillate. Swap primary and secondary, or give 'primary_side: "
         "automatic'";
}

/// The curve that the option at `path` names.
std::function<double(double)> curve(const HostFacts& host, const std::string& path,
                                    const std::string& name) {
  if (name.empty())
    return {};
  if (!host.curve)
    throw OptionError(path, "there is no curve '" + name + "'");
  return host.curve(name);
}

std::shared_ptr<Interaction> make_pass(const Comm& comm, const mesh::Surface& primary,
                                       const mesh::Surface& secondary,
                                       const ContactOptions& options, PhaseTimers& timers,
                                       const HostFacts& host, double share) {
  auto pass = std::make_shared<Interaction>(comm, primary, secondary, options, timers, share);
  const std::string path = "contact." + options.name;
  pass->set_schedules(curve(host, path + ".penalty_curve", options.penalty_curve),
                      curve(host, path + ".friction_curve", options.friction_curve),
                      curve(host, path + ".interference_curve", options.interference_curve));
  pass->set_end(host.end);
  if (host.prescribed)
    pass->set_prescribed(host.prescribed(pass->primary()));
  return pass;
}

} // namespace

Passes make_passes(const Comm& comm, mesh::Surface primary, mesh::Surface secondary,
                   const ContactOptions& options, PhaseTimers& timers, const HostFacts& host) {
  const SideComparison sides = compare_sides(comm, primary, secondary);
  const Settings settings = resolve(options, sides);
  ContactOptions chosen = options;
  chosen.primary_side = PrimarySide::as_given;
  if (settings.primary != options.primary) {
    std::swap(primary, secondary);
    std::swap(chosen.primary, chosen.secondary);
  }
  Passes result;
  if (options.primary_side == PrimarySide::as_given && sides.is_poor() && !options.two_pass)
    result.warnings.push_back(warn_of_side(settings, sides));
  const std::string facets = warn_of_facets(comm, primary, secondary, chosen);
  if (!facets.empty())
    result.warnings.push_back(facets);
  const double share = options.two_pass ? 0.5 : 1.0;
  result.interfaces.push_back(make_pass(comm, primary, secondary, chosen, timers, host, share));
  if (!options.two_pass)
    return result;
  std::swap(chosen.primary, chosen.secondary);
  chosen.name += "_second_pass";
  result.interfaces.push_back(make_pass(comm, secondary, primary, chosen, timers, host, share));
  return result;
}

} // namespace abut::contact
