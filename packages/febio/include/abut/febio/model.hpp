// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/core/types.hpp"
#include "abut/core/window.hpp"
#include "abut/fem/cell.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// A FEBio model, as specification 4.0 has it, as plain data, in the words and units of its file.
/// `line` is where an item stands in the file.
namespace abut::febio {

/// A number, times a load curve where one is named.
struct Value {
  double number = 0.0;
  int curve = 0; ///< id of a load controller; 0: none, the number holds at all times
  int line = 0;

  bool is_zero() const { return number == 0.0; }
  friend bool operator==(const Value& a, const Value& b) {
    return a.number == b.number && a.curve == b.curve;
  }
};

struct Material {
  std::string name, type;
  std::string id; ///< by which a rigid body may be called too
  int line = 0;
  std::map<std::string, double> numbers; ///< E, v, c1, ... as named in the file, defaults put in
  std::optional<Vec3> center_of_mass;    ///< of a rigid body

  bool is_rigid() const { return type == "rigid body"; }
  /// Also the neo-Hookean one that is uncoupled, which is that without c2.
  bool is_mooney_rivlin() const { return type == "Mooney-Rivlin" || type == "incomp neo-Hookean"; }
};

/// An <Elements> section: a domain of one material.
struct Domain {
  std::string name;
  int line = 0;
  fem::CellType cell = fem::CellType::hex8;
  std::vector<Global> id;    ///< (elements)
  std::vector<int> lines;    ///< (elements)
  std::vector<Global> nodes; ///< (elements, nodes per cell) node ids in the order of Exodus II
  std::string material;      ///< from MeshDomains
  bool is_shell = false;     ///< in the file, and rigid; the last half of the nodes are the shell's
  double thickness = 0.0;    ///< of a shell [length]
};

struct NodeSet {
  std::string name;
  int line = 0;
  std::vector<Global> nodes; ///< ids
};

struct Facet {
  int line = 0;
  std::vector<Global> nodes; ///< ids of the corners, then of the others
  std::size_t corners = 0;
};

struct Surface {
  std::string name;
  int line = 0;
  std::vector<Facet> facets;
};

struct SurfacePair {
  std::string name, primary, secondary;
  int line = 0;
};

struct ElementSet {
  std::string name;
  std::vector<Global> elements; ///< ids
};

struct Mesh {
  int line = 0;
  std::vector<Global> node_id;
  std::vector<double> x; ///< (nodes, 3)
  std::vector<Domain> domains;
  std::vector<NodeSet> node_sets;
  std::vector<Surface> surfaces;
  std::vector<SurfacePair> pairs;
  std::vector<ElementSet> element_sets;
};

/// Zero or prescribed displacement of a node set.
struct Displacement {
  std::string name, place; ///< place: a node set, "@surface:NAME", ...
  int line = 0;
  int step = -1; ///< in which alone it holds; -1: in all
  std::array<bool, 3> components{};
  Value value;
  bool relative = false; ///< to where the nodes are when the step begins; false in the first one
};

/// Nodes that move with a rigid body.
struct RigidTie {
  std::string name, place, body; ///< body: a material's name
  int line = 0;
  int step = -1; ///< as above
};

/// Components in the order x, y, z, rotations about them.
struct RigidCondition {
  std::string name, body;
  int line = 0;
  int step = -1;
  std::array<bool, 6> components{};
  Value value;           ///< zero for fixed ones
  bool fixed = false;    ///< a prescribed one wins over it
  bool relative = false; ///< as above; what is fixed stays where it is
};

struct RigidLoad {
  std::string name, body;
  int line = 0;
  int step = -1;
  int component = 0; ///< as above: force, then moment
  Value value;
  bool follower = false; ///< turns with the body
};

/// A <rigid_connector>: body b against body a.
struct RigidConnector {
  enum class Kind { revolute, prismatic, cylindrical, spherical, lock, spring };
  Kind kind = Kind::revolute;
  std::string name;
  std::array<std::string, 2> bodies; ///< materials' names
  int line = 0;
  int step = -1;
  Vec3 origin = Vec3::zero(); ///< a spring's point on body a
  Vec3 axis = Vec3::zero();   ///< a spring's point on body b
  std::optional<Value> rotation, translation;
  Value moment, force; ///< on body a about and along the axis, minus it on b
  /// Of a spherical joint: rotation vector of b against a, moment on a, minus it on b.
  std::optional<std::array<Value, 3>> rotation_vector;
  std::array<Value, 3> moment_vector{};
  double stiffness = 0.0, free_length = 0.0; ///< of a spring; free length 0: as it is
};

struct Load {
  enum class Kind { pressure, traction, nodal, body_force };
  Kind kind = Kind::pressure;
  std::string name, place; ///< surface, node set; a body force's domain, or nothing for all
  int line = 0;
  int step = -1;
  std::array<Value, 3> vector{}; ///< pressure in the first
  bool current_area = false;     ///< of a traction
};

struct Contact {
  std::string name, type, pair;
  int line = 0;
  int step = -1;
  std::map<std::string, Value> values; ///< penalty, tolerance, ... with FEBio's defaults put in

