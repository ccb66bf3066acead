// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/augmentation.hpp"
#include "abut/contact/normal_law.hpp"
#include "abut/contact/resolve.hpp"
#include "abut/contact/summary.hpp"
#include "abut/core/contribution.hpp"
#include "abut/core/state_archive.hpp"
#include "abut/mesh/surface.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace abut::contact {

class PointLists;

/// Contact of two surfaces in one of three formulations, with Coulomb friction, by penalty or
/// augmented Lagrangian. Points are integration points of the primary faces, (I,P) with I faces and
/// P points each. Usable on its own: it takes surfaces, options and a communicator, and gives
/// residual and tangent blocks over global node numbers. Kokkos must be initialised while it lives.
///
/// Residual and tangent are functions of the unknowns, the converged history and the iterate state;
/// the events of Contribution and augment() change the latter two and nothing else does. The first
/// evaluation places the interface: its configuration is where the run starts.
class Interaction : public Contribution {
public:
  /// primary, secondary: the sides as resolve() names them; passes.hpp chooses them. share: part of
  /// the traction that this pass carries, 1/2 when both sides carry points.
  /// Throws InputError for options that do not go together and for a surface without faces.
  /// Collective.
  Interaction(const Comm& comm, mesh::Surface primary, mesh::Surface secondary,
              ContactOptions options, PhaseTimers& timers, double share = 1.0);
  ~Interaction() override;

  /// Factors over the load parameter t on penalty, friction coefficient and interference.
  void set_schedules(std::function<double(double)> penalty, std::function<double(double)> friction,
                     std::function<double(double)> interference = {});
  /// Another law of the normal traction; empty: penalty and multiplier. Throws InputError where the
  /// law holds at nodes.
  void set_normal_law(NormalLaw law);
  /// Another update of the multipliers; empty: that of the settings.
  void set_update(MultiplierUpdate update);
  /// Whether early tangents of a solve are those of the residual exactly, instead of moderated ones
  /// for deep points. For checks.
  void set_exact_tangent(bool exact);
  /// Which displacements of the primary's nodes are prescribed, (surface nodes), bits 1, 2, 4 for
  /// x, y, z: a node of the law that cannot move along the normal has no multiplier of its own, and
  /// a plateau of augmentations may have its cause there. Collective.
  void set_prescribed(const std::vector<char>& directions);
  /// The load parameter at which an initial overlap is resolved and an interference whole.
  void set_end(double t);
  /// From now on, while no point has been in contact, the nearest ones hold their bodies in
  /// predictions and approaches as if they touched, without a force. For bodies that nothing but
  /// this contact holds: a step then leads into contact, where its equations would be singular.
  void hold_by_nearest();
  /// Whether the last evaluated load parameter lies in the window of the options.
  bool acts() const;

  const char* name() const override;
  Role role() const override { return Role::contact; }
  Phase phase() const override { return Phase::contact; }
  void prepare(const NodalFields& fields) override;
  const Connectivity& connectivity() const override;
  long connectivity_version() const override;
  const Connectivity& candidates() const override;
  void residual(const NodalFields& fields, const ResidualScatter& scatter) override;
  void tangent(const NodalFields& fields, const TangentScatter& scatter) override;
  bool symmetric() const override;
  double round_off_force2() const override;
  bool settled() const override;
  bool overloaded() const override;
  bool lands() const override;
  void begin_step() override;
  void begin_solve(SolveKind kind) override;
  void iterate_taken() override;
  long state_version() const override;
  void accept() override;
  void reject() override;

  /// What the next multipliers would be in the last evaluated configuration. energy: asked for
  /// where gaps are small beside faces, to tell whether they are beside what the bodies give;
  /// empty: they are. Collective.
  Augmentation augmentation(const EnergyOfBodies& energy = {});
  /// They become the multipliers, of stick and slip alike; each site keeps its status until the
  /// next iterate is taken. Collective.
  void augment();

  /// Sticky points that pull harder than they can come off; true when there are any, and the solve
  /// must be done again. Collective.
  bool tear();

  ContactSummary summary() const; ///< Collective.
  /// Tractions and gaps at the nodes of one side, as the law has them. On the secondary the force
  /// of each point goes to the corners of the face that it meets, by their linear functions: summed
  /// over the corner nodes it is minus the force on the primary. Collective.
  NodalSums nodal_sums(Side side = Side::primary) const;
  PointLists points() const;
  const mesh::Surface& primary() const;
  const Settings& settings() const;

  /// Whether opposed normals were found for the points that have a partner within one face size
  /// when facing is ignored: share of such points whose normals point the same way. Collective.
  double wrong_facing_share() const;

private:
  friend void exchange_state(StateArchive&, Interaction&, const NodalFields&);

  friend class PointLists;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// What an interface remembers between two steps. accepted: displacements at the end of the last
/// one, for taking; the interface must have been prepared where the run starts. Taking is
/// collective.
void exchange_state(StateArchive& archive, Interaction& interface, const NodalFields& accepted);

/// What the points of this rank have, as of the last evaluation. Not longer than its interaction.
class PointLists {
public:
  explicit PointLists(const Interaction& interaction) : parts_(*interaction.parts_) {}

  std::vector<PointRecord> records() const;
  std::vector<ClosedPoint> closed() const;
  std::vector<Site> sites() const; ///< points (I,P), or nodes
  double friction() const;         ///< coefficient at the last evaluated load parameter

private:
  const Interaction::Parts& parts_;
};

} // namespace abut::contact
