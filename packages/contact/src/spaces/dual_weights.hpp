// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace abut::contact {

/// Functions psi_a = sum_b C_ab N_b of one face that are biorthogonal to its corner functions on
/// the face's own quadrature, sum_q w psi_a N_b = delta_ab sum_q w N_a. They sum to one and may be
/// negative. N: (points, corners), w: (points) [length^2], C: (corners, corners). False, with C the
/// identity, where the quadrature does not tell the corner functions apart.
bool dual_coefficients(int corners, int points, const double* N, const double* w, double* C);

} // namespace abut::contact
