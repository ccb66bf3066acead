// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include "abut/core/error.hpp"
#include "abut/translation/utf8.hpp"
#include "keywords.hpp"

#include <algorithm>
#include <set>

namespace abut::abaqus {

namespace {

class Reader {
public:
  Reader(Cards& cards, Model& model)
      : cards_(cards), structure_(cards), model_(model), lookup_(model, scopes()) {}

  void run() {
    for (Card& card : cards_.list())
      judge(card);
    // What names something may stand before it.
    pass([](const Card& c) { return c.is("NODE"); });
    pass([](const Card& c) { return c.is("ELEMENT"); });
    pass([](const Card& c) { return c.is("NSET") || c.is("ELSET"); });
    pass([](const Card& c) { return c.is("SURFACE"); });
    pass([](const Card& c) { return c.is("AMPLITUDE"); });
    pass([](const Card& c) { return c.is("CONTACT PAIR"); });
    for (Item& item : structure_.items)
      rest(item);
    require_coupling_kind();
    judge_steps();
    judge_temperature();
    require_whole();
  }

private:
  std::vector<Scope*> scopes() {
    std::vector<Scope*> list;
    for (auto& s : structure_.scopes)
      list.push_back(s.get());
    return list;
  }

  static void judge(Card& card) {
    if (!card.is_known()) {
      card.refuse("abut does not know this keyword; " + keyword_hint(card.name()));
      return;
    }
    const Keyword& k = *find_keyword(card.name());
    if (k.why_ignored)
      card.set_ignored(k.why_ignored);
    if (k.why_refused)
      card.refuse(k.why_refused);
  }

  template <class Which> void pass(const Which& which) {
    for (Item& item : structure_.items) {
      Card& card = *item.card;
      if (!which(card))
        continue;
      if (card.is("NODE"))
        read_nodes(card, *item.scope, model_);
      else if (card.is("ELEMENT"))
        read_elements(card, *item.scope, model_);
      else if (card.is("SURFACE"))
        read_surface(card, *item.scope, lookup_);
      else if (card.is("AMPLITUDE"))
        read_amplitude(card, model_);
      else if (card.is("CONTACT PAIR"))
        read_pair_card(item);
      else
        read_set(card, *item.scope, lookup_);
    }
  }

  void read_pair_card(Item& item) {
    if (item.step >= 0)
      item.card->refuse("abut's pairs stand before the steps; *MODEL CHANGE takes them out and in");
    read_pairs(*item.card, *item.scope, lookup_);
  }

  /// What the cards further down belong to.
  void enter(const Item& item) {
    while (step_ < item.step)
      read_step(*structure_.steps[std::size_t(++step_)], model_);
  }

  void rest(Item& item) {
    enter(item);
    Card& card = *item.card;
    const Scope& scope = *item.scope;
    if (const Keyword* k = find_keyword(card.name()); !k || k->why_refused)
      procedures_.insert(item.step); // perhaps the step's, and refused
    if (card.is("MATERIAL")) {
      read_material(card, model_);
      material_ = &model_.materials.at(key_of(name_of(card, card.required("NAME"))));
    } else if (card.is("ELASTIC") || card.is("HYPERELASTIC") || card.is("DENSITY") ||
               card.is("EXPANSION")) {
      read_material_part(card, material_);
    } else if (card.is("SOLID SECTION")) {
      read_section(card, scope, lookup_);
    } else if (card.is("RIGID BODY")) {
      read_rigid_body(card, scope, lookup_);
    } else if (card.is("COUPLING")) {
      require_coupling_kind();
      read_coupling(card, scope, lookup_);
      coupling_ = &card;
    } else if (card.is("KINEMATIC")) {
      read_kinematic(card, coupling_ ? &model_.rigid_bodies.back() : nullptr);
      coupling_ = nullptr;
    } else if (card.is("DISTRIBUTING")) {
      coupling_ = nullptr; // refused already
    } else if (card.is("SURFACE INTERACTION") || card.is("SURFACE BEHAVIOR") ||
               card.is("FRICTION") || card.is("CHANGE FRICTION")) {
      contact_law(item);
    } else if (card.is("TIE")) {
      read_tie(card, scope, lookup_);
    } else if (card.is("CLEARANCE")) {
      read_clearance(card, scope, lookup_);
    } else if (card.is("INITIAL CONDITIONS")) {
      read_initial(card, scope, lookup_);
    } else {
      history(item);
    }
  }

  void contact_law(Item& item) {
    Card& card = *item.card;
    if (card.is("SURFACE INTERACTION")) {
      read_interaction(card, model_);
      interaction_ = &model_.interactions.at(key_of(name_of(card, card.required("NAME"))));
    } else if (card.is("SURFACE BEHAVIOR")) {
      read_behavior(card, interaction_);
    } else if (card.is("CHANGE FRICTION")) {
      card.use();
      FrictionChange change;
      change.place = card.place();
      change.step = item.step;
      change.interaction = key_of(card.required("INTERACTION"));
      card.ignore({"AMPLITUDE"}, "the coefficient changes when the step begins");
      if (!model_.interactions.count(change.interaction))
        card.fail("there is no *SURFACE INTERACTION '" + change.interaction + "'");
      if (item.step < 0)
        card.fail("expected within a *STEP");
      card.note("the coefficient changes when the step begins");
      model_.friction_changes.push_back(change);
      changes_ = true;
    } else {
      read_friction(card, interaction_,
                    changes_ && item.step >= 0 ? &model_.friction_changes.back() : nullptr);
      changes_ = false;
    }
  }

