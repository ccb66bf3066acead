// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/contact/augmentation_policy.hpp"
#include "abut/contact/passes.hpp"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

/// The smallest host: a unit plate on springs, pressed on a fixed one and drawn along it, with two
/// passes, Coulomb friction and augmented Lagrangian by options alone. docs/developer/hosts.md
/// explains it.
namespace host {

using abut::Local;

constexpr int nodes = 8, fields = 3, size = nodes * fields; ///< 0..3 the plate, 4..7 the ground

/// A unit square at height z, on rank `owner` only; its normal is +z or -z.
inline abut::mesh::Surface square(const abut::Comm& comm, int owner, double z, bool up,
                                  abut::Global node) {
  abut::mesh::Surface s;
  s.name = up ? "lower" : "upper";
  if (comm.rank() != owner)
    return s;
  s.type = {abut::fem::FaceType::quad4};
  s.face_id = {up ? 1 : 0};
  s.offset = {0, 4};
  s.nodes = up ? std::vector<Local>{0, 1, 2, 3} : std::vector<Local>{3, 2, 1, 0};
  s.node = {node, node + 1, node + 2, node + 3};
  s.field_index = {Local(node), Local(node) + 1, Local(node) + 2, Local(node) + 3};
  s.x = {0, 0, z, 1, 0, z, 1, 1, z, 0, 1, z};
  s.modulus = s.inverse_depth = {0.0};
  return s;
}

/// The host's own equations, dense and the same on every rank.
struct System {
  std::vector<double> f = std::vector<double>(size), k = std::vector<double>(size * size);

  /// Adds residual and tangent of a contribution at u: cells of global nodes, which are the rows.
  void add(abut::Contribution& part, const abut::NodalFields& u) {
    part.prepare(u);
    const abut::Connectivity& cells = part.connectivity();
    const std::vector<Local> row(cells.nodes.begin(), cells.nodes.end());
    const std::vector<Local> row_length(nodes, size);
    std::vector<std::int64_t> first{0}, position;
    for (Local c = 0; c < cells.cells(); ++c) {
      for (Local a = cells.offsets[c]; a < cells.offsets[c + 1]; ++a)
        for (Local b = cells.offsets[c]; b < cells.offsets[c + 1]; ++b)
          position.push_back(fields * (size * std::int64_t(row[a]) + row[b]));
      first.push_back(std::int64_t(position.size()));
    }
    part.residual(u, {fields, cells.offsets.data(), row.data(), f.data()});
    part.tangent(u, {fields, cells.offsets.data(), row.data(), first.data(), position.data(),
                     row_length.data(), k.data()});
  }

  /// -k^-1 f by elimination.
  std::vector<double> correction() {
    std::vector<double> x(f);
    for (int c = 0; c < size; ++c)
      for (int r = c + 1; r < size; ++r) {
        const double factor = k[r * size + c] / k[c * size + c];
        for (int j = c; j < size; ++j)
          k[r * size + j] -= factor * k[c * size + j];
        x[r] -= factor * x[c];
      }
    for (int r = size - 1; r >= 0; --r) {
      for (int j = r + 1; j < size; ++j)
        x[r] -= k[r * size + j] * x[j];
      x[r] /= k[r * size + r];
    }
    for (double& value : x)
      value = -value;
    return x;
  }
};

/// Springs that draw the plate 0.1 into the ground and along it; the ground's are very stiff.
inline void add_springs(const std::vector<double>& u, System& system) {
  const double stiffness[] = {1000.0, 1000.0, 50.0}, target[] = {0.0115, 0.0, -0.1};
  for (int i = 0; i < size; ++i) {
    const bool plate = i < size / 2;
    const double spring = plate ? stiffness[i % fields] : 1e12;
    system.f[i] += spring * (u[i] - (plate ? target[i % fields] : 0.0));
    system.k[i * size + i] += spring;
  }
}

/// How far the forces of press_and_shear may be off: under a quarter of 20 each node of the ground
/// gives way by 5e-12, which takes 200 . 5e-12 off the springs' force; the gap that augmentation
/// may leave takes 200 . 1e-12. [force]
constexpr double force_tolerance = 200.0 * (5e-12 + 1e-12);

struct Answer {
  double shift = 0.0;    ///< of the plate along the ground [length]
  double pressing = 0.0; ///< normal force of both passes [force]
  double shearing = 0.0; ///< friction force of both passes [force]
  int interfaces = 0, augmentations = 0;
  abut::Global slipping = 0; ///< points
};

/// One step: Newton, then the policy of the interfaces, and again as long as it asks for it. The
/// springs press with 200 . 0.1 = 20; friction .3 stands 6, and 4000 (0.0115 - shift) = 6.
inline Answer press_and_shear(const abut::Comm& comm) {
  using namespace abut::contact;
  ContactOptions options;
  options.name = "press";
  options.primary = "upper";
  options.secondary = "lower";
  options.two_pass = true;
  options.friction = 0.3;
  options.enforcement = Enforcement::augmented_lagrangian;
  options.penalty = 1e4;
  options.gap_tolerance = 1e-12;
  abut::PhaseTimers timers;
  const Passes passes = make_passes(comm, square(comm, 0, 0.0, false, 0),
                                    square(comm, comm.size() - 1, 0.0, true, 4), options, timers);
  AugmentationPolicy policy(passes.interfaces);

  Answer answer;
  std::vector<double> u(size, 0.0);
  for (const auto& i : passes.interfaces)
    i->begin_step();
  for (bool done = false; !done; answer.augmentations += !done) {
    for (const auto& i : passes.interfaces)
      i->begin_solve(answer.augmentations == 0 ? abut::SolveKind::newton
                                               : abut::SolveKind::after_augmentation);
    for (int iteration = 0; iteration < 30; ++iteration) {
      System system;
      bool settled = true;
      for (const auto& i : passes.interfaces) {
        system.add(*i, {u.data(), fields, 1.0});
        settled = settled && i->settled();
      }
      comm.sum(system.f.data(), size);
      comm.sum(system.k.data(), size * size);
      add_springs(u, system);
      double norm = 0.0;
      for (double force : system.f)
        norm = std::fmax(norm, std::fabs(force));
      if (norm < 1e-10 && !comm.any(!settled))
        break;
      for (const auto& i : passes.interfaces) // Newton goes on from here
        i->iterate_taken();
      const std::vector<double> du = system.correction();
      for (int i = 0; i < size; ++i)
        u[i] += du[i];
    }
    done = policy(answer.augmentations).converged;
  }
  for (const auto& i : passes.interfaces) {
    i->accept();
    const ContactSummary s = i->summary();
    answer.pressing += std::fabs(s.force[2]);
    answer.shearing += s.tangential;
    answer.slipping += s.slip_points;
  }
  answer.interfaces = static_cast<int>(passes.interfaces.size());
  answer.shift = u[0];
  return answer;
}

} // namespace host
