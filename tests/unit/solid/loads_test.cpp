// SPDX-License-Identifier: BSD-3-Clause
#include "automatic.hpp"

#include "abut/core/error.hpp"
#include "abut/solid/face_kernel.hpp"
#include "abut/solid/load_contribution.hpp"
#include "abut/solid/reference_checks.hpp"
#include "abut_test/dense_system.hpp"
#include "small_mesh.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::solid;
using fem::CellType;
using test::all_cells;

namespace {

mesh::Mesh one_element(CellType type, std::mt19937& engine, double distortion = 0.08) {
  mesh::Mesh mesh = test::separate_elements(
      type, {test::straight_nodes(type, test::distorted_corners(type, distortion, engine))});
  for (int s = 0; s < fem::info(type).sides; ++s) {
    mesh.side_sets["all"].push_back({0, 0, s});
    mesh.side_sets["side" + std::to_string(s)].push_back({0, 0, s});
  }
  mesh.node_sets["two"] = {0, 3};
  return mesh;
}

LoadOptions load(LoadKind kind, const std::string& place) {
  LoadOptions o;
  o.name = "load";
  o.kind = kind;
  o.place = place;
  o.vector = {2.0, -3.0, 5.0};
  o.pressure = 1.7;
  return o;
}

/// Sum of the nodal external forces and their moment about the origin at positions x.
struct Resultant {
  Vec3 force = Vec3::zero(), moment = Vec3::zero();
  Resultant(const std::vector<double>& r, const std::vector<double>& x) {
    for (std::size_t a = 0; a < r.size(); a += 3) {
      const Vec3 f{{-r[a], -r[a + 1], -r[a + 2]}};
      force += f;
      moment += cross(Vec3{{x[a], x[a + 1], x[a + 2]}}, f);
    }
  }
};

TEST(Loads, TractionResultantIsForceTimesReferenceArea) {
  std::mt19937 engine(1);
  for (const CellType type : all_cells) {
    const mesh::Mesh mesh = one_element(type, engine, 0.0);
    const bool tet = type == CellType::tet4 || type == CellType::tet10;
    // Faces of the reference cell with z = -1 (z = 0 for tetrahedra).
    const double area = tet || type == CellType::wedge6 ? 0.5 : 4.0;
    const std::string place =
        type == CellType::hex8 || type == CellType::hex20 || type == CellType::hex27 ? "side4"
                                                                                     : "side3";
    LoadContribution c(mesh, load(LoadKind::traction, place), [](double t) { return 10.0 * t; });
    EXPECT_TRUE(c.symmetric());
    EXPECT_EQ(c.role(), Role::external);
    abut_test::DenseSystem system(mesh.num_local(), 3);
    system.u = test::random_vector(system.u.size(), 0.3, engine); // dead: must not matter
    system.evaluate(c, true, 0.5);
    const Resultant sum(system.residual, mesh.x);
    const LoadOptions o = load(LoadKind::traction, "");
    const double centroid = tet || type == CellType::wedge6 ? 1.0 / 3.0 : 0.0;
    const Vec3 force =
        5 * area * Vec3{{o.vector[0].number, o.vector[1].number, o.vector[2].number}};
    const Vec3 moment = cross(Vec3{{centroid, centroid, tet ? 0.0 : -1.0}}, force);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(sum.force[i], force[i], 1e-13 * norm(force)) << fem::info(type).name;
      EXPECT_NEAR(sum.moment[i], moment[i], 1e-13 * norm(force)) << fem::info(type).name;
    }
    for (const double k : system.tangent)
      EXPECT_EQ(k, 0.0);
  }
}

TEST(Loads, BodyForceResultantIsForceTimesReferenceVolume) {
  std::mt19937 engine(2);
  for (const CellType type : all_cells) {
    const mesh::Mesh mesh = one_element(type, engine);
    LoadContribution c(mesh, load(LoadKind::body_force, "body"), {});
    abut_test::DenseSystem system(mesh.num_local(), 3);
    system.evaluate(c, true, 0.25);
    const Resultant sum(system.residual, mesh.x);
    const double volume = element_volume(mesh, 0, 0);
    const LoadOptions o = load(LoadKind::body_force, "");
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(sum.force[i], 0.25 * volume * o.vector[i].number, 2e-14 * volume);
  }
}

