// SPDX-License-Identifier: BSD-3-Clause
#include "check.hpp"

#include "abut/core/error.hpp"
#include "abut/deck/deck.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace abut::deck {

namespace {

class ReferenceCheck {
public:
  explicit ReferenceCheck(const Deck& deck) : deck_(deck) {}

  void run() const {
    bodies();
    for (const auto& d : deck_.displacements)
      curve("displacements." + d.name, d.curve);
    for (const auto& load : deck_.loads)
      curve("loads." + load.name, load.curve);
    for (const auto& pair : deck_.contact) {
      curve("contact." + pair.name, pair.penalty_curve, ".penalty_curve");
      curve("contact." + pair.name, pair.friction_curve, ".friction_curve");
      if (pair.primary == pair.secondary && pair.two_pass)
        fail("contact." + pair.name + ".two_pass",
             "self-contact of '" + pair.primary + "' has points on both sides already");
      if (pair.tied && pair.tension)
        fail("contact." + pair.name + ".tension", "tied points pull already");
      if (pair.sticky && (pair.tied || pair.tension || pair.friction > 0.0))
        fail("contact." + pair.name + ".sticky", "does not go with tied, tension or friction");
    }
    for (const auto& v : deck_.verify)
      verify(v);
  }

private:
  [[noreturn]] void fail(const std::string& path, const std::string& message) const {
    throw InputError(deck_.where(path) + ": " + message);
  }

  template <class List>
  void name(const std::string& path, const std::string& word, const List& list,
            const char* section) const {
    std::vector<std::string> names;
    for (const auto& item : list)
      names.push_back(item.name);
    if (std::find(names.begin(), names.end(), word) != names.end())
      return;
    fail(path, "'" + word + "' is not a name under " + section + "; " +
                   nearest_word_hint(word, names.data(), names.size()));
  }

  void curve(const std::string& path, const std::string& word, const char* key = ".curve") const {
    if (!word.empty())
      name(path + key, word, deck_.curves, "curves");
  }

  void contact_place(const std::string& path, const std::string& place) const {
    for (const auto& pair : deck_.contact)
      if (pair.two_pass && place == pair.name + "_second_pass")
        return;
    name(path + ".place", place, deck_.contact, "contact");
  }

  void bodies() const {
    std::map<std::string, std::string> owner;
    bool deformable = false;
    for (const auto& body : deck_.bodies) {
      const std::string path = "bodies." + body.name;
      for (const std::string& block : body.blocks) {
        const auto [other, first] = owner.emplace(block, body.name);
        if (!first)
          fail(path + ".blocks",
               "block '" + block + "' already belongs to body '" + other->second + "'");
      }
      deformable = deformable || !body.rigid;
      if (body.rigid)
        rigid(path + ".rigid", body.motion);
      else
        name(path + ".material", body.material, deck_.materials, "materials");
    }
    if (!deformable)
      fail("bodies", "all bodies are rigid; expected one with a material");
  }

  void rigid(const std::string& path, const solid::RigidMotion& motion) const {
    curve(path, motion.curve);
    curve(path, motion.load_curve, ".load_curve");
    constexpr const char* components[] = {".x", ".y", ".z", ".rx", ".ry", ".rz"};
    for (std::size_t i = 0; i < 6; ++i)
      curve(path + ".curves", motion.curves[i], components[i]);
    for (const auto& hold : motion.holds)
      curve(path + ".holds." + hold.name, hold.curve);
  }

  void rigid_place(const std::string& path, const std::string& word) const {
    if (word.empty())
      fail(path, "missing key 'place' (the rigid body)");
    name(path + ".place", word, deck_.bodies, "bodies");
    for (const auto& body : deck_.bodies)
      if (body.name == word && !body.rigid)
        fail(path + ".place", "body '" + word + "' is not rigid");
  }

  void verify(const VerifyOptions& v) const {
    const std::string path = "verify." + v.name;
    if (is_contact_quantity(v.quantity)) {
      if (v.place.empty())
        fail(path, "missing key 'place' (the contact interface)");
      contact_place(path, v.place);
    } else if (is_rigid_quantity(v.quantity)) {
      rigid_place(path, v.place);
    } else if (v.quantity == Quantity::newton_iterations) {
      if (!v.place.empty())
        fail(path + ".place", "newton_iterations counts the whole run");
    } else if (v.quantity >= Quantity::reaction_x && v.place.empty()) {
      fail(path, "missing key 'place' (the node set or side set whose reactions are summed)");
    } else if (v.place.empty() && !v.point) {
      fail(path, "expected one of the keys place, point");
    } else if (v.quantity < Quantity::reaction_x && !v.place.empty() && v.point) {
      fail(path + ".point", "only one of the keys place, point is allowed");
    }
  }

  const Deck& deck_;
};

} // namespace

void check_references(const Deck& deck) {
  ReferenceCheck(deck).run();
}

} // namespace abut::deck
