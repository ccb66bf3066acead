// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/anderson.hpp"
#include "abut/contact/corner_space.hpp"
#include "abut/contact/facing_surface.hpp"
#include "abut/contact/normal_law.hpp"
#include "abut/contact/options.hpp"
#include "abut/contact/plateau.hpp"
#include "abut/contact/point_state.hpp"
#include "abut/contact/side_choice.hpp"
#include "abut/core/contribution.hpp"
#include "abut/core/log.hpp"
#include "abut/fem/quadrature.hpp"

#include <array>
#include <functional>
#include <map>
#include <memory>

namespace abut::contact {

class DualLaw;
class NodeCells;
struct DualPoint;
struct NodeRow;

/// What one contact interface carries, over all ranks.
struct ContactSummary {
  Global active_points = 0, stick_points = 0, slip_points = 0;
  Global flips = 0;                ///< changes of status in the last step, over all points
  std::array<double, 3> force{};   ///< on the primary surface [force]
  double max_pressure = 0.0;       ///< of the nodal pressure; Cauchy [pressure]
  double max_point_pressure = 0.0; ///< of the points' pressure; Cauchy [pressure]
  double max_penetration = 0.0;    ///< [length]
  double max_penetration_over_face_size = 0.0;
  double min_gap = 0.0, max_gap = 0.0; ///< over points with a partner [length]
  Global points = 0, paired_points = 0;
  double area = 0.0;            ///< reference area of active points [length^2]
  double tangential = 0.0;      ///< integral of the size of the tangential traction [force]
  double max_slip = 0.0;        ///< longest way slipped since the start [length]
  double penalty_energy = 0.0;  ///< in the springs of penalty [energy]
  double dissipation = 0.0;     ///< by friction, since the start [energy]
  double initial_overlap = 0.0; ///< deepest overlap of the meshes at the start [length]
};

/// What the next augmentation would do.
struct Augmentation {
  double change = 0.0; ///< relative change of the multipliers, L2 [1]
  /// Largest violation over face size: penetration and motion in stick, at points, or averaged at
  /// those corners whose faces are closed when the multipliers live there; with increments of
  /// averages and with accelerated multipliers also a gap across which they press [1].
  double gap = 0.0;
  double length = 0.0;    ///< the same [length]
  bool converged = false; ///< the tolerances hold
  bool stalled = false;   ///< what is beyond its tolerance has not fallen for several augmentations
  /// Why it has hardly fallen, when it has stalled or with springs as stiff as f = 10.
  PlateauCause cause = PlateauCause::none;
};

/// New multipliers of a point after a solve: changes `pressure` and `shear` (tangent, on the
/// primary) from those that the interface's own update gives, with which they come in, to the
/// multipliers of the next solve.
using MultiplierUpdate =
    std::function<void(const PointState& point, double& pressure, Vec3& shear)>;

/// A point that is in contact or touches, once for each direction in which it holds.
struct ClosedPoint {
  Local primary_node;    ///< a surface node of its primary face
  Global secondary_node; ///< a mesh node of its secondary face
  Vec3 x, normal;        ///< position [length], direction that is held
};

/// Weighted sums at the nodes of the primary faces of a rank; divide by weight after summing over
/// ranks. One entry for each surface node of the primary surface.
struct NodalSums {
  std::vector<double> weight, pressure, gap, slip;
  std::vector<double> status;   ///< 0 open, 1 slip, 2 stick (sum of weights)
  std::vector<double> traction; ///< (nodes, 3)
};

/// One point as an output file wants it. With Multipliers::dual the tractions are those of the
/// nodes, interpolated: what acts at the point belongs to averages and oscillates.
struct PointRecord {
  Global face; ///< id of the primary face
  int point;   ///< on the face
  Vec3 x;      ///< present position [length]
  Status status;
  double gap, slip;       ///< [length]
  double pressure, shear; ///< Cauchy [pressure]
  Vec3 traction;          ///< Cauchy [pressure]
  int flips;
};

/// Contact of two surfaces in one of three formulations, with Coulomb friction, by penalty or
/// augmented Lagrangian. Points are integration points of the primary faces, (I,P) with I faces and
/// P points each. Usable on its own: it takes surfaces, options and a communicator, and gives
/// residual and tangent blocks over global node numbers. Kokkos must be initialised while it lives.
class Interaction : public Contribution {
public:
  /// share: part of the traction that this pass carries, 1/2 when both sides carry points.
  /// Throws InputError when neither surface is deformable and no penalty is given, or a surface is
  /// empty. Collective.
  Interaction(const Comm& comm, mesh::Surface primary, mesh::Surface secondary,
              ContactOptions options, PhaseTimers& timers, double share = 1.0);
  ~Interaction() override;
  Interaction(const Interaction&) = delete;
  Interaction& operator=(const Interaction&) = delete;

