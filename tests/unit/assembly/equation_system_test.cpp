// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/equation_system.hpp"
#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/meshgen/generate.hpp"
#include "abut/solid/solid_contribution.hpp"

#include <gtest/gtest.h>

using namespace abut;

namespace {

/// A distorted box of hex8 on all ranks, neo-Hookean or linear elastic.
struct Box {
  mesh::Mesh mesh;
  PhaseTimers timers;
  assembly::EquationSystem system;

  explicit Box(solid::MaterialModel model)
      : mesh(make_mesh()), system(unknowns::DofMap(mesh, {"x", "y", "z"}), timers) {
    solid::MaterialOptions material;
    material.model = model;
    material.young = 2.0;
    material.poisson = 0.3;
    system.add(std::make_shared<solid::SolidContribution>(mesh, 0, solid::make_material(material)));
  }

  static mesh::Mesh make_mesh() {
    const Comm comm(MPI_COMM_WORLD);
    mesh::MeshData data;
    if (comm.is_root())
      data = meshgen::generate("box", {{"divisions", "4,3,3"}, {"distortion", "0.1"}});
    return mesh::distribute(data, comm);
  }

  /// A smooth field over the reference coordinates, the same on any number of ranks.
  Vector field(double scale) const {
    Vector v(system.dofs().map());
    const auto view = v.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (Local r = 0; r < system.dofs().num_rows(); ++r) {
      const double* x = &mesh.x[3 * std::size_t(system.dofs().node_of_row(r))];
      for (int i = 0; i < 3; ++i)
        view(3 * std::size_t(r) + std::size_t(i), 0) =
            scale * std::sin(x[0] + 2 * x[1] * (i + 1) - x[2]);
    }
    return v;
  }

  bool on_boundary(Local node) const {
    for (int i = 0; i < 3; ++i) {
      const double x = mesh.x[3 * std::size_t(node) + std::size_t(i)];
      if (std::fabs(x) < 1e-12 || std::fabs(x - 1.0) < 1e-12)
        return true;
    }
    return false;
  }
};

double difference(const Vector& a, const Vector& b) {
  Vector d(a.getMap());
  d.assign(a);
  d.update(-1.0, b, 1.0);
  return d.norm2();
}

} // namespace

TEST(EquationSystem, TangentIsTheDerivativeOfTheResidual) {
  Box box(solid::MaterialModel::neo_hookean);
  const auto map = box.system.dofs().map();
  const Vector x = box.field(0.05), v = box.field(1.0);
  Vector product(map), plus(map), minus(map), y(map);
  box.system.tangent(x)->apply(v, product);
  const double h = 1e-5;
  y.update(1.0, x, h, v, 0.0);
  box.system.residual(y, plus);
  y.update(1.0, x, -h, v, 0.0);
  box.system.residual(y, minus);
  plus.update(-0.5 / h, minus, 0.5 / h);
  EXPECT_GT(product.norm2(), 0.1);
  EXPECT_LT(difference(product, plus), 1e-8 * product.norm2());
}

/// f(x0) + K(x0) (x - x0), even where an element of x is inverted.
TEST(EquationSystem, ApproachIsLinearAboutTheAcceptedState) {
  Box box(solid::MaterialModel::neo_hookean);
  const Vector accepted = box.field(0.05), way = box.field(3.0);
  Vector x(accepted, Teuchos::Copy), f(x.getMap()), expected(x.getMap()), change(x.getMap());
  box.system.residual(accepted, expected);
  box.system.accept(accepted);
  box.system.tangent(accepted)->apply(way, change);
  expected.update(1.0, change, 1.0);
  x.update(1.0, way, 1.0);
  EXPECT_THROW(box.system.residual(x, f), SolveError);
  box.system.begin_solve(SolveKind::approach);
  box.system.residual(x, f);
  EXPECT_GT(change.norm2(), 1.0);
  EXPECT_LT(difference(f, expected), 1e-4 * change.norm2());
  Vector product(x.getMap());
  box.system.tangent(x)->apply(way, product);
  EXPECT_LT(difference(product, change), 1e-14 * change.norm2());
  box.system.begin_solve(SolveKind::newton);
  EXPECT_THROW(box.system.residual(x, f), SolveError);
  box.system.begin_solve(SolveKind::approach);
  box.system.reject(); // a step that ends in an approach leaves nothing of it
  EXPECT_THROW(box.system.residual(x, f), SolveError);
  x.update(0.5, accepted, 0.5, accepted, 0.0);
  box.system.residual(x, f);
  expected.update(-1.0, change, 1.0);
  EXPECT_LT(difference(f, expected), 1e-12 * change.norm2());
}

