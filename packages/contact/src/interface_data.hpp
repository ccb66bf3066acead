// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/augmentation.hpp"
#include "history/point_arrays.hpp"
#include "kinematics/configuration.hpp"
#include "law/point_terms.hpp"
#include "spaces/nodal_space.hpp"

#include <memory>

namespace abut::contact {

/// What the rooms of an interface share: settings, surfaces, points and, where the law holds at
/// nodes, the nodal space.
struct InterfaceData {
  /// Throws InputError for a surface without faces. Collective.
  InterfaceData(const Comm& comm, mesh::Surface primary, mesh::Surface secondary,
                const ContactOptions& options, double share);

  Comm comm;
  SideComparison sides;
  Settings settings;
  double factor; ///< f of the automatic penalty; the end of the first step in contact may change it
  Configuration place;
  CornerSpace corners;
  PointArrays points;
  std::unique_ptr<NodalSpace> nodal; ///< null: the points hold the law
  PointTerms terms;                  ///< of the last evaluation
  std::vector<char> held;            ///< (surface nodes) prescribed along the normal; may be empty
  bool acts = true;                  ///< the last evaluation lay in the window

  const PrimaryView& primary() const { return place.points(); }
  const FacingView& facing() const { return place.facing(); }
  const mesh::Surface& surface() const { return place.primary().surface(); }
  /// A number of the point that all ranks know.
  Global point_key(Local point) const {
    constexpr Global most_points = 64; // more than a face has
    const Local face = primary().face(point);
    return surface().face_id[std::size_t(face)] * most_points + point - primary().first_point(face);
  }
  /// Area of the point in the measure of the tractions [length^2].
  double measure(Local point) const {
    return settings.ray() ? primary().current_area(point) : primary().area(point);
  }
};

/// A nodal space with nothing in its memory, null where points hold the law. Collective.
std::unique_ptr<NodalSpace> make_nodal_space(const InterfaceData& data);

} // namespace abut::contact