  /// Factors over the load parameter t on penalty and friction coefficient.
  void set_schedules(std::function<double(double)> penalty, std::function<double(double)> friction);
  /// Another law of the normal traction; empty: penalty and multiplier. Throws InputError with dual
  /// multipliers.
  void set_normal_law(NormalLaw law);
  /// Another update of the multipliers; empty: that of options().multipliers.
  void set_update(MultiplierUpdate update) { update_ = std::move(update); }
  /// Whether early tangents of a solve are those of the residual exactly, instead of moderated ones
  /// for deep points. For checks.
  void set_exact_tangent(bool exact) { exact_tangent_ = exact; }
  /// Which displacements of the primary's nodes are prescribed, (surface nodes), bits 1, 2, 4 for
  /// x, y, z: a node of the dual law that cannot move along the normal has no multiplier of its
  /// own, and a plateau of augmentations may have its cause there. Collective.
  void set_prescribed(const std::vector<char>& directions);
  /// The load parameter at which an initial overlap is resolved.
  void set_end(double t) { end_ = t; }
  /// Whether the last prepared load parameter lies in options().window.
  bool acts() const { return acts_; }

  const char* name() const override { return options_.name.c_str(); }
  Phase phase() const override { return Phase::contact; }
  void prepare(const NodalFields& fields) override;
  const Connectivity& connectivity() const override { return pairs_; }
  long connectivity_version() const override { return version_; }
  const Connectivity& candidates() const override;
  void residual(const NodalFields& fields, const ResidualScatter& scatter) override;
  void tangent(const NodalFields& fields, const TangentScatter& scatter) override;
  bool symmetric() const override;
  double round_off_force2() const override;
  bool settled() const override;
  void accept() override;
  void reject() override;

  /// What the next multipliers would be in the last prepared configuration. Collective.
  Augmentation augmentation();
  /// They become the multipliers, of stick and slip alike. Collective. Prepare again before the
  /// next residual, which then holds every point's status once.
  void augment();

  /// Sticky points that pull harder than they can come off; true when there are any, and the solve
  /// must be done again. Collective.
  bool tear();

  ContactSummary summary() const; ///< Collective.
  NodalSums nodal_sums() const;
  std::vector<PointRecord> records() const;       ///< of this rank
  std::vector<ClosedPoint> closed_points() const; ///< of this rank
  const mesh::Surface& primary() const { return primary_; }
  const ContactOptions& options() const { return options_; }
  const std::vector<PointState>& points() const { return points_; } ///< (I,P)
  /// f of the automatic penalty; 0 when `penalty` is given.
  double penalty_factor() const { return options_.penalty > 0.0 ? 0.0 : factor_; }
  double softest_modulus() const { return softest_modulus_; }

  /// Whether opposed normals were found for the points that have a partner within one face size
  /// when facing is ignored: share of such points whose normals point the same way. Collective.
  double wrong_facing_share() const;

private:
  struct Pair {
    Local face, facing, anchor; ///< anchor: -1 unless its nodes take part beside those of facing
    std::vector<Local> points;
  };
  struct Table { ///< integration points of a face type
    fem::Rule<2> rule;
    std::vector<double> N;  ///< (P, nodes)
    std::vector<double> dN; ///< (P, nodes, 2)
  };
  struct Query;   ///< what a search looks for
  struct Partner; ///< what it found

