// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/augmentation.hpp"
#include "abut/core/comm.hpp"

#include <vector>

namespace abut::contact {

/// What an augmentation leaves.
struct Judged {
  double gap = 0.0, change = 0.0; ///< as in Augmentation
  bool settled = false;           ///< the change is within its tolerance
  bool closed = false;            ///< the gap is, or is not asked for
};

/// Where the law is violated: a point or a node of this rank.
struct Violation {
  double size = 0.0; ///< over the face size [1]
  double area = 0.0; ///< that it stands for [length^2]
  bool held = false, partly_covered = false;
};

/// Follows the augmentations of a step: whether they bring anything, and why not.
class PlateauWatch {
public:
  explicit PlateauWatch(const Comm& comm) : comm_(comm) {}

  void clear();
  /// An augmentation follows on this state. active_set: any number that tells sets apart.
  void add(const Judged& now, Global active_set);
  /// What is beyond its tolerance has not fallen for several augmentations.
  bool stalled(const Judged& now) const;
  /// A set of active points has come back after another one, more than once.
  bool cycles() const { return returns_ >= patience; }
  /// Where the law is violated now.
  void look_anew() { violations_.clear(); }
  void violated(const Violation& v) { violations_.push_back(v); }
  /// Why the measure that is beyond its tolerance has fallen by less than a half in the last two
  /// augmentations; none if it has fallen, or to where Newton's own tolerance hides it. by_change:
  /// the gap is not to fall yet; dual: nodes hold the law; poor_side: the primary is stiff and
  /// fine. Collective.
  PlateauCause cause(const Judged& now, bool by_change, bool dual, bool poor_side) const;

private:
  static constexpr int patience = 2;

  Comm comm_;
  std::vector<double> gaps_, changes_; ///< before each augmentation of the step
  std::vector<Global> sets_;
  std::vector<Violation> violations_;
  int returns_ = 0;
};

} // namespace abut::contact
