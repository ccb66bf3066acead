// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "block_loops.hpp"

#include "abut/core/error.hpp"
#include "abut/solid/element_kernel.hpp"

#include <Kokkos_Core.hpp>
#include <cmath>
#include <limits>

namespace abut::solid {

constexpr int max_fields = 8;
using Host = Kokkos::RangePolicy<Kokkos::DefaultHostExecutionSpace, Kokkos::IndexType<Local>>;

/// Reference coordinates and displacements of one element.
template <int n> struct ElementInput {
  double x[3][n], u[3][n];

  KOKKOS_INLINE_FUNCTION void gather(const Local* nodes, const double* coordinates,
                                     const NodalFields& fields) {
    for (int a = 0; a < n; ++a) {
      const double* from = coordinates + static_cast<std::int64_t>(nodes[a]) * solid_dim;
      const double* by = fields.u + static_cast<std::int64_t>(nodes[a]) * fields.fields;
      for (int i = 0; i < 3; ++i) {
        x[i][a] = from[i];
        u[i][a] = by[i];
      }
    }
  }
};

/// Runs body(element) -> det F over the elements and keeps the smallest.
template <class Body> Smallest smallest_over(Local elements, const Body& body) {
  using Reducer = Kokkos::MinLoc<double, Local, Kokkos::HostSpace>;
  typename Reducer::value_type result;
  Reducer reducer(result);
  reducer.init(result);
  Kokkos::parallel_reduce(
      "abut::solid", Host(0, elements),
      [&body](const Local e, typename Reducer::value_type& least) {
        const double det = body(e);
        if (!(det >= least.val)) { // also when not a number
          least.val = std::isnan(det) ? -std::numeric_limits<double>::infinity() : det;
          least.loc = e;
        }
      },
      reducer);
  Smallest smallest;
  if (elements > 0 && result.val < smallest.det) {
    smallest.det = result.val;
    smallest.element = result.loc;
  }
  return smallest;
}

template <fem::CellType C>
Smallest BlockLoops<C>::residual(const mesh::Mesh& mesh, const mesh::Block& block,
                                 const Material& material, const NodalFields& fields,
                                 const ResidualScatter& scatter) {
  constexpr int n = ReferenceCell<C>::nodes;
  ABUT_REQUIRE(fields.fields >= solid_dim && fields.fields <= max_fields, "fields per node");
  const ReferenceCell<C>& cell = reference_cell<C>();
  const double* x = mesh.x.data();
  const Local* nodes = block.nodes.data();
  return std::visit(
      [&](const auto& m) {
        return smallest_over(block.size(), [&](const Local e) {
          ElementInput<n> in;
          double r[3][n], out[n * max_fields];
          in.gather(nodes + static_cast<std::int64_t>(e) * n, x, fields);
          const double det = element_residual<C>(cell, m, in.x, in.u, r);
          for (int a = 0; a < n; ++a) {
            double* at = out + a * fields.fields;
            for (int i = 0; i < 3; ++i)
              at[i] = r[i][a];
            for (int i = 3; i < fields.fields; ++i)
              at[i] = 0.0;
          }
          scatter.add(e, out);
          return det;
        });
      },
      material);
}

template <fem::CellType C>
Smallest BlockLoops<C>::tangent(const mesh::Mesh& mesh, const mesh::Block& block,
                                const Material& material, const NodalFields& fields,
                                const TangentScatter& scatter) {
  constexpr int n = ReferenceCell<C>::nodes;
  ABUT_REQUIRE(fields.fields >= solid_dim, "fields per node");
  const ReferenceCell<C>& cell = reference_cell<C>();
  const double* x = mesh.x.data();
  const Local* nodes = block.nodes.data();
  // With three fields the scatter adds the displacement part of each node block; positions and row
  // lengths know the true number of fields.
  TangentScatter displacement = scatter;
  displacement.fields = solid_dim;
  return std::visit(
      [&](const auto& m) {
        return smallest_over(block.size(), [&](const Local e) {
          ElementInput<n> in;
          double k[9 * n * n];
          in.gather(nodes + static_cast<std::int64_t>(e) * n, x, fields);
          const double det = element_tangent<C>(cell, m, in.x, in.u, k);
          if (det > 0.0)
            displacement.add(e, k);
          return det;
        });
      },
      material);
}

template <fem::CellType C>
void BlockLoops<C>::averages(const mesh::Mesh& mesh, const mesh::Block& block,
                             const Material& material, const NodalFields& fields, double* stress,
                             double* energy) {
  constexpr int n = ReferenceCell<C>::nodes;
  const ReferenceCell<C>& cell = reference_cell<C>();
  const double* x = mesh.x.data();
  const Local* nodes = block.nodes.data();
  std::visit(
      [&](const auto& m) {
        Kokkos::parallel_for("abut::solid::averages", Host(0, block.size()), [&](const Local e) {
          ElementInput<n> in;
          in.gather(nodes + static_cast<std::int64_t>(e) * n, x, fields);
          element_averages<C>(cell, m, in.x, in.u, stress + static_cast<std::int64_t>(e) * 6,
                              energy[e]);
        });
      },
      material);
}

} // namespace abut::solid
