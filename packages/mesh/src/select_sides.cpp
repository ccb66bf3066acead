// SPDX-License-Identifier: BSD-3-Clause
#include "abut/mesh/select_sides.hpp"

#include "abut/core/error.hpp"
#include "abut/core/tensor.hpp"
#include "abut/mesh/sides.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <unordered_set>

namespace abut::mesh {

namespace {

using Distance = std::function<double(const Vec3&)>;

constexpr double near_share = 0.05; ///< of the shortest edge

Vec3 vector(const std::array<double, 3>& v) {
  return {{v[0], v[1], v[2]}};
}

/// Of a direction that is not zero, of any length that a number can have.
Vec3 unit(const std::array<double, 3>& v) {
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  const Vec3 scaled{{v[0] / largest, v[1] / largest, v[2] / largest}};
  return 1.0 / norm(scaled) * scaled;
}

int corners_of(const MeshData& mesh, const SideData& side) {
  return fem::face_corners(cell_side(mesh, side).type);
}

double shortest_edge(const std::vector<Vec3>& x, int corners) {
  double least = std::numeric_limits<double>::infinity();
  for (int a = 0; a < corners; ++a)
    least = std::min(least, norm(x[std::size_t((a + 1) % corners)] - x[std::size_t(a)]));
  return least;
}

Vec3 mean_normal(const std::vector<Vec3>& x, int corners) {
  const Vec3 n = corners == 3 ? cross(x[1] - x[0], x[2] - x[0]) : cross(x[2] - x[0], x[3] - x[1]);
  const double length = norm(n);
  return length > 0.0 ? 1.0 / length * n : n;
}

Distance distance_to(const PlaneOptions& o) {
  return [point = vector(o.point), normal = unit(o.normal)](const Vec3& x) {
    return std::abs(dot(x - point, normal));
  };
}

Distance distance_to(const CylinderOptions& o) {
  return [point = vector(o.point), axis = unit(o.axis), r = o.radius](const Vec3& x) {
    return std::abs(norm(cross(x - point, axis)) - r);
  };
}

Distance distance_to(const SphereOptions& o) {
  return [center = vector(o.center), r = o.radius](const Vec3& x) {
    return std::abs(norm(x - center) - r);
  };
}

Distance distance_to(const BoxOptions& o) {
  return [low = vector(o.low), high = vector(o.high)](const Vec3& x) {
    Vec3 out;
    for (int i = 0; i < 3; ++i)
      out[i] = std::max({low[i] - x[i], x[i] - high[i], 0.0});
    return norm(out);
  };
}

/// Narrows sides criterion by criterion and tells how.
class Selector {
public:
  Selector(const MeshData& mesh, std::vector<SideData> sides, std::optional<double> within)
      : mesh_(mesh), within_(within), result_{std::move(sides), ""} {}

  void keep(const std::string& words, const std::function<bool(const SideData&)>& holds) {
    std::vector<SideData>& sides = result_.sides;
    sides.erase(std::remove_if(sides.begin(), sides.end(),
                               [&](const SideData& side) { return !holds(side); }),
                sides.end());
    result_.story += ", " + std::to_string(sides.size()) + " " + words;
  }

  template <class Shape> void near_shape(const std::optional<Shape>& shape, const char* words) {
    if (!shape)
      return;
    const bool had_some = !result_.sides.empty();
    double least = std::numeric_limits<double>::infinity();
    const Distance distance = distance_to(*shape);
    keep(words, [&](const SideData& side) {
      const std::vector<Vec3> x = side_points(mesh_, side);
      double farthest = 0.0;
      for (const Vec3& point : x)
        farthest = std::max(farthest, distance(point));
      least = std::min(least, farthest);
      return farthest <= within_.value_or(near_share * shortest_edge(x, corners_of(mesh_, side)));
    });
    if (!had_some || !result_.sides.empty())
      return;
    std::ostringstream hint;
    hint << " (the nearest face keeps within " << least << " of it)";
    result_.story += hint.str();
  }

  SelectedSides take() { return std::move(result_); }

private:
  const MeshData& mesh_;
  std::optional<double> within_;
  SelectedSides result_;
};

} // namespace

SelectedSides select_sides(const MeshData& mesh, std::vector<SideData> sides,
                           const FaceSelection& selection) {
  Selector selector(mesh, std::move(sides), selection.within);
  if (!selection.node_set.empty()) {
    const auto set = mesh.node_sets.find(selection.node_set);
    ABUT_REQUIRE(set != mesh.node_sets.end(), "no node set '" + selection.node_set + "'");
    const std::unordered_set<Global> nodes(set->second.begin(), set->second.end());
    selector.keep("with all corners in the node set", [&](const SideData& side) {
      const std::vector<Global> all = side_nodes(mesh, side);
      return std::all_of(all.begin(), all.begin() + corners_of(mesh, side),
                         [&](Global n) { return nodes.count(n) > 0; });
    });
  }
  selector.near_shape(selection.plane, "near the plane");
  selector.near_shape(selection.cylinder, "near the cylinder");
  selector.near_shape(selection.sphere, "near the sphere");
  selector.near_shape(selection.box, "in the box");
  if (selection.normal) {
    const Vec3 direction = unit(selection.normal->direction);
    constexpr double degree = 0.017453292519943295, rounding = 1e-12;
    const double least = std::cos(selection.normal->angle * degree) - rounding;
    selector.keep("with the normal", [&](const SideData& side) {
      return dot(mean_normal(side_points(mesh, side), corners_of(mesh, side)), direction) >= least;
    });
  }
  return selector.take();
}

} // namespace abut::mesh
