// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/tensor.hpp"
#include "abut/core/window.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace abut::solid {

/// What varies with the load parameter t, and maybe in space: a number, which a curve multiplies
/// (the load parameter itself where none is given), or an expression, which a curve multiplies only
/// where one is given.
struct Amount {
  using Function = std::function<double(const Vec3& position, double t)>;

  double number = 0.0;
  std::string expression; ///< as written; empty for a number
  Function function;      ///< of the reference position; set with an expression

  Amount(double n = 0.0) : number(n) {}
  Amount(std::string text, Function f) : expression(std::move(text)), function(std::move(f)) {}

  /// Value at a reference position; curve may be empty. Throws what the function throws: InputError
  /// where the expression is not finite.
  double at(const Vec3& position, double t, const std::function<double(double)>& curve) const {
    if (function)
      return function(position, t) * (curve ? curve(t) : 1.0);
    return number * (curve ? curve(t) : t);
  }
  friend bool operator==(const Amount& a, const Amount& b) {
    return a.number == b.number && a.expression == b.expression;
  }
};

enum class MaterialModel {
  neo_hookean,            ///< W = G/2 (I1-3) - G ln J + lambda/2 (ln J)^2, finite strain
  linear_elastic,         ///< small strain: sigma = C : sym grad u on the reference configuration
  saint_venant_kirchhoff, ///< second Piola-Kirchhoff stress linear in Green's strain
  holmes_mow,             ///< stiffens exponentially
  mooney_rivlin,          ///< uncoupled: c1 (I1* - 3) + c2 (I2* - 3) + K/2 (ln J)^2
  ogden,                  ///< uncoupled: powers of the isochoric principal stretches
  ogden_unconstrained,    ///< powers of the principal stretches, compressible
};

struct MaterialOptions {
  static constexpr std::size_t max_ogden_terms = 6;

  std::string name;
  MaterialModel model = MaterialModel::neo_hookean;
  double young = 0.0;               ///< [pressure]
  double poisson = 0.0;             ///< -1 < nu < 1/2
  double beta = 0.0;                ///< of holmes_mow, > 0
  double c1 = 0.0, c2 = 0.0;        ///< of mooney_rivlin [pressure]
  double bulk = 0.0;                ///< K of uncoupled models [pressure]
  double lambda = 0.0;              ///< of ogden_unconstrained [pressure]
  std::vector<double> coefficients; ///< c of Ogden's terms [pressure]
  std::vector<double> exponents;    ///< m of Ogden's terms, as many, not zero
  std::optional<double> density;    ///< for dynamics, > 0 [mass/length^3]

  bool has_young() const {
    return model == MaterialModel::neo_hookean || model == MaterialModel::linear_elastic ||
           model == MaterialModel::saint_venant_kirchhoff || model == MaterialModel::holmes_mow;
  }
  bool is_uncoupled() const {
    return model == MaterialModel::mooney_rivlin || model == MaterialModel::ogden;
  }
  bool has_ogden_terms() const {
    return model == MaterialModel::ogden || model == MaterialModel::ogden_unconstrained;
  }
  /// G at small strain; > 0 for a valid material [pressure].
  double shear_modulus() const {
    if (has_young())
      return 0.5 * young / (1.0 + poisson);
    if (model == MaterialModel::mooney_rivlin)
      return 2.0 * (c1 + c2);
    double sum = 0.0;
    for (const double c : coefficients)
      sum += c;
    return 0.5 * sum;
  }
};

/// Components of a rigid body's motion that are prescribed for a part of the run.
struct RigidHold {
  std::string name;
  std::array<bool, 6> components{}; ///< x, y, z, rx, ry, rz
  std::array<double, 6> values{};   ///< [length, rad]
  std::string curve;                ///< empty: the load parameter itself
  Window window;
  bool relative = false; ///< values count from where the body is at the beginning of the window
};

