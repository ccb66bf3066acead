// SPDX-License-Identifier: BSD-3-Clause
#include "mumps_solver.hpp"

#include "abut/core/comm.hpp"
#include "abut/core/error.hpp"
#include "abut/core/machine_error.hpp"
#include "abut/core/trilinos.hpp"

#include <cmath>
#include <dmumps_c.h>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace abut::solver {

namespace {

MPI_Comm mpi_comm(const Map& map) {
  const auto comm = Teuchos::rcp_dynamic_cast<const Teuchos::MpiComm<int>>(map.getComm());
  if (comm.is_null())
    return MPI_COMM_SELF;
  return (*comm->getRawMpiComm())();
}

/// Position in the MUMPS numbering (rank after rank, 0-based) of every column on this rank.
std::vector<MUMPS_INT> column_positions(const Matrix& matrix, Global first) {
  const auto map = matrix.getDomainMap();
  const auto column_map = matrix.getColMap();
  Vector owned(map), needed(column_map);
  {
    // A double holds every integer below 2^53, far above what MUMPS_INT counts.
    const auto view = owned.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < view.extent(0); ++i)
      view(i, 0) = static_cast<double>(first + Global(i));
  }
  const auto importer = matrix.getGraph()->getImporter();
  if (importer.is_null())
    needed = owned;
  else
    needed.doImport(owned, *importer, Tpetra::INSERT);
  const auto view = needed.getLocalViewHost(Tpetra::Access::ReadOnly);
  std::vector<MUMPS_INT> positions(view.extent(0));
  for (std::size_t i = 0; i < positions.size(); ++i)
    positions[i] = static_cast<MUMPS_INT>(std::llround(view(i, 0)));
  return positions;
}

constexpr int scotch = 3;
constexpr double wanted_residual = 1e-10, accepted_residual = 1e-6;
constexpr int max_refinements = 3;
/// Pivots below this fraction of the scaled matrix's norm are rounding noise around zero.
constexpr double null_pivot = 1e-15;
/// |diag(A) x| / |b| beyond which the solution is a rigid motion blown up by rounding.
constexpr double runaway = 1e13;

SolveError singular(bool joints) {
  return SolveError(
      std::string("The stiffness matrix is singular: some body, or part of one, is free to move") +
      (joints ? ", or joints hold one motion twice." : "."));
}

} // namespace

constexpr double same_values = 1e-13; ///< change of the matrix, to its largest value, that is none

class MumpsSolver::Instance {
public:
  Instance(const RCP<const Map>& map, bool symmetric, bool joints)
      : map_(map), comm_(mpi_comm(*map)), symmetric_(symmetric), joints_(joints) {
    ABUT_REQUIRE(map->getGlobalNumElements() < std::numeric_limits<MUMPS_INT>::max(),
                 "too many unknowns for MUMPS");
    data_.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(comm_.mpi()));
    data_.par = 1;
    data_.sym = symmetric ? 2 : 0;
    run(-1);
    for (int unit = 1; unit <= 3; ++unit)
      icntl(unit) = -1;
    icntl(4) = 0;
    icntl(5) = 0;
    icntl(7) = scotch;
    icntl(13) = 1; // no ScaLAPACK at the root: null pivots are found there too
    icntl(14) = 30;
    icntl(18) = 3;
    icntl(24) = 1;
    icntl(28) = 1;
    data_.cntl[2] = null_pivot;
    const auto local = static_cast<Global>(local_size(*map));
    first_ = comm_.exclusive_scan(local);
    set_up_gather(static_cast<int>(local));
  }

  ~Instance() {
    int finalized = 0;
    MPI_Finalized(&finalized);
    if (!finalized)
      run(-2);
  }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  bool fits(const Map& map, bool symmetric) const {
    return symmetric == symmetric_ && (&map == map_.get() || map.isSameAs(*map_));
  }

  /// Whether there are new factors: not where the old ones serve.
  bool factor(const Matrix& matrix, long graph_version) {
    const bool analysed = analysed_ && graph_version == graph_version_;
    if (!analysed)
      read_graph(matrix);
    const std::vector<double> before = std::move(values_);
    read_values(matrix);
    if (analysed && factored_ && !comm_.any(differ(before, values_)))
      return false; // an augmentation that changed no point's status, a linear scene
    factored_ = false;
    if (!analysed) {
      analysed_ = false;
      run(1);
      check_status();
      analysed_ = true;
      graph_version_ = graph_version;
    }
    constexpr int max_growths = 6;
    for (int growth = 0;; ++growth) {
      run(2);
      const bool too_small = data_.infog[0] == -9 || data_.infog[0] == -8 || data_.infog[0] == -20;
      if (!too_small || growth == max_growths)
        break;
      icntl(14) *= 2;
    }
    check_status();
    if (data_.infog[27] > 0)
      throw singular(joints_);
    factored_ = true;
    return true;
  }

  /// x = A^-1 b with the present factors.
  void back_substitute(const Vector& b, Vector& x) {
    gather(b);
    data_.nrhs = 1;
    data_.lrhs = data_.n;
    data_.rhs = gathered_.data();
    run(3);
    check_status();
    scatter(x);
  }

