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
    for (const auto& pair : deck_.contact)
      if (pair.primary == pair.secondary)
        fail("contact." + pair.name + ".secondary",
             "the pair names the same surface twice: '" + pair.primary + "'");
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

  void curve(const std::string& path, const std::string& word) const {
    if (!word.empty())
      name(path + ".curve", word, deck_.curves, "curves");
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
        curve(path + ".rigid", body.motion.curve);
      else
        name(path + ".material", body.material, deck_.materials, "materials");
    }
    if (!deformable)
      fail("bodies", "all bodies are rigid; expected one with a material");
  }

  void verify(const VerifyOptions& v) const {
    const std::string path = "verify." + v.name;
    if (is_contact_quantity(v.quantity)) {
      if (v.place.empty())
        fail(path, "missing key 'place' (the contact interface)");
      name(path + ".place", v.place, deck_.contact, "contact");
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
