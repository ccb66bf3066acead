// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"
#include "abut/core/trilinos_fwd.hpp"
#include "abut/multigrid/near_null_space.hpp"

#include <Tpetra_Operator_fwd.hpp>
#include <memory>
#include <vector>

/// Smoothed aggregation of node blocks in single precision, for use under a Krylov method in
/// double precision. Vanek, Mandel, Brezina, Algebraic multigrid by smoothed aggregation for second
/// and fourth order elliptic problems, Computing 56 (1996).
namespace abut::multigrid {

struct Options {
  /// A coupling is weak where the evolution measure is more than so many times the least of its
  /// rows. Infinity: all are strong. Olson, Schroder, Tuminaro (2010); PyAMG takes 4, but the faces
  /// of trilinear cubes have 3.96, which this value stays clear of. [1]
  double drop_tolerance = 6.0;
  /// Over the largest eigenvalue of D^-1 A, the weight that smooths prolongators. [1]
  double prolongator_damping = 4.0 / 3.0;
  int coarsest_unknowns = 600; ///< at most so many are factored densely, on every rank
  int max_levels = 12;
};

struct LevelReport {
  Global rows = 0;   ///< block rows on all ranks
  Global blocks = 0; ///< blocks of the matrix on all ranks
  int unknowns_per_row = 0;
};

/// One hierarchy of levels, from fine to coarse. Every member is collective.
class Multigrid {
public:
  /// modes: of the rows of the matrices to come. Throws Defect where `fields` is not 1 to 4.
  Multigrid(const Comm& comm, const NearNullSpace& modes, const Options& options = {});
  ~Multigrid();

  /// Aggregates, prolongators and all coarse matrices of `matrix`, whose owned rows are those of
  /// the modes, block after block with contiguous numbers on each rank. A scalar row that holds
  /// only its diagonal counts as constrained.
  void setup(const Matrix& matrix);
  /// Another matrix over the same rows, with the prolongators of the last setup. same_places: with
  /// the graph of the last matrix.
  void refresh(const Matrix& matrix, bool same_places);
  bool is_set_up() const;

  /// x = B b: one V cycle with a forward block Gauss-Seidel sweep before and a backward one after
  /// each correction; symmetric where the matrix is. b, x: owned unknowns of this rank.
  void apply(const double* b, double* x) const;

  std::vector<LevelReport> levels() const;
  /// Blocks of all levels, weighted by their size, over those of the finest. [1]
  double operator_complexity() const;
  std::size_t bytes() const; ///< held on this rank between calls

private:
  class Hierarchy;
  template <int N> class Levels;
  std::unique_ptr<Hierarchy> hierarchy_;
};

/// The V cycle as an operator for Belos and others.
RCP<Tpetra::Operator<double, Local, Global, Node>>
make_operator(std::shared_ptr<const Multigrid> multigrid, RCP<const Map> map);

} // namespace abut::multigrid
