// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/compressible_laws.hpp"
#include "abut/solid/ogden_laws.hpp"
#include "abut/solid/options.hpp"
#include "abut/solid/uncoupled_laws.hpp"

#include <variant>

/// Materials: stress and tangent at a point, on any scalar T (double or an AD type).
///
/// A material is a struct with
///   static constexpr bool finite_strain, uncoupled;
///   T energy(const Deformation<T>&) const;               per reference volume [pressure]
///   Mat<T,3> stress(const Deformation<T>&) const;        Kirchhoff stress J sigma if
///   finite_strain,
///                                                        else the small-strain stress
///   void tangent(const Deformation<double>&, Mat3& stress, double c[6][6]) const;
/// c relates the Lie derivative of the Kirchhoff stress to the rate of deformation (finite strain)
/// or stress to strain (small strain); Voigt order xx, yy, zz, xy, yz, xz with engineering shears.
/// An uncoupled one inherits these from `Uncoupled` and gives its isochoric part.
/// A new material needs these members, a place in `Material` and in make_material, nothing else.
namespace abut::solid {

using Material = std::variant<NeoHookean, LinearElastic, SaintVenantKirchhoff, HolmesMow,
                              MooneyRivlin, Ogden, OgdenUnconstrained>;

/// Options must be valid, as the deck's rules say (else Defect).
Material make_material(const MaterialOptions& options);

struct LameConstants {
  double shear, lambda; ///< [pressure]
};

/// Of the undeformed state; all laws are isotropic.
LameConstants at_rest(const Material& material);

/// Young's modulus along the unit vector n in the undeformed state: 1 / (n x n : C^-1 : n x n).
double modulus_along(const Material& material, const Vec3& n);

} // namespace abut::solid
