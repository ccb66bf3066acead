// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "deck_parts.hpp"

#include <algorithm>
#include <cmath>

namespace abut::febio {

namespace {

class ContactWriter {
public:
  ContactWriter(const Model& model, MeshTranslation& mesh, DeckCurves& curves, Report& report)
      : model_(model), mesh_(mesh), curves_(curves), report_(report) {}

  std::string text() {
    std::string out;
    for (const Contact& c : model_.contacts)
      out += passes(c);
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

  /// One entry, or several where FEBio's passes or the faces of a surface have penalties of their
  /// own.
  std::string passes(const Contact& c) {
    const SurfacePair& p = pair(c);
    check_faces(c, p.primary, "flip_primary", uses_normals(c) || c.flag("two_pass"));
    check_faces(c, p.secondary, "flip_secondary", !c.is_tied() || takes_rays(c));
    report_friction(c);
    const std::string name = names_.make(c.name, "contact");
    std::vector<PenaltyPart> first = penalty_of(c, p.primary, p.secondary);
    if (!c.flag("two_pass"))
      return parts(c, name, p, first);
    const std::vector<PenaltyPart> second = penalty_of(c, p.secondary, p.primary);
    PassPenalty& penalty = first[0].penalty;
    if (first.size() == 1 && second.size() == 1 &&
        penalty.automatic == second[0].penalty.automatic &&
        penalty.number == second[0].penalty.number) {
      penalty.number *= 2.0; // each of abut's passes carries half
      penalty.note = "twice FEBio's: its two passes add up";
      return one(c, name, p, p.primary, penalty, true);
    }
    const SurfacePair back = {p.name, p.secondary, p.primary, p.line};
    return parts(c, name, p, first) +
           parts(c, names_.make(name + "_second_pass", ""), back, second);
  }

  /// An entry for each part of the primary surface.
  std::string parts(const Contact& c, const std::string& name, const SurfacePair& p,
                    const std::vector<PenaltyPart>& list) {
    if (list.size() == 1)
      return one(c, name, p, p.primary, list[0].penalty, false);
    std::string out;
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::string number = "_part_" + std::to_string(i + 1);
      const std::string set = mesh_.add_side_set(p.primary + number, list[i].sides);
      const std::string own = i == 0 ? name : names_.make(name + number, "");
      out += one(c, own, p, set, list[i].penalty, false);
    }
    report_.add({c.line, "Contact/contact/auto_penalty", Fate::used,
                 "surface '" + p.primary + "' is of " + std::to_string(list.size()) +
                     " stiffnesses, each of which has a penalty and so a contact of its own"});
    return out;
  }

  bool in_one_step(const Contact& c) const { return c.step >= 0 && model_.steps.size() > 1; }

  std::vector<PenaltyPart> penalty_of(const Contact& c, const std::string& primary,
                                      const std::string& secondary) const {
    const double number = c.number("penalty");
    if (!(number > 0.0))
      throw InputError(model_.where(c.line) + ": the penalty of contact '" + c.name +
                       "' must be positive");
    if (!c.flag("auto_penalty"))
      return {{{}, {false, number, "", ""}}};
    const auto result = automatic_penalty(model_, mesh_, number, primary, secondary);
    for (const PenaltyPart& part : result)
      if (!part.penalty.refused.empty())
        report_.add({c.line, "Contact/contact/auto_penalty", Fate::refused, part.penalty.refused});
    return result;
  }

  /// set: the side set of the primary surface, or of a part of it.
  std::string one(const Contact& c, const std::string& name, const SurfacePair& p,
                  const std::string& set, const PassPenalty& penalty, bool two_pass) {
    lines_ = "  " + name + ":" + (name == c.name ? "" : "  # FEBio: " + c.name) + "\n";
    line("primary", quoted(set));
    line("secondary", quoted(p.secondary));
    if (is_nodal(c))
      line("formulation", "node_on_facet");
    if (takes_rays(c))
      line("formulation", "sliding_elastic");
    if (c.is_tied())
      tie(c, p);
    if (c.is_sticky()) {
      line("sticky", "true");
      line_unless("stick_within", c.number("snap_tol"), 0.0);
      line_unless("stick_strength", std::max(0.0, c.number("max_traction")), 0.0);
    }
    if (two_pass)
      line("two_pass", "true");
    add_penalty(c, penalty);
    friction(c);
    if (augments(c))
      augmentation(c);
    rest(c, p);
    if (in_one_step(c)) {
      const auto step = static_cast<std::size_t>(c.step);
      const Window window = model_.window(step, step);
      line_unless("from", window.from, 0.0);
      if (window.until)
        line_unless("until", *window.until, 0.0);
    }
    return lines_;
  }

