// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/contribution.hpp"
#include "abut/rigid/bodies.hpp"
#include "abut/unknowns/block_pattern.hpp"

#include <memory>
#include <vector>

namespace abut::assembly {

/// Kinds of forces whose sizes count by themselves: loads and contact are one.
enum class Force { internal, other, inertial };

/// All contributions, the pattern of their cells, and where each cell goes in it. Sums are of the
/// rows of this rank, owned and shared, unless it says otherwise.
class Contributions {
public:
  /// dofs and timers must outlive this object.
  Contributions(const unknowns::DofMap& dofs, PhaseTimers& timers)
      : dofs_(dofs), timers_(timers), pattern_(dofs) {}
  Contributions(const Contributions&) = delete;

  void add(std::shared_ptr<Contribution> contribution);
  std::size_t size() const { return parts_.size(); }
  const char* name(std::size_t part) const { return parts_[part].contribution->name(); }
  const unknowns::BlockPattern& pattern() const { return pattern_; }

  /// Search, pairs and pattern. Returns whether the pattern was built anew. Collective, as are all
  /// that follow; errors are thrown on all ranks.
  bool prepare(const NodalFields& fields);

  /// (owned and shared scalar rows) what all of one kind exert.
  std::vector<double> residual(Force which, const NodalFields& fields, rigid::Bodies& bodies);
  /// The internal forces at `fields` by their derivative at `about`, a quotient of differences.
  std::vector<double> linear_residual(const NodalFields& about, const NodalFields& fields,
                                      rigid::Bodies& bodies);
  /// (owned scalar rows) external forces; sums of forces on bodies stay those of the last residual.
  std::vector<double> loads(const NodalFields& fields, rigid::Bodies& bodies);
  /// (owned scalar rows) of one part.
  std::vector<double> residual_of(std::size_t part, const NodalFields& fields,
                                  rigid::Bodies& bodies);

  /// Adds the tangents of all of one kind to the values of the pattern.
  void add_tangents(Force which, const NodalFields& fields, rigid::Bodies& bodies, double* values);
  void add_tangent_of(std::size_t part, const NodalFields& fields, rigid::Bodies& bodies,
                      double* values);

  // Events, see Contribution.
  void begin_step();
  void begin_solve(SolveKind kind);
  void iterate_taken();
  void accept();
  void reject();

  // Not collective; of this rank where it says so.
  bool symmetric() const;
  double round_off_force2() const; ///< see Contribution; of this rank
  long state_version() const;      ///< of all; grows with every change; of this rank
  int unsettled() const;           ///< how many; of this rank
  int overloaded() const;          ///< likewise
  bool land() const;               ///< whether some do, see Contribution::lands

private:
  struct Part {
    std::shared_ptr<Contribution> contribution;
    unknowns::CellPositions positions;
    long connectivity_version = -1;
    long pattern_version = -1;
  };
  bool update_pattern();
  bool locate();
  std::vector<double> zeros() const;
  ResidualScatter residual_scatter(const Part& part, rigid::Bodies& bodies, double* values) const;
  void add_tangent(const Part& part, const NodalFields& fields, rigid::Bodies& bodies,
                   double* values);
  void finish(std::vector<double>& buffer) const;

  const unknowns::DofMap& dofs_;
  PhaseTimers& timers_;
  unknowns::BlockPattern pattern_;
  std::vector<Part> parts_;
};

} // namespace abut::assembly