  double number(const char* key) const { return values.at(key).number; }
  bool flag(const char* key) const { return number(key) != 0.0; }
  bool is_sticky() const { return type == "sticky"; }
  bool is_tied() const { return type.compare(0, 5, "tied-") == 0; }
};

enum class Interpolation { linear, step, smooth };
enum class Extension { constant, extrapolate, repeat, repeat_offset };

struct LoadCurve {
  std::string name;
  int line = 0;
  Interpolation interpolation = Interpolation::linear;
  Extension extension = Extension::constant;
  std::vector<std::array<double, 2>> points; ///< (t, value)

  /// Value at t as FEBio has it: step takes the value of the next point, smooth blends the
  /// parabolas through neighbouring points.
  double operator()(double t) const;
};

/// Points (t, value), t growing, of a load curve from 0 to end: linear between them and constant
/// beyond. Jumps take 1e-9 of the time, parabolas sixteen pieces.
std::vector<std::array<double, 2>> deck_points(const LoadCurve& curve, double end);

/// Velocity at the start, of nodes or of a rigid body.
struct InitialVelocity {
  std::string name, place, body; ///< a node set; or a material's name
  int line = 0;
  bool turns = false; ///< an angular velocity, of a body
  std::array<double, 3> value{};
};

/// How FEBio goes on in time where bodies have inertia. See read_control.
struct Inertia {
  bool active = false;        ///< analysis DYNAMIC
  double spectral_radius = 1; ///< of generalised alpha
  double beta = 0.25, gamma = 0.5;

  friend bool operator==(const Inertia& a, const Inertia& b) {
    return a.active == b.active && a.spectral_radius == b.spectral_radius && a.beta == b.beta &&
           a.gamma == b.gamma;
  }
};

/// A part of the time, from the <Control> that stands outside of steps or from one step.
struct Step {
  int line = 0;
  int count = 10;
  double size = 0.1;                                             ///< [time]
  int must_points_curve = 0;                                     ///< id; its points must be hit
  double displacement_tolerance = 1e-3, energy_tolerance = 1e-2; ///< dtol, etol [1]
  Inertia inertia;
};

/// What a number does in each step; one value when it is the same in all.
using Course = std::vector<Value>;

struct Model {
  std::string file;
  Mesh mesh;
  std::vector<Material> materials;
  std::vector<Displacement> displacements;
  std::vector<RigidTie> ties;
  std::vector<RigidCondition> rigid_conditions;
  std::vector<RigidLoad> rigid_loads;
  std::vector<RigidConnector> connectors;
  std::vector<Load> loads;
  std::vector<Contact> contacts;
  std::vector<InitialVelocity> initial_velocities;
  std::map<int, LoadCurve> curves; ///< by id
  std::vector<Step> steps;         ///< one after the other

  /// Time at which a step begins; that after the last one is the end.
  double start(std::size_t step) const;
  double end() const { return start(steps.size()); }
  /// The time of steps first to last.
  Window window(std::size_t first, std::size_t last) const {
    Window window{start(first), {}};
    if (last + 1 < steps.size())
      window.until = start(last + 1);
    return window;
  }
  /// Whether bodies have inertia: the same in all steps.
  bool is_dynamic() const { return !steps.empty() && steps[0].inertia.active; }
  /// The course of a value that holds in this step alone and else is zero; -1: in all.
  Course course(const Value& value, int step) const;
  /// "FILE:LINE" to begin a message.
  std::string where(int line) const { return file + ":" + std::to_string(line); }
  const Material* material(const std::string& name) const;
};

} // namespace abut::febio