  /// Cards of steps, and what may stand before them too.
  void history(Item& item) {
    Card& card = *item.card;
    const bool in_step = item.step >= 0;
    if (card.is("BOUNDARY")) {
      read_boundary(card, *item.scope, item.step, lookup_);
    } else if (card.is("CLOAD")) {
      read_forces(card, *item.scope, item.step, lookup_);
    } else if (card.is("DLOAD") || card.is("DSLOAD")) {
      read_loads(card, *item.scope, item.step, lookup_);
    } else if (card.is("MODEL CHANGE")) {
      read_model_change(card, *item.scope, item.step, lookup_);
    } else if (card.is("STATIC") || card.is("DYNAMIC")) {
      if (!in_step)
        card.fail("expected within a *STEP");
      if (!read_.insert(item.step).second)
        card.fail("the step has its procedure already");
      procedures_.insert(item.step);
      card.is("STATIC") ? read_static(card, model_.steps.back())
                        : read_dynamic(card, model_.steps.back());
    } else if (card.is("TEMPERATURE")) {
      temperature_ = &card;
      card.set_ignored("no material of the model expands");
    } else if (card.is("TRANSFORM")) {
      transform(item);
    } else if (card.is("HEADING")) {
      card.use();
      for (const DataLine& line : card.lines)
        if (model_.title.empty())
          model_.title = line.text;
    }
  }

  void transform(Item& item) {
    const auto set = item.card->parameter("NSET");
    item.card->parameter("TYPE");
    item.card->use();
    if (set)
      for (const int n : lookup_.nodes(*item.card, {item.card->place(), {}}, *set, *item.scope))
        transformed_[n] = item.card;
  }

  void require_coupling_kind() {
    if (coupling_)
      coupling_->refuse("expected a *KINEMATIC below it");
    coupling_ = nullptr;
  }

  void judge_steps() {
    for (std::size_t s = model_.steps.size(); s < structure_.steps.size(); ++s)
      read_step(*structure_.steps[s], model_);
    for (std::size_t s = 0; s < model_.steps.size(); ++s)
      if (!procedures_.count(static_cast<int>(s)))
        structure_.steps[s]->refuse("expected *STATIC or *DYNAMIC in it");
    for (std::size_t s = 1; s < model_.steps.size(); ++s) {
      if (model_.steps[s].finite != model_.steps[0].finite)
        structure_.steps[s]->refuse(
            "a step with NLGEOM behind one without: abut's materials are of "
            "one kind in all steps");
      if (model_.steps[s].dynamic != model_.steps[0].dynamic)
        structure_.steps[s]->refuse("*STATIC and *DYNAMIC: abut has one of both in a run");
    }
    const auto refuse_local = [&](const std::vector<Condition>& list) {
      for (const Condition& c : list)
        for (const int n : c.nodes)
          if (const auto found = transformed_.find(n); found != transformed_.end())
            found->second->refuse("directions of displacements or forces in line " +
                                  std::to_string(c.place.line) + ": abut's are along x, y and z");
    };
    refuse_local(model_.boundaries);
    refuse_local(model_.forces);
    for (const auto& [n, card] : transformed_)
      card->set_ignored("nothing is prescribed on its nodes");
  }

  void judge_temperature() {
    if (!temperature_)
      return;
    for (const auto& entry : model_.materials)
      if (entry.second.expands)
        temperature_->refuse("abut has no expansion by temperature, as material '" +
                             entry.second.name + "' has");
  }

  void require_whole() {
    const std::string first = model_.files[0] + ":1: ";
    if (model_.elements.empty())
      throw InputError(first + "expected elements, *ELEMENT");
    if (model_.steps.empty())
      throw InputError(first + "expected a *STEP");
  }

  Cards& cards_;
  Structure structure_;
  Model& model_;
  Lookup lookup_;
  int step_ = -1;
  std::set<int> read_;       ///< steps whose procedure has been read
  std::set<int> procedures_; ///< steps that have one, or what may be one
  Material* material_ = nullptr;
  Interaction* interaction_ = nullptr;
  Card* coupling_ = nullptr;
  Card* temperature_ = nullptr;
  bool changes_ = false;
  std::unordered_map<int, Card*> transformed_; ///< nodes with directions of their own
};

} // namespace

Model read_model(const std::string& text, const std::string& file, const ReadFile& read,
                 Report& report) {
  const ReadFile in_utf8 = [&](const std::string& path) { return translation::utf8(read(path)); };
  Cards cards(translation::utf8(text), file, in_utf8);
  Model model;
  model.files = cards.files();
  Reader(cards, model).run();
  report = cards.report();
  return model;
}

} // namespace abut::abaqus