// The same sums on any number of ranks: values computed on one rank.
TEST(EquationSystem, SameNormsOnAnyNumberOfRanks) {
  Box box(solid::MaterialModel::neo_hookean);
  const Vector x = box.field(0.05), v = box.field(1.0);
  Vector f(x.getMap()), product(x.getMap());
  box.system.residual(x, f);
  box.system.tangent(x)->apply(v, product);
  const double found[3] = {f.norm2(), product.norm2(), box.system.measure().reference};
  // One rank alone holds the whole mesh: the slow, obvious way.
  MPI_Comm self;
  MPI_Comm_split(MPI_COMM_WORLD, Comm(MPI_COMM_WORLD).rank(), 0, &self);
  {
    const Comm alone(self);
    const mesh::Mesh whole = mesh::distribute(
        meshgen::generate("box", {{"divisions", "4,3,3"}, {"distortion", "0.1"}}), alone);
    PhaseTimers timers;
    assembly::EquationSystem system(unknowns::DofMap(whole, {"x", "y", "z"}), timers);
    solid::MaterialOptions material;
    material.young = 2.0;
    material.poisson = 0.3;
    system.add(
        std::make_shared<solid::SolidContribution>(whole, 0, solid::make_material(material)));
    Vector xs(system.dofs().map()), vs(system.dofs().map()), fs(system.dofs().map()),
        ks(system.dofs().map());
    {
      const auto a = xs.getLocalViewHost(Tpetra::Access::OverwriteAll);
      const auto b = vs.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (Local n = 0; n < whole.num_local(); ++n)
        for (int i = 0; i < 3; ++i) {
          const double* p = &whole.x[3 * std::size_t(n)];
          const double s = std::sin(p[0] + 2 * p[1] * (i + 1) - p[2]);
          a(3 * std::size_t(n) + std::size_t(i), 0) = 0.05 * s;
          b(3 * std::size_t(n) + std::size_t(i), 0) = s;
        }
    }
    system.residual(xs, fs);
    system.tangent(xs)->apply(vs, ks);
    EXPECT_NEAR(found[0], fs.norm2(), 1e-12 * fs.norm2());
    EXPECT_NEAR(found[1], ks.norm2(), 1e-12 * ks.norm2());
    EXPECT_NEAR(found[2], system.measure().reference, 1e-12 * system.measure().reference);
  }
  MPI_Comm_free(&self);
}

TEST(EquationSystem, ConstrainedRowsAndColumnsHoldOnlyTheirDiagonal) {
  Box box(solid::MaterialModel::linear_elastic);
  std::vector<assembly::Constraint> constraints;
  for (Local n = 0; n < box.mesh.num_owned; ++n)
    if (box.mesh.x[3 * std::size_t(n) + 2] < 1e-12)
      constraints.push_back({n, 1, [](double t) { return t; }});
  box.system.set_constraints(constraints);
  const auto matrix = box.system.tangent(box.field(0.01));
  // K e must vanish outside the constrained rows when e lives in the constrained columns.
  Vector e(matrix->getRowMap()), k(matrix->getRowMap());
  {
    const auto view = e.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < view.extent(0); ++i)
      view(i, 0) = 0.0;
    for (const auto& c : constraints)
      view(3 * std::size_t(box.system.dofs().row_of_node(c.node)) + 1, 0) = 1.0;
  }
  matrix->apply(e, k);
  const auto in = e.getLocalViewHost(Tpetra::Access::ReadOnly);
  const auto out = k.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (std::size_t i = 0; i < out.extent(0); ++i) {
    if (in(i, 0) == 0.0) {
      EXPECT_EQ(out(i, 0), 0.0);
    } else {
      EXPECT_GT(out(i, 0), 0.01);
    }
  }
}

