// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/audit/options.hpp"
#include "abut/core/comm.hpp"
#include "abut/deck/value.hpp"
#include "abut/io/options.hpp"
#include "abut/scene/options.hpp"
#include "abut/solver/options.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace abut::deck {

/// A mesh from a file or from a generator.
struct MeshOptions {
  struct Parameter {
    std::string key;
    std::string text; ///< a scalar as written; the items of a list joined by commas
    Location where;
  };
  std::string file;                  ///< as written, relative to the deck's folder
  std::string kind;                  ///< of the generator; empty when `file` is given
  std::vector<Parameter> parameters; ///< of the generator, which checks them

  /// The parameters as the generator takes them.
  std::map<std::string, std::string> generator_options() const;
};

enum class Quantity {
  force_x,
  force_y,
  force_z,
  max_pressure,
  max_penetration,
  active_points,
  stick_points,
  slip_points,
  max_slip,
  friction_dissipation,
  contact_radius,
  displacement_x,
  displacement_y,
  displacement_z,
  reaction_x,
  reaction_y,
  reaction_z,
  newton_iterations,
  rigid_displacement_x,
  rigid_displacement_y,
  rigid_displacement_z,
  rigid_rotation_x,
  rigid_rotation_y,
  rigid_rotation_z,
  rigid_force_x,
  rigid_force_y,
  rigid_force_z,
  rigid_moment_x,
  rigid_moment_y,
  rigid_moment_z,
  joint_force_x,
  joint_force_y,
  joint_force_z,
  joint_moment_x,
  joint_moment_y,
  joint_moment_z,
  joint_translation,
  joint_rotation,
};
/// Whether `place` names a contact interface.
bool is_contact_quantity(Quantity quantity);
/// Whether `place` names a rigid body.
bool is_rigid_quantity(Quantity quantity);
/// Whether `place` names a joint.
bool is_joint_quantity(Quantity quantity);

/// One statement about the result by which a deck checks itself.
struct VerifyOptions {
  std::string name;
  Quantity quantity = Quantity::force_x;
  std::string place;                          ///< contact interface, rigid body, joint, set
  std::optional<std::array<double, 3>> point; ///< reference coordinates [length]
  double expected = 0.0;
  std::optional<double> tolerance;          ///< absolute
  std::optional<double> relative_tolerance; ///< of |expected| [1]
  std::string source;                       ///< where the expected value comes from

  /// The larger of the two tolerances, absolute.
  double allowed_error() const;
};

/// What a run tests of its own model.
enum class ModelCheck { none, tangent };

/// A scene, the mesh that it is on, how it is solved and what is written of it.
struct Deck : scene::Options {
  std::string file; ///< the deck's own file name, as given
  std::string title;
  MeshOptions mesh;
  solver::NewtonOptions newton;
  solver::LinearOptions linear;
  audit::AuditOptions audit;
  io::OutputOptions output;
  ModelCheck check = ModelCheck::none;
  std::vector<VerifyOptions> verify;

  /// Place of every key given, by its path: "contact.ball_on_floor.primary".
  std::map<std::string, Location> locations;

  /// "FILE:LINE: path" to begin a message about a key. For a path that is not in the deck, the line
  /// is that of the nearest enclosing key.
  std::string where(const std::string& path) const;

  /// mesh.file seen from the working directory.
  std::string mesh_path() const;
};

/// Fills and validates. Throws InputError "FILE:LINE: key path: what was expected, what was found".
Deck make_deck(const Value& top, const std::string& file);

/// parse + make_deck.
Deck parse_deck(const std::string& text, const std::string& file);

/// Reads the file on the root and gives every rank the same deck, or the same InputError.
/// Collective.
Deck read_deck(const Comm& comm, const std::string& file);

/// The whole deck as YAML, defaults included. Reads back as the same deck.
std::string to_yaml(const Deck& deck);

/// The part of it that decides what is solved: bodies, what acts on them, contact, dynamics; not
/// the mesh, steps, solvers, output or comparisons. Of the steps their end, where initial overlaps
/// are resolved until then.
std::string model_yaml(const Deck& deck);

} // namespace abut::deck
