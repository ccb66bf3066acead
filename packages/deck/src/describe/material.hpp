// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/solid/options.hpp"
#include "rule.hpp"

#include <algorithm>
#include <string>

namespace abut::deck {

template <class V> void describe(V& v, solid::MaterialOptions& o) {
  using solid::MaterialModel;
  v.choice("model", o.model,
           {{"neo_hookean", MaterialModel::neo_hookean, "compressible, finite strain"},
            {"linear_elastic", MaterialModel::linear_elastic, "small strain"},
            {"saint_venant_kirchhoff", MaterialModel::saint_venant_kirchhoff,
             "large rotations, moderate strain; weak in compression"},
            {"holmes_mow", MaterialModel::holmes_mow, "stiffens exponentially"},
            {"mooney_rivlin", MaterialModel::mooney_rivlin, "rubber; hex8 does not lock"},
            {"ogden", MaterialModel::ogden, "rubber, powers of stretches; hex8 does not lock"},
            {"ogden_unconstrained", MaterialModel::ogden_unconstrained,
             "powers of stretches, compressible"}},
           "stress-strain law");
  v.when(o.has_young(), "neo_hookean, linear_elastic, saint_venant_kirchhoff, holmes_mow", [&] {
    v.required("young", o.young, "Young's modulus", positive("pressure"));
    Rule poisson{-1.0, 0.5, true, "1",
                 "at 0.5 the material is incompressible and its bulk modulus infinite, at -1 its "
                 "shear modulus is: come close to a limit, 0.49 say, but do not reach it"};
    v.required("poisson", o.poisson, "Poisson's ratio", poisson);
  });
  v.when(o.model == MaterialModel::holmes_mow, "holmes_mow",
         [&] { v.required("beta", o.beta, "how fast it stiffens", positive("1")); });
  v.when(o.model == MaterialModel::mooney_rivlin, "mooney_rivlin", [&] {
    v.required("c1", o.c1, "of I1 - 3; G = 2 (c1 + c2)", unit("pressure"));
    v.optional("c2", o.c2, "of I2 - 3", unit("pressure"));
    v.check("c1", o.c1 + o.c2 > 0.0, "expected c1 + c2 > 0, which is half the shear modulus");
  });
  v.when(o.has_ogden_terms(), "ogden, ogden_unconstrained", [&] {
    v.required("coefficients", o.coefficients, "c of the terms c/m^2 (l^m - 1); 2 G is their sum",
               unit("pressure"));
    v.required("exponents", o.exponents, "m of the terms, as many and not zero", unit("1"));
    v.check("coefficients", o.coefficients.size() <= o.max_ogden_terms,
            "expected at most " + std::to_string(o.max_ogden_terms) + " terms");
    v.check("exponents", o.exponents.size() == o.coefficients.size(),
            "expected as many as coefficients, which are " + std::to_string(o.coefficients.size()));
    v.check("exponents", std::count(o.exponents.begin(), o.exponents.end(), 0.0) == 0,
            "an exponent must not be zero");
    v.check("coefficients", o.coefficients.empty() || o.shear_modulus() > 0.0,
            "expected a sum > 0, which is twice the shear modulus");
  });
  v.when(o.model == MaterialModel::ogden_unconstrained, "ogden_unconstrained", [&] {
    v.required("lambda", o.lambda, "Lame's constant, of lambda/2 (J - 1)^2",
               at_least(0.0, "pressure"));
  });
  v.when(o.is_uncoupled(), "mooney_rivlin, ogden", [&] {
    v.required("bulk", o.bulk, "K of K/2 (ln J)^2, a thousand times G for rubber",
               positive("pressure"));
  });
  v.optional("density", o.density, "mass per reference volume, for dynamics",
             positive("mass/length^3"));
}

} // namespace abut::deck