TEST(Loads, NodalForceGoesToOwnedNodesOnly) {
  std::mt19937 engine(2);
  mesh::Mesh mesh = one_element(CellType::hex8, engine);
  mesh.num_owned = 2; // node 3 plays a ghost
  LoadContribution c(mesh, load(LoadKind::force, "two"), [](double t) { return 2.0 * t; });
  EXPECT_EQ(c.connectivity().cells(), 1);
  abut_test::DenseSystem system(mesh.num_local(), 3);
  system.evaluate(c, true, 3.0);
  EXPECT_EQ(system.residual[0], -12.0);
  EXPECT_EQ(system.residual[1], 18.0);
  EXPECT_EQ(system.residual[2], -30.0);
  for (std::size_t i = 3; i < system.residual.size(); ++i)
    EXPECT_EQ(system.residual[i], 0.0);
}

// A closed surface under uniform pressure has no resultant force and no moment, however deformed.
TEST(Loads, PressureOnClosedSurfaceBalances) {
  std::mt19937 engine(4);
  for (const CellType type : all_cells) {
    const mesh::Mesh mesh = one_element(type, engine);
    LoadContribution c(mesh, load(LoadKind::pressure, "all"), {});
    EXPECT_FALSE(c.symmetric());
    abut_test::DenseSystem system(mesh.num_local(), 3);
    system.u = test::random_vector(system.u.size(), 0.1, engine);
    std::vector<double> x = mesh.x;
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] += system.u[i];
    system.evaluate(c, true);
    const Resultant sum(system.residual, x);
    EXPECT_NEAR(norm(sum.force), 0.0, 1e-13) << fem::info(type).name;
    EXPECT_NEAR(norm(sum.moment), 0.0, 1e-13) << fem::info(type).name;
  }
}

// Positive pressure pushes inwards: force = -p A n with the current area.
TEST(Loads, PressurePushesInwardsOnCurrentArea) {
  std::mt19937 engine(4);
  const mesh::Mesh mesh = one_element(CellType::hex8, engine, 0.0);
  LoadContribution c(mesh, load(LoadKind::pressure, "side5"), {}); // z = 1
  abut_test::DenseSystem system(mesh.num_local(), 3);
  for (std::size_t i = 0; i < system.u.size(); i += 3)
    system.u[i] = 0.5 * mesh.x[i];
  system.evaluate(c, false, 2.0);
  const Resultant sum(system.residual, mesh.x);
  EXPECT_NEAR(sum.force[0], 0.0, 1e-14);
  EXPECT_NEAR(sum.force[1], 0.0, 1e-14);
  EXPECT_NEAR(sum.force[2], -2.0 * 1.7 * 6.0, 1e-13);
}

// A traction keeps its direction and acts on the area that there is.
TEST(Loads, TractionOnCurrentArea) {
  std::mt19937 engine(4);
  const mesh::Mesh mesh = one_element(CellType::hex8, engine, 0.0);
  LoadOptions o = load(LoadKind::traction, "side5"); // z = 1
  o.current_area = true;
  LoadContribution c(mesh, o, {});
  EXPECT_FALSE(c.symmetric());
  abut_test::DenseSystem system(mesh.num_local(), 3);
  for (std::size_t i = 0; i < system.u.size(); i += 3)
    system.u[i] = 0.5 * mesh.x[i];
  system.evaluate(c, false, 2.0);
  const Resultant sum(system.residual, mesh.x);
  const double t[] = {2.0, -3.0, 5.0};
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(sum.force[i], 2.0 * t[i] * 6.0, 1e-13);
}