  /// Faces that point into their bodies, unless they are turned round, would make contact inside.
  /// Where nothing depends on their normal, they may.
  void check_faces(const Contact& c, const std::string& surface, const char* flip,
                   bool has_normal) const {
    if (mesh_.data().side_sets.count(surface) == 0)
      throw InputError(model_.where(c.line) + ": surface '" + surface + "' of contact '" + c.name +
                       "' has no faces");
    const bool flipped = c.values.count(flip) && c.flag(flip);
    if (has_normal && mesh_.points_outwards(surface) == flipped)
      report_.add({c.line, "Contact/contact '" + c.name + "'", Fate::refused,
                   "the faces of surface '" + surface + "' point into their bodies"});
  }

  void add_penalty(const Contact& c, const PassPenalty& penalty) {
    if (augments(c))
      line("enforcement", "augmented_lagrangian");
    line(penalty.automatic ? "penalty_factor" : "penalty",
         number_text(penalty.number) + (penalty.note.empty() ? "" : "  # " + penalty.note));
    const int curve = c.values.at("penalty").curve;
    if (curve > 0)
      line("penalty_curve", curves_.of(c.values.at("penalty")));
  }

  static bool augments(const Contact& c) {
    return c.flag("laugon") && (c.number("tolerance") > 0.0 || c.number("gaptol") > 0.0) &&
           c.number("maxaug") > 0.0;
  }

  static bool is_nodal(const Contact& c) {
    return c.type == "sliding-node-on-facet" || c.type == "tied-node-on-facet" || c.is_sticky();
  }
  /// Of the primary surface; else a point looks for the closest one of the other.
  static bool uses_normals(const Contact& c) {
    return takes_rays(c) || (!is_nodal(c) && c.flag("node_reloc"));
  }
  static bool takes_rays(const Contact& c) {
    return c.type == "sliding-elastic" || c.type == "tied-elastic";
  }

  /// FEBio ties what has a partner within a length; abut seeks that far at most.
  void tie(const Contact& c, const SurfacePair& p) {
    constexpr double farthest = 3.0;
    const double length = c.number(takes_rays(c) ? "search_radius" : "max_distance");
    const double in_sizes =
        length > 0.0 ? rounded(length / mesh_.face_size(p.primary), 3) : farthest;
    line("tied", "true");
    line("tie_distance", number_text(std::min(in_sizes, farthest)));
    if (!takes_rays(c) && !c.flag("moves_nodes"))
      line("tie_gap", "close");
  }

  static bool rubs(const Contact& c) {
    const auto found = c.values.find("fric_coeff");
    return found != c.values.end() && !found->second.is_zero() &&
           (c.type != "sliding-node-on-facet" || c.number("fric_penalty") != 0.0);
  }

  void friction(const Contact& c) {
    if (!rubs(c))
      return;
    const Value& mu = c.values.at("fric_coeff");
    line("friction", number_text(mu.number));
    if (mu.curve > 0)
      line("friction_curve", curves_.of(mu));
  }

  void report_friction(const Contact& c) const {
    const bool nodal = c.type == "sliding-node-on-facet";
    if (nodal && !rubs(c) && !c.values.at("fric_coeff").is_zero())
      report_.add({c.line, "Contact/contact/fric_coeff", Fate::ignored,
                   "FEBio has no friction where fric_penalty is 0"});
    if (!rubs(c))
      return;
    if (nodal)
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
    if (!takes_rays(c) || tolerance <= 0.0)
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
    line_unless("gap_limit", std::max(0.0, c.number("gaptol")), 0.0);
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
    if (c.flag("node_reloc")) {
      line("initial_overlap", "adjust  # FEBio: node_reloc, which moves the nodes instead");
      line("initial_gap", "mesh");
    }
    if (c.is_tied() || c.is_sticky())
      return;
    const double radius = c.number("search_radius");
    const double size = std::max(mesh_.face_size(p.primary), mesh_.face_size(p.secondary));
    const double in_sizes = rounded(radius / size, 3);
    if (in_sizes > 0.0 && in_sizes < 3.0)
      line("reach", number_text(in_sizes) + "  # FEBio: search_radius " + number_text(radius));
  }

  const Model& model_;
  MeshTranslation& mesh_;
  DeckCurves& curves_;
  Report& report_;
  DeckNames names_;
  std::string lines_;
};

} // namespace

std::string contact_text(const Model& model, MeshTranslation& mesh, DeckCurves& curves,
                         Report& report) {
  return ContactWriter(model, mesh, curves, report).text();
}

} // namespace abut::febio
