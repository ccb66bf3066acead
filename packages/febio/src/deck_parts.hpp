// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mesh_data.hpp"
#include "yaml_text.hpp"

#include <map>
#include <string>
#include <unordered_map>
#include <vector>

/// What the sections of a deck are made from.
namespace abut::febio {

/// FEBio's load curves that a deck uses, as its piecewise linear ones.
class DeckCurves {
public:
  DeckCurves(const Model& model, double end) : model_(model), end_(end) {}

  /// Name of the curve a value follows; "constant" for one without. Throws InputError when there is
  /// no such load controller.
  std::string of(const Value& value);
  /// The lines of the section; empty when nothing asked for a curve.
  std::string text() const;

private:
  const Model& model_;
  double end_;
  DeckNames names_;
  std::map<int, std::string> used_; ///< by id; 0: the constant
};

/// A rigid body of the deck: rigid materials whose domains or ties share nodes are one, as in
/// FEBio.
struct RigidBody {
  std::vector<std::string> materials;
  std::vector<std::size_t> domains;
  std::vector<std::string> sets; ///< of nodes that move with it
  std::array<double, 6> motion{};
  std::array<bool, 6> free{};
  std::array<double, 6> load{};
  Value motion_curve, load_curve; ///< curve alone; of what is not zero
  bool has_motion = false, has_load = false;
  Vec3 center = Vec3::zero();

  /// Whether all it does is to prescribe displacements of nodes; the deck then has no body for it.
  bool is_displacement() const {
    for (const bool f : free)
      if (f)
        return false;
    return domains.empty() && !turns();
  }
  bool turns() const {
    for (std::size_t i = 3; i < 6; ++i)
      if (free[i] || motion[i] != 0.0)
        return true;
    return false;
  }
};

struct RigidBodies {
  std::vector<RigidBody> bodies;
  std::unordered_map<Global, int> body_of_node; ///< node ids
};

RigidBodies rigid_bodies(const Model& model, MeshTranslation& mesh, Report& report);

/// Penalty of one pass: a factor of the deck's automatic one, or a number.
struct PassPenalty {
  bool automatic = false;
  double number = 0.0;
  std::string note;    ///< what FEBio had, for a comment
  std::string refused; ///< why no deck can say the same
};

/// FEBio's automatic penalty of a pass, which is of the primary alone: E A / V, with E as it is
/// without strain and of a rigid material its E / (1 - v^2). The deck's is of the softer surface.
PassPenalty automatic_penalty(const Model& model, const MeshTranslation& mesh, double factor,
                              const std::string& primary, const std::string& secondary);

/// Lines of the sections. `names`: FEBio's names stand in comments where they differ.
std::string displacements_text(const Model& model, const RigidBodies& rigid, MeshTranslation& mesh,
                               DeckCurves& curves, Report& report);
std::string contact_text(const Model& model, const MeshTranslation& mesh, DeckCurves& curves,
                         Report& report);

} // namespace abut::febio
