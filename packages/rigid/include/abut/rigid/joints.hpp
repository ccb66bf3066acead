// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/rigid/bodies.hpp"
#include "abut/rigid/joint.hpp"
#include "abut/rigid/joint_equations.hpp"

#include <string>
#include <utility>
#include <vector>

namespace abut::rigid {

/// The joints of an EquationSystem. A joint that holds or loads components has two block rows: six
/// multipliers as unknowns, and as equations the components that it holds. What the others hold
/// already in the reference configuration is left out; the multiplier of a free component is
/// prescribed by its load. Multipliers are lengths and equations forces by a stiffness.
class Joints {
public:
  /// The bodies must outlive this object. Throws InputError for an axis without direction.
  Joints(const unknowns::DofMap& dofs, const Bodies& bodies, std::vector<Joint> joints);

  bool empty() const { return joints_.empty(); }
  bool have_unknowns() const;
  /// Multipliers that are no unknowns. They read the stiffness: not before it is set.
  std::vector<unknowns::RowConstraint> constraints() const;
  /// The stiffness that scales multipliers and equations [force/length].
  void set_stiffness(double stiffness) { stiffness_ = stiffness; }
  /// Largest load of the trial state over its joint's size [force/length].
  double load_stiffness() const;

  /// (joints,6) multipliers of all ranks, in the unit of the unknowns. Collective.
  std::vector<double> multipliers(const Vector& x) const;
  bool stands_at(const std::vector<double>& multipliers) const {
    return multipliers == multipliers_;
  }
  /// Sets the trial state, for the placements that the bodies have. Throws SolveError where a joint
  /// turned too far for one step.
  void move(std::vector<double> multipliers, double t);
  /// The trial state becomes history.
  void accept();
  /// Angles and rotations at the last accepted state, and the scale of the multipliers.
  void exchange_state(StateArchive& archive);
  /// Writes the reference origins into the owned rows of x (rows,3).
  void put_origins(double* x) const;

  /// Adds the forces on owned bodies. As all that follows, throws SolveError on all ranks where a
  /// spring has no length.
  void add_forces(double* residual) const;
  /// Adds the equations that owned joints hold.
  void add_equations(double* residual) const;
  void add_tangent(const unknowns::BlockPattern& pattern, double* values) const;
  /// (bodies,6) sums of force and moment about the center, internal ones.
  std::vector<double> body_forces() const;

  /// Whether all that is held stands where it should, to 1e-9 of the joint's size.
  bool closed() const;
  /// Squared sum of what rounding of positions makes of the equations, over rounding. [force^2]
  double rounding_force2() const;
  /// What other joints and prescribed components hold already: (joint, component) as words.
  std::vector<std::pair<std::string, std::string>> implied() const;
  /// Throws SolveError where a component that was left out has moved after all.
  void require_consistent() const;

  std::vector<JointState> states() const;
  /// Work on all joints between the last accepted state and the trial state, by the trapezoidal
  /// rule: of loads, of prescribed motion [energy].
  std::array<double, 2> work(const std::vector<JointState>& last,
                             const std::vector<JointState>& now) const;

private:
  struct Sides {
    JointSide a, b;
  };
  enum class Role : char { free, loaded, held, implied };

  JointSide side(std::size_t joint, int which) const;
  void find_implied();
  std::vector<double> reference_row(std::size_t joint, std::size_t component) const;
  Role& role(std::size_t joint, std::size_t i) { return role_[6 * joint + i]; }
  Role role(std::size_t joint, std::size_t i) const { return role_[6 * joint + i]; }
  bool acts(std::size_t joint, std::size_t i) const {
    return role(joint, i) == Role::loaded || role(joint, i) == Role::held;
  }
  /// What a multiplier's unknown and its equation are multiplied with.
  double scale(std::size_t joint, std::size_t i) const {
    return stiffness_ * (i < 3 ? 1.0 : length_[joint]);
  }
  double factor(std::size_t joint, std::size_t i) const {
    return acts(joint, i) ? scale(joint, i) * multipliers_[6 * joint + i] : 0.0;
  }
  bool owns(std::size_t joint) const;
  std::size_t first_owned_row(std::size_t joint) const; ///< scalar row of an owned joint
  PairVector pair_force(std::size_t joint) const;
  PairMatrix pair_tangent(std::size_t joint) const;
  void add_pair(std::size_t joint, const unknowns::BlockPattern& pattern, double* values) const;
  void add_slopes(std::size_t joint, const unknowns::BlockPattern& pattern, double* values) const;
  double wanted(std::size_t joint, std::size_t i) const;
  Mat3 rotation_of(std::size_t joint, int which) const;
  Mat3 turned(std::size_t joint) const;

  const unknowns::DofMap& dofs_;
  const Bodies& bodies_;
  std::vector<Joint> joints_;
  std::vector<std::array<Vec3, 3>> frame_; ///< reference configuration
  std::vector<double> length_;             ///< of each joint: that of its larger body [length]
  std::vector<Role> role_;                 ///< (joints,6)
  double stiffness_ = 0.0;
  std::vector<double> accepted_angle_;                 ///< about the axis, whole turns counted
  std::vector<Mat3> accepted_turn_;                    ///< prescribed rotations
  std::vector<std::array<Mat3, 2>> accepted_rotation_; ///< of both bodies
  // trial state
  double time_ = 0.0;
  std::vector<double> multipliers_; ///< (joints,6)
  std::vector<Sides> sides_;
  std::vector<double> angle_;     ///< about the axis, whole turns counted
  std::vector<double> deviation_; ///< (joints,6) of held and implied components, else 0
};

} // namespace abut::rigid