  void move_origin();
  void make_points();
  PointShape shape(Local face, int point) const;
  void current_coordinates(const NodalFields& fields);
  void collect_if_moved();
  void begin();
  void rest();
  void forget();
  void start();
  void start_point(Local face, int point);

  Query query(Local face, int point, const PrimaryPoint<double>& at) const;
  Partner find(const Query& query) const;
  void visit(const Query& query, Local candidate, double& limit, Partner& inner,
             Partner& beside) const;
  Partner nearest(Local face, int point, const PrimaryPoint<double>& at);
  bool on_rim(Local face, int edge) const;
  bool past_rim(Local last, const double* last_xi, const Vec3& x) const;
  Partner lasting_partner(Local face, int point, const PrimaryPoint<double>& at);
  bool own_neighbour(Local face, Local candidate) const;
  bool crossed(const Query& query, Local candidate, const double xi[2], double gap) const;

  void evaluate_points();
  void evaluate(Local face, int point);
  bool evaluate_anchored(Local face, int point, const PrimaryPoint<double>& at);
  bool evaluate_inclined(Local face, int point, const PrimaryPoint<double>& at, const Vec3& trial);
  void evaluate_partner(Local face, int point, const PrimaryPoint<double>& at);
  bool normal_response(Local face, PointState& state) const;
  PointRule sliding_rule(Local face, PointState& state, const ContactPoint& c,
                         const PrimaryPoint<double>& at, const Vec3* y) const;
  ShearChoice switched(Local face, Local facing, const PointState& state, const Vec3& trial,
                       const Vec3& normal, double pressure) const;
  void set_traction(Local face, int point, PointRule rule);
  void keep_iterate();
  /// The point as the kernels take it; y_previous must live as long as the result.
  ContactPoint contact_point(Local face, int point, const Vec3* y_previous) const;
  double effective_gap(const PointState& state) const {
    return state.gap - state.offset - state.history.rest.component[2];
  }
  Vec3 tied_rest(const PointState& state, const PrimaryPoint<double>& at) const;
  double present_offset(const PointState& state) const;

  // Multipliers::dual
  using AddRow = std::function<void(Local node, Global column, const NodeRow& row)>;
  void make_dual();
  void set_held();
  DualPoint read_point(Local face, int point);
  void evaluate_nodes();
  void take_traction(Local face, int point);
  Vec3 given_shear(Local face, int point) const;
  ContactPoint given_point(Local face, int point, const Vec3* y_previous) const;
  void node_rows(const std::function<bool(Local)>& wanted, const AddRow& add) const;
  void add_node_cells(Connectivity& cells);
  void add_node_candidates(Connectivity& cells, const std::vector<Local>& cell_face) const;
  void scatter_node_cells(const TangentScatter& scatter);
  void store_node_shear();
  void augment_nodes();
  void accept_nodes();
  double node_pressure(Local face, int face_node) const;
  Vec3 node_shear(Local face, int face_node) const;
  double field_pressure(Local face, int point) const;
  Vec3 field_shear(Local face, int point) const;
  double node_spring(Local face, int point) const;

  struct Multiplier {
    double pressure = 0.0;
    Vec3 shear = Vec3::zero();
  };
  struct Tolerances { ///< of an augmentation, infinite where not asked
    double change, gap, length;
  };
  Tolerances tolerances() const;
  void choose_factor();
  void propose(Augmentation& result);
  void propose_averages(Augmentation& result);
  Multiplier base(const PointState& state, const PrimaryPoint<double>& at) const;
  void measure_points(Augmentation& result);
  void merge_slivers();
  void take_multiplier(Local face, int point, bool shear);
  double stiffness_factor() const;
  bool accelerates() const;
  Global active_set() const;
  std::vector<double> next_pressures();
  double relative_change() const;
  /// visit(face, point, state, corner functions), for all points with a partner.
  void each_covered_point(
      const std::function<void(Local, int, const PointState&, const double*)>& visit) const;

