// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Thresholds of the contact search and status. All are without units.
namespace abut::contact {

constexpr double touching_gap = 1e-8; ///< gap that counts as none in the tangent, in face sizes
constexpr double round_off = 1e-9; ///< beside a face by no more than this is on it; two distances
                                   ///< that differ by less, in face sizes, are one
constexpr double as_near = 0.01;   ///< difference of distances that decides nothing, in face sizes
constexpr double hold_margin =
    0.1;                  ///< a point that swings between two faces stays on one up to here
constexpr int swings = 2; ///< returns to the face just left, or ways over a rim, in one solve, that
                          ///< are a cycle and not overshoot
constexpr double rim_depth = 0.5;       ///< of a face: deeper than this nothing slides over a rim
constexpr double outward_share = -1e-2; ///< cosine between normals below which faces oppose
constexpr double lock_share = 0.05; ///< least cosine between an inclined ray and the face it meets
constexpr double frozen_margin = 0.5; ///< how far beside its face a partner may go that stays
constexpr int early_iterates = 6;     ///< of a solve, in which its contact may be far from balance
constexpr double moderate_depth = 0.05; ///< penetration in face sizes, see moderate()
constexpr double soft_switching = 0.6;  ///< of E/h: stiffness that decides between stick and slip
constexpr double sliver = 0.2;      ///< a corner node with less of its function covered hands it on
constexpr double nearer_side = 0.5; ///< of a body's thickness: what is deeper has not come in here
constexpr double squeezed = 0.1;    ///< of its length that a way through a body keeps at least
constexpr double leads_inward =
    0.1; ///< sum of cosines at both ends of a way: less runs along faces

} // namespace abut::contact
