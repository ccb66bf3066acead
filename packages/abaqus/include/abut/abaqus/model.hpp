// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/core/types.hpp"
#include "abut/fem/cell.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// A model of Abaqus or CalculiX as plain data, in the words and units of its file. Nodes and
/// elements are named by their index here; parts are placed where their instances are.
namespace abut::abaqus {

/// Where an item stands: in the file itself (0) or one that it includes.
struct Place {
  int file = 0;
  long long line = 0;
};

/// What abut makes of an element.
struct ElementType {
  const char* name;                  ///< C3D8R
  int nodes;                         ///< 0: refused
  std::optional<fem::CellType> cell; ///< none: a rigid facet
  const int* order;                  ///< (nodes) place of each node of Exodus II; null: the same
  const char* element;               ///< word of the deck for bodies; null: its default
  const char* note;                  ///< what is not the same, or why it is refused; may be null

  bool is_facet() const { return nodes > 0 && !cell; }
};

struct Node {
  Global label = 0;
  Place place;
  std::array<double, 3> x{};
};

struct Element {
  Global label = 0;
  Place place;
  const ElementType* type = nullptr;
  std::size_t first = 0; ///< of its nodes in Model::element_nodes, in the order of the file
};

/// Node or element set.
struct Set {
  std::string name; ///< as spelled
  Place place;
  std::vector<int> members; ///< in the order of the file, each once
};

/// A face of a solid (0, 1, ... for S1, S2, ...), all its faces that no other element has, or a
/// side of a rigid facet.
struct Face {
  static constexpr int positive = -1, negative = -2, outer = -3;
  int element = 0;
  int face = 0;
};

struct Surface {
  std::string name;
  Place place;
  bool of_nodes = false;
  std::vector<Face> faces;
  std::vector<int> nodes; ///< where it is of nodes
};

/// Isotropic.
struct Elastic {
  double young = 0.0, poisson = 0.0;
};

/// Terms of a strain energy in the sense of abut's laws mooney_rivlin or ogden.
struct Hyperelastic {
  Place place;
  bool is_ogden = false;
  std::vector<double> coefficients; ///< mooney_rivlin: c1, c2; ogden: c of each term
  std::vector<double> exponents;    ///< of ogden
  double compressibility = 0.0;     ///< D1 [1/pressure]; 0: incompressible

  double shear() const; ///< modulus without strain
};

struct Material {
  std::string name;
  Place place;
  std::optional<Elastic> elastic;
  std::optional<Hyperelastic> hyperelastic;
  double density = 0.0;
  bool expands = false; ///< with temperature
};

/// *SOLID SECTION.
struct Section {
  std::string set, material;
  Place place;
  std::vector<int> elements;
};

/// *RIGID BODY, or a *COUPLING that is one.
struct RigidBody {
  std::string name;
  Place place;
  std::vector<int> elements, nodes; ///< nodes: those tied beside the elements'
  int reference = -1;               ///< node whose components 1 to 6 move it
  int rotation = -1;                ///< CalculiX: node whose components 1 to 3 turn it
};

struct Amplitude {
  std::string name;
  Place place;
  bool total_time = false;
  std::vector<std::array<double, 2>> points; ///< (time, factor), time growing

  double operator()(double t) const; ///< linear, constant beyond the ends
  bool is_constant() const;
};

/// A line of *BOUNDARY or *CLOAD.
struct Condition {
  Place place;
  int step = -1; ///< in which it begins; -1: before all
  std::string set;
  std::vector<int> nodes;
  int first = 1, last = 1; ///< components
  double value = 0.0;
  std::string amplitude;
  bool stays = false; ///< FIXED: where the nodes are
};

/// A line of *DLOAD or *DSLOAD.
struct Load {
  enum class Kind { pressure, traction, gravity, body_force };
  Kind kind = Kind::pressure;
  Place place;
  int step = 0;
  bool on_surface = false; ///< *DSLOAD
  std::string name;        ///< of the set or surface
  std::string label;       ///< P1 to P6 of a pressure on elements
  std::vector<Face> faces; ///< of a pressure or traction
  std::vector<int> elements;
  std::array<double, 3> direction{}; ///< of length one, but for a pressure
  double value = 0.0;
  std::string amplitude;
};

/// That all earlier conditions of a kind end with a step: OP=NEW.
struct Renewal {
  enum class Kind { boundary, nodal, element, surface };
  Kind kind = Kind::boundary;
  int step = 0;
};

/// *INITIAL CONDITIONS, TYPE=VELOCITY.
struct InitialVelocity {
  Place place;
  std::vector<int> nodes;
  int component = 0;
  double value = 0.0;
};

/// *SURFACE INTERACTION with what stands below it.
struct Interaction {
  enum class Normal { hard, linear, tied };
  std::string name;
  Place place;
  Normal normal = Normal::hard;
  double stiffness = 0.0;     ///< of linear and tied [pressure/length]
  double clearance = 0.0;     ///< at which the pressure of linear begins
  bool no_separation = false; ///< what touches once, may pull
  double friction = 0.0;
  double stick_slope = 0.0; ///< CalculiX [pressure/length]; 0: not given
};

/// *CONTACT PAIR or *TIE.
struct Pair {
  std::string name;
  Place place;
  std::string first, second; ///< surfaces; the first has the nodes or points
  std::string interaction;
  bool nodal = false, tied = false, mortar = false;
  bool keeps_gap = true;           ///< of a tie
  std::optional<double> tolerance; ///< distance within which it ties
  std::optional<double> adjust;    ///< distance within which gaps are closed without strain
  std::optional<double> clearance; ///< given instead of what the meshes have
  std::vector<bool> is_off;        ///< (steps) by *MODEL CHANGE
};

/// *CHANGE FRICTION.
struct FrictionChange {
  Place place;
  int step = 0;
  std::string interaction;
  double friction = 0.0;
};

struct Step {
  Place place;
  bool finite = false;  ///< NLGEOM
  bool at_once = false; ///< conditions without an amplitude do not ramp
  bool dynamic = false;
  bool direct = false;                  ///< the increment stays
  double period = 1.0, increment = 1.0; ///< increment: the first, or the largest if that is less
  double alpha = -0.05;                 ///< of the rule in time
};

struct Model {
  std::vector<std::string> files;
  std::string title;
  std::vector<Node> nodes;
  std::vector<Element> elements;
  std::vector<int> element_nodes;
  std::map<std::string, Set> node_sets, element_sets; ///< by key_of(name)
  std::map<std::string, Surface> surfaces;
  std::map<std::string, Material> materials;
  std::map<std::string, Amplitude> amplitudes;
  std::map<std::string, Interaction> interactions;
  std::vector<Section> sections;
  std::vector<RigidBody> rigid_bodies;
  std::vector<Pair> pairs;
  std::vector<FrictionChange> friction_changes;
  std::vector<Condition> boundaries, forces;
  std::vector<Load> loads;
  std::vector<Renewal> renewals;
  std::vector<InitialVelocity> initial_velocities;
  std::vector<Step> steps;

  const int* nodes_of(const Element& e) const { return element_nodes.data() + e.first; }
  /// Total time at which a step begins; that after the last one is the end.
  double start(std::size_t step) const;
  double end() const { return start(steps.size()); }
  bool is_dynamic() const { return !steps.empty() && steps[0].dynamic; }
  bool is_finite() const { return !steps.empty() && steps.back().finite; }
  /// "FILE:LINE" to begin a message.
  std::string where(const Place& place) const;
};

/// A name as it is compared: blanks and quotes taken out, in capitals.
std::string key_of(const std::string& name);

} // namespace abut::abaqus