  void build_pairs();
  double inverse_depth(Local face, Local facing) const;
  double penalty_of(Local face, Local facing) const;
  Local point_index(Local face, int p) const { return first_point_[face] + p; }
  int face_points(Local face) const { return first_point_[face + 1] - first_point_[face]; }
  const Vec3* primary_nodes(Local face) const { return &x_primary_[first_node_[face]]; }
  const Vec3* primary_nodes_previous(Local face) const {
    return &x_primary_previous_[first_node_[face]];
  }
  /// Area per point, of the measure of the tractions and in the present configuration [length^2].
  double measure(Local face, int point) const;
  double current_area(Local face, int point) const;
  void advance_history(Local face, int point);
  Vec3 plastic_slip(Local face, int point, const PrimaryPoint<double>& at) const;

  Comm comm_;
  mesh::Surface primary_, secondary_; ///< coordinates relative to origin_
  Vec3 origin_ = Vec3::zero();
  SideComparison sides_;
  ContactOptions options_;
  PhaseTimers& timers_;
  double share_;
  bool self_; ///< primary and secondary are one surface
  std::function<double(double)> penalty_schedule_, friction_schedule_;
  NormalLaw normal_law_;
  MultiplierUpdate update_;
  double end_ = 1.0, time_ = 0.0, penalty_scale_ = 1.0, friction_ = 0.0;
  FacingSurface facing_;
  CornerSpace corners_;
  double factor_;              ///< f of the automatic penalty
  bool factor_chosen_ = false; ///< by the pressure of the first step in contact
  double softest_modulus_ = 0.0;
  double slack_ = 0.0;         ///< motion after which faces are collected anew [length]
  std::vector<double> size_;   ///< (primary faces) [length]
  double smallest_size_ = 0.0; ///< of all primary faces [length]
  std::map<fem::FaceType, Table> tables_;
  std::vector<const Table*> table_; ///< (primary faces)
  std::vector<Local> first_point_{0};
  std::vector<std::size_t> first_node_; ///< (primary faces) into x_primary_
  std::vector<PointState> points_;
  std::vector<double> weight_;  ///< (I,P) of the quadrature [1]
  std::vector<double> area_;    ///< (I,P) weight times reference area [length^2]
  std::vector<double> stretch_; ///< (primary faces) current over reference area at the last step
  std::vector<Vec3> x_primary_, x_primary_previous_;       ///< (face nodes, in order of the faces)
  std::vector<double> x_secondary_, x_secondary_previous_; ///< (nodes, 3)
  bool placed_ = false;                                    ///< there is a configuration
  bool acts_ = true;
  bool started_ = false; ///< the points have their history
  bool exact_tangent_ = false;
  bool established_ = false; ///< some point was in contact at the last converged step
  bool predicting_ = false;  ///< that step has contact, and the next one is being predicted
  bool frozen_ = false;      ///< points keep their status in the next search
  bool new_step_ = true;     ///< the next search is the first of a step
  int searches_ = 0;         ///< since the last change of history
  bool collected_ = false;   ///< on all ranks together
  double motion_ = 0.0; ///< bound of the relative motion since the last step, 0: within the reach
  double collected_motion_ = 0.0; ///< of the last collection
  std::vector<Vec3> x_primary_collected_;
  std::vector<double> x_secondary_collected_;
  std::unique_ptr<DualLaw> dual_;         ///< with Multipliers::dual
  std::unique_ptr<NodeCells> node_cells_; ///< then too
  std::vector<Pair> pair_list_;
  Connectivity pairs_;
  mutable Connectivity candidates_;
  long version_ = 0;
  std::vector<Multiplier> next_; ///< (I,P) proposed
  bool proposed_ = false;        ///< for the present configuration
  bool increments_ = false;      ///< smoothed multipliers grow by averages of what springs carry
  std::vector<double> full_;     ///< (surface nodes) integrals of the corner functions [length^2]
  std::vector<char> merged_;     ///< (surface nodes) corners with little cover, of smoothed ones
  std::vector<char> held_;       ///< (surface nodes) prescribed along the normal; may be empty
  Judged judged_;                ///< of the last proposal
  PlateauWatch watch_;
  Anderson anderson_;
  std::vector<char> last_active_; ///< at the last augmentation, by points or nodes
};

} // namespace abut::contact
