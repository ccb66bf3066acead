// SPDX-License-Identifier: BSD-3-Clause
#include "interface_data.hpp"

#include "abut/contact/option_error.hpp"

namespace abut::contact {

namespace {

/// Refuses a surface without faces, then compares.
SideComparison compared(const Comm& comm, const mesh::Surface& primary,
                        const mesh::Surface& secondary, const std::string& name) {
  for (const mesh::Surface* s : {&primary, &secondary})
    if (comm.sum(Global(s->num_faces())) == 0)
      throw OptionError("contact." + name, "surface '" + s->name + "' has no faces");
  return compare_sides(comm, primary, secondary);
}

double soft_modulus(const Settings& settings) {
  return settings.friction_switching == FrictionSwitching::primal_dual
             ? soft_switching * settings.modulus
             : 0.0;
}

/// What of the terms does not depend on time.
PointTerms terms_of(const Settings& o, double share) {
  PointTerms t;
  t.law.literal = o.friction_map == FrictionMap::literal;
  t.ray = o.ray();
  t.at_nodes = o.nodal_law();
  t.anchors = o.anchors();
  t.inclined = o.friction_map == FrictionMap::inclined_ray;
  t.tied = o.tied;
  t.sticky = o.sticky;
  t.tension = o.tension;
  t.soft_modulus = soft_modulus(o);
  t.offset = o.offset;
  t.rise = o.initial_gap == InitialGap::round ? 1.0 : 0.0;
  t.stick_within = o.stick_within;
  t.reach = o.reach;
  t.share = share;
  return t;
}

} // namespace

InterfaceData::InterfaceData(const Comm& c, mesh::Surface primary, mesh::Surface secondary,
                             const ContactOptions& options, double share)
    : comm(c), sides(compared(c, primary, secondary, options.name)),
      settings(resolve(options, sides)), factor(settings.penalty_factor),
      place(c, std::move(primary), std::move(secondary), settings, sides.face_size),
      corners(c, place.primary().surface()), points(make_point_arrays(place.points().points())),
      terms(terms_of(settings, share)) {
  nodal = make_nodal_space(*this);
}

std::unique_ptr<NodalSpace> make_nodal_space(const InterfaceData& data) {
  if (!data.settings.nodal_law())
    return nullptr;
  auto space = std::make_unique<NodalSpace>(data.comm, data.corners, data.primary(),
                                            data.settings.weighted_gap, soft_modulus(data.settings),
                                            data.settings.friction > 0.0);
  if (data.settings.formulation != Formulation::node_on_facet) // there each node is a point
    space->set_prescribed(data.held);
  return space;
}

} // namespace abut::contact
