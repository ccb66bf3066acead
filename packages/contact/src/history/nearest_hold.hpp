// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "interface_data.hpp"

namespace abut::contact {

/// Bodies that nothing but contact holds, and that stand off it: while a state is sought that
/// Newton can start from, springs without force at the nearest points tell which way they go. They
/// are as soft as the bodies at first; what an iterate has moved by tells how soft they must be for
/// the next one to close the gap.
class NearestHold {
public:
  void ask_for() { asked_for_ = true; }
  bool is_asked_for() const { return asked_for_; }
  /// Whether no point had closed when they were last looked at.
  bool is_apart() const { return apart_; }

  /// Looks at the readings of the points. seeking: the nearest ones hold in this evaluation.
  /// Collective.
  void look(InterfaceData& data, bool seeking);
  /// Newton goes on from the state that was last looked at.
  void take_iterate(LawTerms& law, bool is_first);
  void rest() { apart_ = false; }

private:
  bool asked_for_ = false, apart_ = false;
  double gap_ = 0.0, last_gap_ = 0.0; ///< the least, and at the last iterate [length]
  double size_ = 0.0;                 ///< of the face there [length]
};

} // namespace abut::contact
