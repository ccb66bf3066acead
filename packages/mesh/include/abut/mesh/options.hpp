// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

namespace abut::mesh {

struct PlaneOptions {
  std::array<double, 3> point{};  ///< [length]
  std::array<double, 3> normal{}; ///< of any length but zero
};

/// The curved side of a cylinder without ends.
struct CylinderOptions {
  std::array<double, 3> point{}; ///< on the axis [length]
  std::array<double, 3> axis{};  ///< of any length but zero
  double radius = 0.0;           ///< [length]
};

struct SphereOptions {
  std::array<double, 3> center{}; ///< [length]
  double radius = 0.0;            ///< [length]
};

struct BoxOptions {
  std::array<double, 3> low{}, high{}; ///< corners [length]
};

struct NormalOptions {
  std::array<double, 3> direction{}; ///< of any length but zero
  double angle = 30.0;               ///< largest one with the outward normal [degrees]
};

/// What singles out faces of a mesh: all that is given must hold.
struct FaceSelection {
  std::string node_set; ///< has all corners of a face; empty: any
  std::optional<PlaneOptions> plane;
  std::optional<CylinderOptions> cylinder;
  std::optional<SphereOptions> sphere;
  std::optional<BoxOptions> box;
  std::optional<NormalOptions> normal;
  std::optional<double> within; ///< distance of nodes that counts as none [length]; none: a
                                ///< twentieth of the face's shortest edge

  bool is_empty() const {
    return node_set.empty() && !plane && !cylinder && !sphere && !box && !normal;
  }
};

} // namespace abut::mesh
