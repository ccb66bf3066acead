// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/scene/options.hpp"
#include "rule.hpp"

#include <optional>

namespace abut::deck {

template <class V> void describe(V& v, mesh::PlaneOptions& o) {
  v.required("point", o.point, "on the plane", unit("length"));
  v.required("normal", o.normal, "its length does not matter");
}

template <class V> void describe(V& v, mesh::CylinderOptions& o) {
  v.required("point", o.point, "on the axis", unit("length"));
  v.required("axis", o.axis, "its length does not matter");
  v.required("radius", o.radius, "of the cylinder", positive("length"));
}

template <class V> void describe(V& v, mesh::SphereOptions& o) {
  v.required("center", o.center, "of the sphere", unit("length"));
  v.required("radius", o.radius, "of the sphere", positive("length"));
}

template <class V> void describe(V& v, mesh::BoxOptions& o) {
  v.required("low", o.low, "corner of least x, y and z", unit("length"));
  v.required("high", o.high, "corner of largest x, y and z", unit("length"));
}

template <class V> void describe(V& v, mesh::NormalOptions& o) {
  v.required("direction", o.direction, "out of the body; its length does not matter");
  v.optional("angle", o.angle, "largest one between the normal and the direction",
             Rule{0.0, 180.0, false, "degrees", ""});
}

template <class V, class Shape>
void describe_shape(V& v, const char* key, std::optional<Shape>& o, const char* doc) {
  bool given = o.has_value();
  Shape shape = o.value_or(Shape());
  v.optional_group(key, given, doc, [&](auto& w) { describe(w, shape); });
  if (given)
    o = shape;
}

template <class V> void describe(V& v, scene::SurfaceOptions& o) {
  v.optional("blocks", o.blocks, "outer faces of these element blocks, by name or number");
  v.optional("body", o.body, "outer faces of this body");
  v.optional("part_of", o.part_of, "faces of this side set or surface, instead of outer ones");
  v.optional("node_set", o.selection.node_set, "faces that have all corners in this node set");
  describe_shape(v, "plane", o.selection.plane, "faces near a plane");
  describe_shape(v, "cylinder", o.selection.cylinder,
                 "faces near the curved side of a cylinder without ends");
  describe_shape(v, "sphere", o.selection.sphere, "faces near a sphere");
  describe_shape(v, "box", o.selection.box, "faces in a box with edges along x, y and z");
  describe_shape(v, "normal", o.selection.normal, "faces that look in a direction");
  v.optional("within", o.selection.within,
             "how far nodes may be from plane, cylinder, sphere and box; without it a twentieth of "
             "the face's shortest edge",
             positive("length"));
  v.optional("join", o.join, "side sets or surfaces that are added to what the other keys leave");
  v.optional("subtract", o.subtract,
             "side sets or surfaces that are taken away, of joined ones too");
  v.at_least_one({"blocks", "body", "part_of", "node_set", "plane", "cylinder", "sphere", "box",
                  "normal", "join", "subtract"});
}

} // namespace abut::deck