/// residual(x, r) and tangent(x, k) of a face with nodes x.
template <fem::FaceType F, class Residual, class Tangent>
void check_face_tangent(const Residual& residual, const Tangent& tangent) {
  constexpr int n = ReferenceFace<F>::nodes, size = 3 * n;
  using Ad = Sacado::Fad::SFad<double, size>;
  std::mt19937 engine(9);
  const std::vector<double> random = test::random_vector(size, 1.0, engine);
  Vec3 x[n];
  Vec<Ad, 3> x_ad[n], r[n];
  for (int a = 0; a < n; ++a) {
    double xi[2];
    fem::FaceShape<F>::node(a, xi);
    for (int i = 0; i < 3; ++i) {
      x[a][i] = (i < 2 ? xi[i] : 0.0) + 0.2 * random[3 * a + i];
      x_ad[a][i] = Ad(size, 3 * a + i, x[a][i]);
    }
  }
  residual(x_ad, r);
  double k[size * size];
  tangent(x, k);
  double largest = 0.0, asymmetry = 0.0;
  for (int p = 0; p < size; ++p)
    for (int q = 0; q < size; ++q) {
      EXPECT_NEAR(k[p * size + q], r[p / 3][p % 3].dx(q), 1e-14);
      largest = std::max(largest, std::abs(k[p * size + q]));
      asymmetry = std::max(asymmetry, std::abs(k[p * size + q] - k[q * size + p]));
    }
  EXPECT_GT(largest, 0.01);
  EXPECT_GT(asymmetry, 0.01);
}

template <fem::FaceType F> void check_pressure_tangent() {
  double pressure[ReferenceFace<F>::points]; // varies over the face
  for (int p = 0; p < ReferenceFace<F>::points; ++p)
    pressure[p] = 1.7 + 0.2 * p;
  check_face_tangent<F>(
      [&](const auto* x, auto* r) { pressure_residual(reference_face<F>(), pressure, x, r); },
      [&](const Vec3* x, double* k) { pressure_tangent(reference_face<F>(), pressure, x, k); });
}

template <fem::FaceType F> void check_traction_tangent() {
  Vec3 traction[ReferenceFace<F>::points];
  for (int p = 0; p < ReferenceFace<F>::points; ++p)
    traction[p] = {{1.7 + 0.2 * p, -0.3, 0.5 - 0.1 * p}};
  check_face_tangent<F>(
      [&](const auto* x, auto* r) { traction_residual(reference_face<F>(), traction, x, r); },
      [&](const Vec3* x, double* k) { traction_tangent(reference_face<F>(), traction, x, k); });
}

TEST(Loads, TractionTangentMatchesAutomaticDifferentiation) {
  check_traction_tangent<fem::FaceType::quad4>();
  check_traction_tangent<fem::FaceType::quad8>();
  check_traction_tangent<fem::FaceType::quad9>();
  check_traction_tangent<fem::FaceType::tri3>();
  check_traction_tangent<fem::FaceType::tri6>();
}

TEST(Loads, PressureTangentMatchesAutomaticDifferentiation) {
  check_pressure_tangent<fem::FaceType::quad4>();
  check_pressure_tangent<fem::FaceType::quad8>();
  check_pressure_tangent<fem::FaceType::quad9>();
  check_pressure_tangent<fem::FaceType::tri3>();
  check_pressure_tangent<fem::FaceType::tri6>();
}

// Through the contribution: residual is quadratic in u, so central differences are exact.
TEST(Loads, PressureTangentThroughContribution) {
  std::mt19937 engine(6);
  const mesh::Mesh mesh = one_element(CellType::wedge6, engine); // quads and triangles
  LoadContribution c(mesh, load(LoadKind::pressure, "all"), [](double t) { return 3.0 * t; });
  abut_test::DenseSystem system(mesh.num_local(), 3);
  system.u = test::random_vector(system.u.size(), 0.1, engine);
  system.evaluate(c, true);
  const std::vector<double> k = system.tangent;
  const std::size_t size = system.u.size();
  for (std::size_t q = 0; q < size; ++q) {
    const double at = system.u[q];
    system.u[q] = at + 0.5;
    system.evaluate(c, false);
    const std::vector<double> plus = system.residual;
    system.u[q] = at - 0.5;
    system.evaluate(c, false);
    system.u[q] = at;
    for (std::size_t p = 0; p < size; ++p)
      EXPECT_NEAR(k[p * size + q], plus[p] - system.residual[p], 1e-13);
  }
}

