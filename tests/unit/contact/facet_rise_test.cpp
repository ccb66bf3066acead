// SPDX-License-Identifier: BSD-3-Clause
// Rise of round surfaces over the faces that stand for them: the sagitta, wherever the surface goes
// on, and nothing where it is plane or has corners.
#include "abut_test/surfaces.hpp"
#include "kinematics/facet_rise.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <mpi.h>

using namespace abut;
using namespace abut::contact;
using abut_test::grid_surface;

namespace {

std::vector<double> rises(const mesh::Surface& s) {
  return facet_rises(Comm(MPI_COMM_WORLD), s);
}

/// A strip of nx x ny faces along x and y, bent about y to the angle phi between faces, radius 1.
mesh::Surface arc(int nx, int ny, double phi, bool flip) {
  return grid_surface(nx, ny, 0.0, nx * phi, 0.0, 1.0, flip, 0, [](double* x) {
    const double a = x[0];
    x[0] = std::sin(a);
    x[2] = std::cos(a);
  });
}

} // namespace

TEST(FacetRise, IsTheSagittaOfAnArc) {
  for (const int layers : {1, 3})
    for (const double phi : {0.02, 0.1, 0.4})
      for (const bool hollow : {false, true}) {
        const std::vector<double> r = rises(arc(4, layers, phi, hollow));
        const double sagitta = 1.0 - std::cos(0.5 * phi);
        for (std::size_t f = 0; f < r.size() / 2; ++f) { // faces at the ends too
          const double along = std::max(r[2 * f], r[2 * f + 1]) + std::min(r[2 * f], r[2 * f + 1]);
          EXPECT_NEAR(along, hollow ? -sagitta : sagitta, 0.02 * sagitta);
          EXPECT_EQ(r[2 * f] * r[2 * f + 1], 0.0); // along y nothing bends
        }
      }
}

TEST(FacetRise, IsTheSagittaOfABall) {
  const double h = 0.05; // half a face, radius 2
  const std::vector<double> r =
      rises(grid_surface(6, 6, -6 * h, 6 * h, -6 * h, 6 * h, false, 0,
                         [](double* x) { x[2] = std::sqrt(4.0 - x[0] * x[0] - x[1] * x[1]); }));
  for (const double rise : r)
    EXPECT_NEAR(rise, h * h / 4.0, 0.05 * h * h / 4.0);
  const double middle[2] = {0.0, 0.0}, edge[2] = {1.0, 0.0}, corner[2] = {1.0, -1.0};
  EXPECT_NEAR(rise_at(&r[30], middle), h * h / 2.0, 0.05 * h * h);
  EXPECT_NEAR(rise_at(&r[30], edge), h * h / 4.0, 0.05 * h * h);
  EXPECT_EQ(rise_at(&r[30], corner), 0.0);
}

TEST(FacetRise, IsNothingOnPlanesRoofsWavesAndCorners) {
  const auto folded = [](double slope) {
    return grid_surface(4, 2, -1.0, 1.0, 0.0, 1.0, false, 0,
                        [=](double* x) { x[2] = -slope * std::fabs(x[0]); });
  };
  const mesh::Surface zigzag = grid_surface(
      6, 2, 0.0, 6.0, 0.0, 1.0, false, 0, [](double* x) { x[2] = 0.1 * (std::lround(x[0]) % 2); });
  for (const mesh::Surface& s : {folded(0.0), folded(0.1), folded(2.0)})
    for (const double rise : rises(s))
      EXPECT_NEAR(rise, 0.0, 1e-15);
  const std::vector<double> r = rises(zigzag);
  for (const std::size_t f : {1, 2, 3, 4, 7, 8, 9, 10}) // at the ends only one edge says something
    EXPECT_NEAR(std::fabs(r[2 * f]) + std::fabs(r[2 * f + 1]), 0.0, 1e-15);
}

TEST(FacetRise, IsNothingOnQuadraticFaces) {
  mesh::Surface s = arc(4, 2, 0.1, false);
  std::fill(s.type.begin(), s.type.end(), fem::FaceType::quad8);
  for (const double rise : rises(s))
    EXPECT_EQ(rise, 0.0);
}
