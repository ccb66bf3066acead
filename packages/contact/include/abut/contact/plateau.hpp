// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace abut::contact {

/// Why augmentations do not bring what they should.
enum class PlateauCause {
  none,           ///< they do
  held_nodes,     ///< where it is largest the primary cannot move along the normal
  partly_covered, ///< where it is largest faces are covered in part
  changing_set,   ///< points or nodes open and close in turns
  stiff_primary,  ///< the multipliers change by more than half of their last change: the primary is
                  ///< stiff and fine, what presses on its nodes hardly moves gaps
  unknown,
};

/// What an augmentation leaves.
struct Judged {
  double gap = 0.0, change = 0.0; ///< as in Augmentation
  bool settled = false;           ///< the change is within its tolerance
  bool closed = false;            ///< the gap is, or is not asked for
};

/// What holds augmentations up and what to do, in plain words; empty for none.
const char* describe(PlateauCause cause);

} // namespace abut::contact
