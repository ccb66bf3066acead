// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "deck_parts.hpp"

#include <algorithm>
#include <cmath>

namespace abut::febio {

namespace {

class ContactWriter {
public:
  ContactWriter(const Model& model, const MeshTranslation& mesh, DeckCurves& curves, Report& report)
      : model_(model), mesh_(mesh), curves_(curves), report_(report) {}

  std::string text() {
    std::string out;
    DeckNames names;
    for (const Contact& c : model_.contacts) {
      const std::string name = names.make(c.name, "contact");
      out += "  " + name + ":" + (name == c.name ? "" : "  # FEBio: " + c.name) + "\n" + one(c);
    }
    return out.empty() ? "" : "contact:\n" + out;
  }

private:
  const SurfacePair& pair(const Contact& c) const {
    return *std::find_if(model_.mesh.pairs.begin(), model_.mesh.pairs.end(),
                         [&](const SurfacePair& p) { return p.name == c.pair; });
  }

  void line(const std::string& key, const std::string& value) {
    lines_ += "    " + key + ": " + value + "\n";
  }
  void line_unless(const std::string& key, double value, double initial) {
    if (value != initial)
      line(key, number_text(value));
  }

  std::string one(const Contact& c) {
    lines_.clear();
    const SurfacePair& p = pair(c);
    check_faces(c, p.primary, "flip_primary");
    check_faces(c, p.secondary, "flip_secondary");
    line("primary", quoted(p.primary));
    line("secondary", quoted(p.secondary));
    if (c.type == "sliding-node-on-facet")
      line("formulation", "node_on_facet");
    if (c.type == "sliding-elastic")
      line("formulation", "sliding_elastic");
    if (c.flag("two_pass"))
      line("two_pass", "true");
    penalty(c);
    friction(c);
    if (augments(c))
      augmentation(c);
    rest(c, p);
    return lines_;
  }

  /// Faces that point into their bodies, unless they are turned round, would make contact inside.
  void check_faces(const Contact& c, const std::string& surface, const char* flip) const {
    if (mesh_.data().side_sets.count(surface) == 0)
      throw InputError(model_.where(c.line) + ": surface '" + surface + "' of contact '" + c.name +
                       "' has no faces");
    const bool flipped = c.values.count(flip) && c.flag(flip);
    if (mesh_.points_outwards(surface) == flipped)
      report_.add({c.line, "Contact/contact '" + c.name + "'", Fate::refused,
                   "the faces of surface '" + surface + "' point into their bodies"});
  }

  /// FEBio adds up the two passes; each of abut's carries half.
  void penalty(const Contact& c) {
    const Value& penalty = c.values.at("penalty");
    const double value = (c.flag("two_pass") ? 2.0 : 1.0) * penalty.number;
    if (augments(c))
      line("enforcement", "augmented_lagrangian");
    const std::string note = c.flag("two_pass") ? "  # twice FEBio's: its two passes add up" : "";
    if (!c.flag("auto_penalty"))
      line("penalty", number_text(value) + note);
    else
      line("penalty_factor", number_text(value) + note);
    if (penalty.curve > 0)
      line("penalty_curve", curves_.of(penalty));
    if (c.flag("auto_penalty"))
      check_rigid_primary(c);
  }

  void check_rigid_primary(const Contact& c) const {
    const SurfacePair& p = pair(c);
    for (const auto* surface : {&p.primary, &p.secondary})
      for (const mesh::SideData& side : mesh_.data().side_sets.at(*surface)) {
        const Domain& d = model_.mesh.domains[static_cast<std::size_t>(side.block)];
        if ((surface == &p.primary || c.flag("two_pass")) &&
            model_.material(d.material)->is_rigid()) {
          report_.add({c.line, "Contact/contact/auto_penalty", Fate::refused,
                       "surface '" + *surface +
                           "' is rigid, and FEBio takes its penalty from the "
                           "E and v of the rigid material: give a number, auto_penalty 0"});
          return;
        }
      }
  }

  static bool augments(const Contact& c) {
    return c.flag("laugon") && (c.number("tolerance") > 0.0 || c.number("gaptol") > 0.0) &&
           c.number("maxaug") > 0.0;
  }

  void friction(const Contact& c) {
    const auto found = c.values.find("fric_coeff");
    if (found == c.values.end() || found->second.is_zero())
      return;
    if (c.type == "sliding-node-on-facet" && c.number("fric_penalty") == 0.0) {
      report_.add({c.line, "Contact/contact/fric_coeff", Fate::ignored,
                   "FEBio has no friction where fric_penalty is 0"});
      return;
    }
    line("friction", number_text(found->second.number));
    if (found->second.curve > 0)
      line("friction_curve", curves_.of(found->second));
    if (c.type == "sliding-node-on-facet")
      report_.add({c.line, "Contact/contact/fric_penalty", Fate::used,
                   "abut resists stick with the penalty of the normal direction"});
    if (!augments(c))
      report_.add({c.line, "Contact/contact/laugon", Fate::used,
                   "with a penalty alone FEBio forgets the shear of earlier steps, abut does not: "
                   "answers differ where points stick"});
  }

  /// Relative change of the multipliers' norm. The ray formulation compares sums of squares, whose
  /// relative change is (1 + d)^-2 below 1 for multipliers that grow by d.
  static double multiplier_tolerance(const Contact& c) {
    const double tolerance = c.number("tolerance");
    if (c.type != "sliding-elastic" || tolerance <= 0.0)
      return tolerance;
    return rounded(tolerance < 1.0 ? tolerance / (1.0 + std::sqrt(1.0 - tolerance)) : 1.0, 3);
  }

  void augmentation(const Contact& c) {
    line("multipliers", "per_point"); // as FEBio has them
    const double tolerance = multiplier_tolerance(c);
    if (tolerance > 0.0)
      line_unless("multiplier_tolerance", tolerance, 0.01);
    else
      line("multiplier_tolerance", "1e10  # FEBio asks for the gap alone");
    line_unless("gap_limit", c.number("gaptol"), 0.0);
    line_unless("min_augmentations", c.number("minaug"), 0.0);
    line_unless("max_augmentations", c.number("maxaug"), 20.0);
  }

  void rest(const Contact& c, const SurfacePair& p) {
    if (c.values.count("tension") && c.flag("tension"))
      line("tension", "true");
    if (c.values.count("offset"))
      line_unless("offset", c.number("offset"), 0.0);
    line_unless("projection_margin", c.number("search_tol"), 0.01);
    line_unless("segment_updates", c.number("seg_up"), 0.0);
    if (c.flag("node_reloc"))
      line("initial_overlap", "adjust  # FEBio: node_reloc, which moves the nodes instead");
    const double radius = c.number("search_radius");
    const double size = std::max(mesh_.face_size(p.primary), mesh_.face_size(p.secondary));
    const double in_sizes = rounded(radius / size, 3);
    if (in_sizes > 0.0 && in_sizes < 3.0)
      line("reach", number_text(in_sizes) + "  # FEBio: search_radius " + number_text(radius));
  }

  const Model& model_;
  const MeshTranslation& mesh_;
  DeckCurves& curves_;
  Report& report_;
  std::string lines_;
};

} // namespace

std::string contact_text(const Model& model, const MeshTranslation& mesh, DeckCurves& curves,
                         Report& report) {
  return ContactWriter(model, mesh, curves, report).text();
}

} // namespace abut::febio
