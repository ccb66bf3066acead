// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "interface_data.hpp"

/// What points remember from step to step. Positions are those of the last evaluation.
namespace abut::contact {

/// The interface comes into being in the last converged configuration: points that touch or overlap
/// are in contact already, so that their friction has an anchor from the first step on. Collective.
void begin_history(InterfaceData& data);

/// The trial state of the step becomes history. What each friction map carries on: the anchored
/// maps their anchor, moved where the point slipped; the incremental one its tangential traction.
void end_step(InterfaceData& data);

/// After end_step and what augmentation at its end has changed: history becomes the converged one.
void keep_history(InterfaceData& data);

/// The trial state is dropped, and with it where the failure led.
void drop_step(InterfaceData& data);

/// The next beginning is a first one, but what friction has cost is not forgotten.
void forget_history(InterfaceData& data);

/// Sticky points that pull harder than they can come off; true when there are any. Collective.
bool tear(InterfaceData& data);

/// Newton goes on from this iterate. new_step: it is the first of a step.
void take_iterate(InterfaceData& data, bool new_step);

/// Multipliers have changed: every status stays until the next iterate is taken, and the search
/// starts a solve of its own.
void freeze(InterfaceData& data);

/// The next search is of another solve, which may swing for its own reasons.
void restart_search(InterfaceData& data);

} // namespace abut::contact
