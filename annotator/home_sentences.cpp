#include "annotator/home_sentences.h"

#include <algorithm>
#include <array>

#include "annotator/words_for_writing.h"
#include "core/sort_unique.h"

namespace unietp {
namespace {

using P = Predicate;

constexpr double kLikely = 0.05;  // of a place that knowledge base rows name for a thing
constexpr std::array kNoticed{P::PowerOn, P::Open};

class Teller {
 public:
  Teller(const Trace& start, const std::vector<std::string>& own, const Knowledge& knowledge, const NounTable& nouns)
      : start_(start), facts_(start.states.front()), own_(own), knowledge_(knowledge), nouns_(nouns) {}

  std::vector<std::string> sentences() {
    const auto size = static_cast<std::uint32_t>(start_.entities.size());
    for (std::uint32_t i = 0; i < size; ++i) {
      const EntityIndex thing(i);
      if (start_.entities[thing].kind != Entity::Kind::Object || !facts_.exists(thing) || name_of(thing).empty())
        continue;
      for (const P state : kNoticed) tell_state(thing, state);
      for (const auto& [relation, place] : facts_.relations(thing)) tell_place(thing, relation, place);
    }
    sort_unique(told_);
    return std::move(told_);
  }

 private:
  std::size_t alike(EntityIndex entity) const {
    return start_.entities.of(of_category(start_.entities[entity].category)).size();
  }

  /// "" for what is part of the task, or has no name that means it alone.
  std::string name_of(EntityIndex entity) const {
    const std::string& category = start_.entities[entity].category;
    if (std::find(own_.begin(), own_.end(), category) != own_.end()) return "";
    const auto* name = nouns_.display(category);
    if (name == nullptr || !name->countable) return "";
    const auto read = nouns_.noun_at(tokens_of(name->singular), 0);
    return read.nouns.size() == 1 && read.length == tokens_of(name->singular).size() ? name->singular : "";
  }

  void tell_state(EntityIndex thing, P state) {
    if (alike(thing) != 1 || !facts_.holds(state, thing)) return;
    told_.push_back("The " + name_of(thing) + " is " + state_word(state) + ", but never mind that.");
  }

  void tell_place(EntityIndex thing, P relation, EntityIndex place) {
    const std::string where = name_of(place);
    if (where.empty()) return;
    const Entity &here = start_.entities[thing], &there = start_.entities[place];
    const auto* category = knowledge_.find(here.category);
    if (category == nullptr) return;
    if (relation != P::On && relation != P::Inside) return;
    const auto* known = knowledge_.placement(here.category, relation, there.category);
    if (!category->movable || known == nullptr || known->likelihood < kLikely) return;
    const std::string at = (relation == P::On ? " on the " : " in the ") + where;
    if (alike(place) != 1) return;
    if (alike(thing) == 1) told_.push_back("Never mind the " + name_of(thing) + at + ".");
    told_.push_back("There's " + with_article(name_of(thing)) + at + ", but never mind that.");
  }

  const Trace& start_;
  const Facts& facts_;
  const std::vector<std::string>& own_;
  const Knowledge& knowledge_;
  const NounTable& nouns_;
  std::vector<std::string> told_;
};

}  // namespace

std::vector<std::string> home_sentences(const Trace& start, const std::vector<std::string>& own,
                                        const Knowledge& knowledge, const NounTable& nouns, Rng rng) {
  if (start.states.empty()) return {};
  auto told = Teller(start, own, knowledge, nouns).sentences();
  rng.shuffle(told);
  return told;
}

}  // namespace unietp
