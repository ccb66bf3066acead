// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/translation/yaml_text.hpp"
#include "mesh_data.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

/// What the sections of a deck are made from.
namespace abut::febio {

using namespace translation;

/// A number of the deck and the curve that it follows.
struct Timed {
  double number = 0.0;
  std::string curve;
};

/// FEBio's load curves that a deck uses, as its piecewise linear ones.
class DeckCurves {
public:
  explicit DeckCurves(const Model& model) : model_(model), end_(model.end()) {}

  /// Name of the curve a value follows; "constant" for one without. Throws InputError when there is
  /// no such load controller.
  std::string of(const Value& value);
  /// What changes from step to step has a curve of its own, which jumps between the steps.
  Timed of(const Course& course);
  /// The lines of the section; empty when nothing asked for a curve.
  std::string text() const;

private:
  using Pieces = std::vector<std::pair<double, int>>; ///< (steps) factor, id of a curve

  const LoadCurve& find(const Value& value) const;
  std::vector<std::array<double, 2>> points(int id) const;
  std::vector<std::array<double, 2>> points(const Pieces& pieces) const;

  const Model& model_;
  double end_;
  DeckNames names_;
  std::map<int, std::string> used_; ///< by id; 0: the constant
  std::map<Pieces, std::string> composed_;
};

/// What prescribes a component of a rigid body in some steps.
struct PartHold {
  const RigidCondition* condition;
  Window window;
  bool relative;
};

/// A rigid body of the deck: rigid materials whose domains or ties share nodes are one, as in
/// FEBio.
struct RigidBody {
  std::vector<std::string> materials;
  std::vector<std::size_t> domains;
  std::vector<std::string> sets;      ///< of nodes that move with it
  std::array<Course, 6> motion, load; ///< empty: none
  std::array<bool, 6> free{};
  std::array<std::vector<PartHold>, 6> holds; ///< of free components
  bool follower = false;                      ///< of its loads
  Vec3 center = Vec3::zero();
  bool is_jointed = false;
  std::string deck_name;                    ///< once the deck's bodies are written
  double density = 0.0;                     ///< of its domains, where it moves by inertia
  std::array<double, 3> velocity{}, spin{}; ///< at the start

  /// Whether all it does is to prescribe displacements of nodes; the deck then has no body for it.
  bool is_displacement() const {
    for (const bool f : free)
      if (f)
        return false;
    return domains.empty() && !turns() && !is_jointed;
  }
  bool turns() const {
    for (std::size_t i = 3; i < 6; ++i)
      if (free[i] || !motion[i].empty())
        return true;
    return false;
  }
  bool is_loaded() const {
    return std::any_of(load.begin(), load.end(), [](const Course& c) { return !c.empty(); });
  }
};

struct RigidBodies {
  std::vector<RigidBody> bodies;
  std::unordered_map<Global, int> body_of_node; ///< node ids

  /// Null where the material has no body.
  const RigidBody* of_material(const std::string& material) const {
    for (const RigidBody& body : bodies)
      if (std::find(body.materials.begin(), body.materials.end(), material) != body.materials.end())
        return &body;
    return nullptr;
  }
};

RigidBodies rigid_bodies(const Model& model, MeshTranslation& mesh, Report& report);

/// Penalty of one pass: a factor of the deck's automatic one, or a number.
struct PassPenalty {
  bool automatic = false;
  double number = 0.0;
  std::string note;    ///< what FEBio had, for a comment
  std::string refused; ///< why no deck can say the same
};

/// Faces of a primary surface that have one penalty; none where it is the whole surface.
struct PenaltyPart {
  std::vector<mesh::SideData> sides;
  PassPenalty penalty;
};

/// FEBio's automatic penalty of a pass, which is of the primary alone: E A / V of each face, with E
/// as it is without strain and of a rigid material its E / (1 - v^2). The deck's is of the softer
/// surface, and one for a contact: faces of one stiffness are a part. Not empty.
std::vector<PenaltyPart> automatic_penalty(const Model& model, const MeshTranslation& mesh,
                                           double factor, const std::string& primary,
                                           const std::string& secondary);

/// Lines of the sections. `names`: FEBio's names stand in comments where they differ.
std::string displacements_text(const Model& model, const RigidBodies& rigid, MeshTranslation& mesh,
                               DeckCurves& curves, Report& report);
std::string joints_text(const Model& model, const RigidBodies& rigid, DeckCurves& curves,
                        Report& report);
/// Side sets for parts of surfaces are added to the mesh.
std::string contact_text(const Model& model, MeshTranslation& mesh, DeckCurves& curves,
                         Report& report);

} // namespace abut::febio
