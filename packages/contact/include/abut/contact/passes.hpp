// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/interaction.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace abut::contact {

/// What an interface takes from its host beside surfaces and options; all of it may be left out.
struct HostFacts {
  /// The function of t behind a curve's name in the options.
  std::function<std::function<double(double)>(const std::string& name)> curve;
  /// Load parameter at which an initial overlap is resolved.
  double end = 1.0;
  /// Bits 1, 2, 4 for each surface node whose displacement along x, y, z is prescribed.
  std::function<std::vector<char>(const mesh::Surface& surface)> prescribed;
};

/// The interfaces that one entry of options asks for.
struct Passes {
  std::vector<std::shared_ptr<Interaction>> interfaces; ///< one, or two with half a share each
  std::vector<std::string> warnings;                    ///< what a user should hear before the run
};

/// Makes what the options say of two surfaces, `primary` and `secondary` as the options name them:
/// swaps the sides where the choice is automatic, adds the second pass (named NAME_second_pass),
/// and gives curves and prescribed directions to each. `timers` must outlive the interfaces.
/// Throws InputError for what does not go together. Collective.
Passes make_passes(const Comm& comm, mesh::Surface primary, mesh::Surface secondary,
                   const ContactOptions& options, PhaseTimers& timers, const HostFacts& host = {});

} // namespace abut::contact