// An affine displacement solves the linear problem: the predictor's equations must hold for it.
TEST(EquationSystem, PredictorMovesTheInteriorWithTheBoundary) {
  Box box(solid::MaterialModel::linear_elastic);
  const auto affine = [](const double* x, int i) {
    return 0.01 * x[0] + 0.02 * x[1] * (i + 1) - 0.005 * x[2];
  };
  std::vector<assembly::Constraint> constraints;
  Local interior = 0;
  for (Local n = 0; n < box.mesh.num_owned; ++n) {
    if (!box.on_boundary(n)) {
      ++interior;
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      const double value = affine(&box.mesh.x[3 * std::size_t(n)], i);
      constraints.push_back({n, i, [value](double t) { return t * value; }});
    }
  }
  EXPECT_GT(box.mesh.comm.sum(Global(interior)), 0);
  box.system.set_constraints(constraints);
  box.system.set_time(1.0);
  Vector x(box.system.dofs().map()), rhs(x.getMap()), exact(x.getMap()), product(x.getMap());
  {
    const auto view = exact.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (Local r = 0; r < box.system.dofs().num_rows(); ++r)
      for (int i = 0; i < 3; ++i)
        view(3 * std::size_t(r) + std::size_t(i), 0) =
            affine(&box.mesh.x[3 * std::size_t(box.system.dofs().node_of_row(r))], i);
  }
  box.system.predictor(x, rhs)->apply(exact, product);
  EXPECT_GT(rhs.norm2(), 1e-3);
  EXPECT_LT(difference(product, rhs), 1e-14 * rhs.norm2() + 1e-15);
  x.assign(exact);
  box.system.residual(x, product);
  EXPECT_LT(product.norm2(), 1e-14);
}

// What is prescribed for a time, and what counts from where it is then.
TEST(EquationSystem, ConstraintsHoldInTheirWindows) {
  Box box(solid::MaterialModel::neo_hookean);
  std::vector<assembly::Constraint> constraints;
  std::vector<std::size_t> first, second; // rows of the two windows
  for (Local n = 0; n < box.mesh.num_owned; ++n) {
    const auto row = 3 * std::size_t(box.system.dofs().row_of_node(n));
    const double z = box.mesh.x[3 * std::size_t(n) + 2];
    if (z < 1e-12) {
      constraints.push_back({n, 1, [](double t) { return t; }, {0.0, 1.0}});
      first.push_back(row + 1);
    } else if (z > 1.0 - 1e-12) {
      constraints.push_back({n, 0, [](double t) { return 0.1 * t; }, {1.0, {}}, true});
      second.push_back(row);
    }
  }
  auto& system = box.system;
  system.set_constraints(constraints);
  Vector x = box.field(0.05), f(x.getMap());
  const auto largest = [&](const std::vector<std::size_t>& rows) {
    system.residual(x, f);
    const auto view = f.getLocalViewHost(Tpetra::Access::ReadOnly);
    double most = 0.0;
    for (const std::size_t row : rows)
      most = std::max(most, std::fabs(view(row, 0)));
    return box.mesh.comm.max(most);
  };
  const auto values = [&](const std::vector<std::size_t>& rows) {
    std::vector<double> list;
    const auto view = x.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (const std::size_t row : rows)
      list.push_back(view(row, 0));
    return list;
  };
  const auto set = [&](double t) {
    x = box.field(0.05);
    system.set_time(t);
    system.apply_constraints(x);
  };
  set(0.5);
  EXPECT_EQ(largest(first), 0.0);
  EXPECT_GT(largest(second), 1e-3);
  for (const double value : values(first))
    EXPECT_EQ(value, 0.5);
  const std::vector<double> start = values(second);
  const auto before = system.tangent(x);
  system.residual(x, f);
  system.accept(x);
  for (const double t : {2.0, 1.5}) { // the first of the two is cut
    set(t);
    EXPECT_GT(largest(first), 1e-3);
    EXPECT_EQ(largest(second), 0.0);
    for (std::size_t i = 0; i < second.size(); ++i)
      EXPECT_EQ(values(second)[i], start[i] + 0.1 * t);
    EXPECT_NE(system.tangent(x).get(), before.get());
    system.reject();
  }
  set(1.5);
  system.residual(x, f);
  system.accept(x);
  set(2.0); // it still counts from where the window began
  for (std::size_t i = 0; i < second.size(); ++i)
    EXPECT_EQ(values(second)[i], start[i] + 0.1 * 2.0);
}
