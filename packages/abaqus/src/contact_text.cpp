// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "deck_parts.hpp"

#include <algorithm>

namespace abut::abaqus {

namespace {

class ContactWriter {
public:
  explicit ContactWriter(const DeckParts& parts) : parts_(parts) {}

  std::string text() {
    std::string out;
    for (const Pair& p : parts_.model.pairs)
      for (const Window& window : windows(p))
        out += one(p, window);
    return out.empty() ? "" : "contact:\n" + out;
  }

private:
  void line(const std::string& key, const std::string& value) {
    lines_ += "    " + key + ": " + value + "\n";
  }

  /// When a pair is in.
  std::vector<Window> windows(const Pair& p) const {
    std::vector<Window> result;
    const std::size_t count = parts_.model.steps.size();
    const auto off = [&](std::size_t s) {
      return !p.is_off.empty() && p.is_off[std::min(s, p.is_off.size() - 1)];
    };
    for (std::size_t s = 0; s < count; ++s) {
      if (off(s))
        continue;
      const std::size_t first = s;
      while (s + 1 < count && !off(s + 1))
        ++s;
      result.push_back(parts_.window(first, s));
    }
    return result;
  }

  const Interaction& law(const Pair& p) const {
    static const Interaction hard;
    if (p.interaction.empty())
      return hard;
    const auto& all = parts_.model.interactions;
    const auto found = all.find(key_of(p.interaction));
    if (found == all.end()) {
      std::vector<std::string> valid;
      for (const auto& entry : all)
        valid.push_back(entry.second.name);
      throw InputError(parts_.model.where(p.place) +
                       ": *CONTACT PAIR: there is no "
                       "*SURFACE INTERACTION '" +
                       p.interaction + "'; " +
                       nearest_word_hint(p.interaction, valid.data(), valid.size()));
    }
    return found->second;
  }

  std::string one(const Pair& p, const Window& window) {
    const Interaction& with = law(p);
    const std::string primary = parts_.mesh.surface(p.first),
                      secondary = parts_.mesh.surface(p.second);
    const bool tied = p.tied || with.normal == Interaction::Normal::tied;
    lines_ = "  " + names_.make(p.name, "contact") + ":\n";
    line("primary", quoted(primary));
    line("secondary", quoted(secondary));
    if (!parts_.mesh.is_deformable(primary) && parts_.mesh.is_deformable(secondary))
      parts_.say(p.place, "pair '" + p.name + "'", Fate::used,
                 "its first surface, which has the points, is rigid");
    if (p.nodal)
      line("formulation", "node_on_facet");
    if (tied)
      tie(p, primary);
    normal(p, with, tied);
    if (!tied) {
      if (with.no_separation)
        line("tension", "true");
      friction(p, with);
      start(p, primary);
    }
    FlowMap when;
    add_window(when, window);
    lines_ += when.lines("    ");
    return lines_;
  }

  void tie(const Pair& p, const std::string& primary) {
    constexpr double farthest = 3.0; // face sizes, as far as abut seeks
    line("tied", "true");
    if (!p.tied) { // CalculiX: all faces that have a partner, as springs without length
      line("tie_distance", number_text(farthest));
      line("tie_gap", "close");
      return;
    }
    const std::optional<double> tolerance = p.tolerance ? p.tolerance : p.adjust;
    if (tolerance)
      line("tie_distance",
           number_text(std::clamp(rounded(*tolerance / parts_.mesh.face_size(primary), 3), 1e-6,
                                  farthest)));
  }

  void normal(const Pair& p, const Interaction& with, bool tied) {
    const bool soft = with.normal != Interaction::Normal::hard && !p.tied;
    if (soft && !p.mortar) {
      line("penalty", number_text(with.stiffness) + "  # pressure over overclosure");
      if (with.clearance != 0.0)
        line("offset", number_text(with.clearance));
      return;
    }
    if (soft && p.mortar)
      parts_.say(p.place, "pair '" + p.name + "'", Fate::used,
                 "mortar: by multipliers, without the slope of its *SURFACE BEHAVIOR");
    line("enforcement", tied ? "augmented_lagrangian  # exact, as equations between the nodes"
                             : "augmented_lagrangian");
  }

  /// Factor of the largest coefficient.
  void friction(const Pair& p, const Interaction& with) {
    const Model& model = parts_.model;
    double largest = with.friction;
    for (const FrictionChange& c : model.friction_changes)
      if (c.interaction == key_of(p.interaction))
        largest = std::max(largest, c.friction);
    if (largest == 0.0)
      return;
    line("friction", number_text(largest));
    if (with.stick_slope > 0.0 && with.normal != Interaction::Normal::hard && !p.mortar)
      parts_.say(with.place, "*SURFACE INTERACTION '" + with.name + "'", Fate::used,
                 "where points stick, abut resists with the slope of the normal direction, " +
                     number_text(with.stiffness) + ", not with the stick slope " +
                     number_text(with.stick_slope));
    Points points = {{0.0, with.friction / largest}};
    for (const FrictionChange& c : model.friction_changes) {
      if (c.interaction != key_of(p.interaction))
        continue;
      const double from = model.start(std::size_t(c.step)), value = c.friction / largest;
      if (value == points.back()[1])
        continue;
      if (from > points.back()[0])
        points.push_back({from, points.back()[1]});
      points.push_back({from + 1e-9 * model.end(), value});
    }
    if (points.size() == 1)
      return;
    points.push_back({model.end(), points.back()[1]});
    line("friction_curve", parts_.curves.of(points, "friction_" + with.name).curve);
  }

  /// What gaps and overlaps at the start mean.
  void start(const Pair& p, const std::string& primary) {
    if (p.clearance) {
      constexpr double near = 3.0; // face sizes
      line("interference", number_text(-*p.clearance) + "  # CLEARANCE");
      line("interference_curve", parts_.curves.constant());
      line("fit_within", number_text(rounded(near * parts_.mesh.face_size(primary), 3)));
      return;
    }
    if (!p.adjust)
      return;
    line("initial_overlap", "adjust");
    if (*p.adjust > 0.0) {
      line("initial_gap", "close");
      line("fit_within", number_text(*p.adjust));
    }
  }

  const DeckParts& parts_;
  DeckNames names_;
  std::string lines_;
};

} // namespace

std::string contact_text(const DeckParts& parts) {
  return ContactWriter(parts).text();
}

} // namespace abut::abaqus