/// f(x, t) = (2 + x y) t: its integral over a cube or a square [-1, 1] is that of the constant, its
/// first moment about the middle is not.
Amount bilinear(int& calls) {
  return {"(2 + x*y)*t", [&calls](const Vec3& x, double t) {
            ++calls;
            return (2.0 + x[0] * x[1]) * t;
          }};
}

// An expression is not ramped by t; a curve multiplies it. Evaluated once for each time.
TEST(Loads, ExpressionsAreIntegratedAtTheirPoints) {
  std::mt19937 engine(3);
  for (const CellType type : {CellType::hex8, CellType::hex20, CellType::hex27})
    for (const LoadKind kind : {LoadKind::traction, LoadKind::body_force}) {
      const mesh::Mesh mesh = one_element(type, engine, 0.0);
      int calls = 0;
      LoadOptions o = load(kind, kind == LoadKind::traction ? "side5" : "body");
      o.vector = {0.0, bilinear(calls), 4.0};
      for (const bool with_curve : {false, true}) {
        LoadContribution c(mesh, o, [&]() -> std::function<double(double)> {
          return with_curve ? [](double t) { return 10.0 * t; } : std::function<double(double)>();
        }());
        const double curve = with_curve ? 5.0 : 1.0, ramp = with_curve ? 5.0 : 0.5;
        abut_test::DenseSystem system(mesh.num_local(), 3);
        system.evaluate(c, true, 0.5);
        double y_force = 0.0, z_force = 0.0, twist = 0.0; // twist: sum of f_y x y, exact for Q1
        for (std::size_t a = 0; a < system.u.size(); a += 3) {
          y_force -= system.residual[a + 1];
          z_force -= system.residual[a + 2];
          twist -= system.residual[a + 1] * mesh.x[a] * mesh.x[a + 1];
        }
        const double measure = kind == LoadKind::traction ? 4.0 : 8.0;
        EXPECT_NEAR(y_force, 2.0 * 0.5 * curve * measure, 1e-13);
        EXPECT_NEAR(z_force, 4.0 * ramp * measure, 1e-13);
        EXPECT_NEAR(twist, 0.5 * curve * measure / 9.0, 1e-13); // int x^2 y^2
        const int before = calls;
        system.u = test::random_vector(system.u.size(), 0.3, engine);
        system.evaluate(c, true, 0.5);
        EXPECT_EQ(calls, before);
        system.evaluate(c, false, 0.75);
        EXPECT_EQ(calls, 2 * before);
        calls = 0;
      }
    }
}

// The pressure is that of the reference position, whatever the displacement.
TEST(Loads, PressureExpressionFollowsTheMaterial) {
  std::mt19937 engine(4);
  const mesh::Mesh mesh = one_element(CellType::hex8, engine, 0.0);
  int calls = 0;
  LoadOptions o = load(LoadKind::pressure, "side5"); // z = 1
  o.pressure = bilinear(calls);
  LoadContribution c(mesh, o, {});
  abut_test::DenseSystem system(mesh.num_local(), 3);
  for (std::size_t i = 0; i < system.u.size(); i += 3)
    system.u[i] = 0.5 * mesh.x[i] + 7.0;
  system.evaluate(c, false, 2.0);
  double force = 0.0, twist = 0.0;
  for (std::size_t a = 0; a < system.u.size(); a += 3) {
    force += system.residual[a + 2];
    twist += system.residual[a + 2] * mesh.x[a] * mesh.x[a + 1];
  }
  EXPECT_NEAR(force, 2.0 * 2.0 * 6.0, 1e-13);
  EXPECT_NEAR(twist, 2.0 * 6.0 / 9.0, 1e-13);
}

TEST(Loads, UnknownPlaceIsADefect) {
  std::mt19937 engine(6);
  const mesh::Mesh mesh = one_element(CellType::hex8, engine);
  for (const LoadKind kind :
       {LoadKind::traction, LoadKind::pressure, LoadKind::body_force, LoadKind::force})
    EXPECT_THROW(LoadContribution(mesh, load(kind, "nowhere"), {}), Defect);
}

} // namespace
