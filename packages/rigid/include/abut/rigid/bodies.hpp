// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/scatter.hpp"
#include "abut/core/state_archive.hpp"
#include "abut/rigid/inertia.hpp"
#include "abut/unknowns/block_pattern.hpp"
#include "abut/unknowns/row_constraint.hpp"

#include <vector>

namespace abut::rigid {

/// Where one body is for given unknowns and t; the same on all ranks.
struct Placement {
  Vec3 displacement = Vec3::zero();
  Mat3 rotation = Mat3::identity();  ///< of the reference configuration
  Vec3 step_rotation = Vec3::zero(); ///< rotation vector since the last accepted state
  std::array<double, 6> unknowns{};  ///< rows of translation and rotation [length]
};

/// The rigid bodies of an EquationSystem: motion, maps of the reduction, loads. The unknowns of a
/// rotation are the sum of the steps' rotation vectors times the body's length, so that all rows
/// are forces and all unknowns lengths.
class Bodies {
public:
  /// Collective. One body for each that the map knows.
  Bodies(const unknowns::DofMap& dofs, std::vector<Body> bodies);

  bool empty() const { return bodies_.empty(); }
  std::size_t size() const { return bodies_.size(); }
  const Body& body(std::size_t body) const { return bodies_[body]; }
  double length(std::size_t body) const { return length_[body]; } ///< largest arm, or 1 [length]
  bool owns(std::size_t body) const;                   ///< whether its rows are this rank's
  std::size_t first_owned_row(std::size_t body) const; ///< scalar row of an owned body
  /// The trial state.
  const Placement& placement(std::size_t body) const { return placements_[body]; }
  /// Spatial rotation by unknowns of rotation, in the trial state [rad/length].
  Mat3 turn(std::size_t body) const;
  bool have_unknowns() const { return have_unknowns_; }
  bool symmetric() const; ///< whether no rotation is an unknown
  std::vector<unknowns::RowConstraint> constraints() const;

  /// Collective.
  std::vector<Placement> place(const Vector& x, double t) const;
  /// Writes u (N,3) of the local nodes that move with bodies.
  void displace(const std::vector<Placement>& placements, double* u) const;

  /// Sets the trial state; throws SolveError where a body turned too far for one step.
  void move(std::vector<Placement> placements);
  /// Whether the trial state is exactly this one.
  bool stands_at(const std::vector<Placement>& placements) const;
  /// Writes the reference centers into the owned rows of x (rows,3).
  void put_centers(double* x) const;
  /// The trial state becomes history.
  void accept();

  /// Rotations and motion at the last accepted state.
  void exchange_state(StateArchive& archive);

  /// Brings arms and rows up to date with the trial state and a pattern.
  void follow(const unknowns::BlockPattern& pattern);
  RigidScatter scatter(const unknowns::CellPositions& positions);

  void clear_forces() { force_.assign(24 * bodies_.size(), 0.0); }
  /// (bodies,12) sums of the rates of momentum of what moves with the bodies, see RigidScatter.
  double* inertial_forces() { return force_.data() + 12 * bodies_.size(); }
  /// Adds minus the bodies' loads at t to their owned rows.
  void add_loads(double t, double* residual) const;
  /// Largest load over its body's size [force/length].
  double load_stiffness() const;
  /// Sums the forces on the nodes over the ranks. Collective.
  void sum_forces();
  /// Adds to the owned rows how moments change with arms, and follower loads with the rotation; for
  /// the forces of the last sum, inertial ones times their weight.
  void add_stiffness(double t, double inertia_weight, const unknowns::BlockPattern& pattern,
                     double* values) const;

  // --- dynamics ---

  /// The bodies have mass from now on and start to move as they say, from where they stand.
  void start(const TimeIntegration& rule);
  /// Adds accelerations x (translation and rotation rows) at the start. Collective.
  void accelerate(const Vector& x);
  /// Trial state of the last move() after a step dt >= 0.
  void move_masses(double dt);
  void add_inertia(double* residual) const;
  /// Adds weight times the derivative of add_inertia.
  void add_inertia_tangent(double weight, const unknowns::BlockPattern& pattern,
                           double* values) const;
  /// Writes the linear part of the nodes' rates (N,3) for rates x of the unknowns. Collective.
  void put_rates(const Vector& x, double* rates) const;
  /// (bodies) empty without dynamics; the same on all ranks.
  std::vector<BodyMotion> motions() const;

  /// After sum_forces at t. others: (bodies,6) further internal forces and moments about centers.
  std::vector<BodyState> states(double t, const std::vector<double>& others) const;

private:
  std::vector<double> all_unknowns(const Vector& x) const;
  void add_block(const unknowns::BlockPattern& pattern, std::size_t body, int row, int column,
                 double scale, const Mat3& k, double* values) const;
  Vec3 load(std::size_t body, bool moment, double t) const;
  bool is_held(std::size_t body, std::size_t component, double t) const;

  const unknowns::DofMap& dofs_;
  std::vector<Body> bodies_;
  std::vector<double> length_; ///< of each body: its largest arm, or 1 [length]
  bool have_unknowns_ = false;
  std::vector<Mat3> accepted_rotation_;
  std::vector<Vec3> accepted_vector_;   ///< rotation vector of the above, whole turns counted
  std::vector<Vec3> accepted_unknowns_; ///< of rotation [length]
  std::vector<Placement> placements_;
  std::vector<Inertia> inertia_;                   ///< empty without dynamics
  std::vector<double> arm_, lever_, turn_, force_; ///< RigidScatter's
  const unknowns::BlockPattern* pattern_ = nullptr;
};

} // namespace abut::rigid