/// Motion of a rigid body: displacement of its center and rotation vector about it, each times a
/// curve, but for the components that are free; and loads on the center, for free components.
struct RigidMotion {
  std::array<double, 3> displacement{};       ///< [length]
  std::array<double, 3> rotation{};           ///< rotation vector [rad]
  std::array<double, 3> center{};             ///< of rotation, reference configuration [length]
  std::string curve;                          ///< empty: the load parameter itself
  std::array<std::string, 6> curves{};        ///< of single components; empty: curve
  std::array<bool, 6> free{};                 ///< components that are unknowns: x, y, z, rx, ry, rz
  std::vector<RigidHold> holds;               ///< of free components
  std::array<double, 3> force{};              ///< on the center [force]
  std::array<double, 3> moment{};             ///< about the center [force length]
  bool follower = false;                      ///< force and moment turn with the body
  std::string load_curve;                     ///< empty: the load parameter itself
  std::array<std::string, 6> load_curves{};   ///< of single components; empty: load_curve
  std::optional<double> density;              ///< of its blocks, for dynamics [mass/length^3]
  std::optional<double> mass;                 ///< at the center, instead of density
  std::array<double, 3> moments_of_inertia{}; ///< xx, yy, zz about the center, beside mass
  std::array<double, 3> products_of_inertia{}; ///< - int x y dm, y z, z x

  bool has_unknowns() const {
    for (const bool f : free)
      if (f)
        return true;
    return false;
  }
};

enum class JointKind {
  revolute,    ///< turns about its axis
  prismatic,   ///< slides along its axis
  cylindrical, ///< does both
  spherical,   ///< turns about its origin
  lock,        ///< neither turns nor slides
  spring,      ///< linear, between a point of each body
};

/// What connects two rigid bodies.
struct JointOptions {
  static constexpr const char* ground = "ground"; ///< what never moves, but for a body of this name

  std::string name;
  JointKind kind = JointKind::revolute;
  std::vector<std::string> bodies;     ///< two names of rigid bodies, or ground
  std::array<double, 3> origin{};      ///< reference configuration [length]
  std::array<double, 3> axis{};        ///< reference configuration, any length but zero
  std::optional<Amount> rotation;      ///< about the axis; free when not given [rad]
  std::optional<Amount> translation;   ///< along the axis; free when not given [length]
  std::string curve;                   ///< of rotation and translation
  std::optional<Amount> moment, force; ///< of the first body on the second, about and along it
  std::string load_curve;              ///< of moment and force
  std::optional<std::array<Amount, 3>>
      rotation_vector;                                ///< of a spherical joint; free without [rad]
  std::optional<std::array<Amount, 3>> moment_vector; ///< of a spherical joint, fixed in space
  std::array<double, 3> from{}, to{}; ///< of a spring: its points on the bodies [length]
  double stiffness = 0.0;             ///< of a spring [force/length]
  std::optional<double> free_length;  ///< of a spring; that of the reference configuration

  bool turns() const { return kind == JointKind::revolute || kind == JointKind::cylindrical; }
  bool slides() const { return kind == JointKind::prismatic || kind == JointKind::cylindrical; }
};

struct BodyOptions {
  std::string name;
  std::vector<std::string> blocks;
  std::vector<std::string> node_sets; ///< a rigid body's, of other bodies' elements too
  std::string material;               ///< empty for a rigid body
  bool rigid = false;
  RigidMotion motion;                       ///< of a rigid body
  std::array<double, 3> initial_velocity{}; ///< for dynamics [length/time]
  std::array<double, 3>
      initial_angular_velocity{}; ///< about its center of mass or center [rad/time]
};

/// Displacement of the nodes of a set. components[i]: whether direction i is prescribed.
struct DisplacementOptions {
  std::string name;
  std::string set; ///< node set, or side set (all its nodes)
  std::array<bool, 3> components{};
  std::array<Amount, 3> values{}; ///< [length]
  std::string curve;
  Window window;         ///< when the nodes are held
  bool relative = false; ///< values count from where the nodes are at the beginning of the window
};

enum class LoadKind {
  traction,   ///< dead force per area of a side set, vector
  pressure,   ///< follower pressure per current area of a side set, positive pushes inwards
  body_force, ///< dead force per reference volume of a block, vector
  force,      ///< dead force on each node of a node set, vector
};

struct LoadOptions {
  std::string name;
  LoadKind kind = LoadKind::traction;
  std::string place; ///< side set, block or node set
  std::array<Amount, 3> vector{};
  bool current_area = false; ///< a traction is per current area, instead of per reference area
  Amount pressure;
  std::string curve;

  /// Whether forces depend on how the surface deforms.
  bool follows_surface() const {
    return kind == LoadKind::pressure || (kind == LoadKind::traction && current_area);
  }
};

} // namespace abut::solid