private:
  /// Whether factors of `a` would not serve `b` as well, refinement of the solution included.
  static bool differ(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size())
      return true;
    double largest = 0.0, change = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      largest = std::max(largest, std::fabs(a[i]));
      change = std::max(change, std::fabs(a[i] - b[i]));
    }
    return !(change <= same_values * largest);
  }

  MUMPS_INT& icntl(int i) { return data_.icntl[i - 1]; }

  void run(int job) {
    data_.job = job;
    dmumps_c(&data_);
  }

  void check_status() {
    const int status = data_.infog[0];
    if (status >= 0)
      return;
    if (status == -10 || status == -6)
      throw singular(joints_);
    if (status == -7 || status == -13 || status == -19 || status == -9 || status == -8)
      throw MachineError(out_of_memory);
    throw Defect("MUMPS failed with status " + std::to_string(status) + ", " +
                 std::to_string(data_.infog[1]));
  }

  bool keeps(MUMPS_INT row, MUMPS_INT column) const { return !symmetric_ || column >= row; }

  void read_graph(const Matrix& matrix) {
    const auto local = matrix.getLocalMatrixHost();
    columns_ = column_positions(matrix, first_);
    rows_of_entries_.clear();
    columns_of_entries_.clear();
    for (Local i = 0; i < local.numRows(); ++i) {
      const auto row = static_cast<MUMPS_INT>(first_ + i);
      for (auto k = local.graph.row_map(i); k < local.graph.row_map(i + 1); ++k) {
        const MUMPS_INT column = columns_[static_cast<std::size_t>(local.graph.entries(k))];
        if (!keeps(row, column))
          continue;
        rows_of_entries_.push_back(row + 1);
        columns_of_entries_.push_back(column + 1);
      }
    }
  }

  void read_values(const Matrix& matrix) {
    const auto local = matrix.getLocalMatrixHost();
    values_.clear();
    for (Local i = 0; i < local.numRows(); ++i)
      for (auto k = local.graph.row_map(i); k < local.graph.row_map(i + 1); ++k)
        if (keeps(static_cast<MUMPS_INT>(first_ + i),
                  columns_[static_cast<std::size_t>(local.graph.entries(k))]))
          values_.push_back(local.values(k));
    ABUT_REQUIRE(values_.size() == rows_of_entries_.size(),
                 "the matrix graph changed but its version did not");
    data_.n = static_cast<MUMPS_INT>(map_->getGlobalNumElements());
    data_.nnz_loc = static_cast<MUMPS_INT8>(values_.size());
    data_.irn_loc = rows_of_entries_.data();
    data_.jcn_loc = columns_of_entries_.data();
    data_.a_loc = values_.data();
  }

  void set_up_gather(int local) {
    counts_.resize(static_cast<std::size_t>(comm_.size()));
    MPI_Allgather(&local, 1, MPI_INT, counts_.data(), 1, MPI_INT, comm_.mpi());
    offsets_.assign(counts_.size(), 0);
    std::partial_sum(counts_.begin(), counts_.end() - 1, offsets_.begin() + 1);
    if (comm_.is_root())
      gathered_.resize(map_->getGlobalNumElements());
  }

  void gather(const Vector& b) {
    const auto view = b.getLocalViewHost(Tpetra::Access::ReadOnly);
    MPI_Gatherv(view.data(), static_cast<int>(view.extent(0)), MPI_DOUBLE, gathered_.data(),
                counts_.data(), offsets_.data(), MPI_DOUBLE, 0, comm_.mpi());
  }

  void scatter(Vector& x) {
    const auto view = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    MPI_Scatterv(gathered_.data(), counts_.data(), offsets_.data(), MPI_DOUBLE, view.data(),
                 static_cast<int>(view.extent(0)), MPI_DOUBLE, 0, comm_.mpi());
  }

  RCP<const Map> map_;
  Comm comm_;
  bool symmetric_;
  bool joints_;
  DMUMPS_STRUC_C data_{};
  Global first_ = 0; ///< position of this rank's first row
  bool analysed_ = false, factored_ = false;
  long graph_version_ = 0;
  std::vector<MUMPS_INT> columns_, rows_of_entries_, columns_of_entries_;
  std::vector<double> values_, gathered_;
  std::vector<int> counts_, offsets_;
};

MumpsSolver::MumpsSolver(PhaseTimers* timers, bool joints)
    : LinearSolver("direct", timers), joints_(joints) {}
MumpsSolver::~MumpsSolver() = default;

void MumpsSolver::do_setup(const RCP<const Matrix>& matrix, long graph_version, bool symmetric) {
  matrix_ = matrix;
  if (!instance_ || !instance_->fits(*matrix->getRowMap(), symmetric))
    instance_ = std::make_unique<Instance>(matrix->getRowMap(), symmetric, joints_);
  measured_setup([&] { return instance_->factor(*matrix, graph_version); });
}

LinearResult MumpsSolver::do_solve(const Vector& b, Vector& x, double) {
  const double size = b.norm2();
  Vector residual(b.getMap()), correction(b.getMap());
  const auto relative_residual = [&] {
    matrix_->apply(x, residual);
    residual.update(1.0, b, -1.0);
    return residual.norm2() / size;
  };

  instance_->back_substitute(b, x);
  double relative = relative_residual();
  for (int i = 0; i < max_refinements && relative > wanted_residual; ++i) {
    instance_->back_substitute(residual, correction);
    x.update(1.0, correction, 1.0);
    const double refined = relative_residual();
    if (!(refined < relative)) {
      x.update(-1.0, correction, 1.0);
      relative = relative_residual();
      break;
    }
    relative = refined;
  }
  Vector diagonal(b.getMap());
  matrix_->getLocalDiagCopy(diagonal);
  correction.elementWiseMultiply(1.0, diagonal, x, 0.0);
  if (!(correction.norm2() < runaway * size))
    throw singular(joints_);
  if (!(relative <= accepted_residual))
    throw SolveError("The direct solver left a relative residual of " + std::to_string(relative) +
                     ": the stiffness matrix is too ill-conditioned.");
  return {1, relative};
}

} // namespace abut::solver
