#include "annotator/home_sentences.h"

#include <algorithm>
#include <array>

#include "annotator/words_for_writing.h"
#include "core/sort_unique.h"

namespace unietp {
namespace {

using P = Predicate;

constexpr double kLikely = 0.05;  // of a place that knowledge base rows name for a thing

/// The categories that a goal puts somewhere.
std::vector<std::string> moved_by(const Formula& part, const Formula& goal) {
  std::vector<std::string> found;
  const bool put = part.op == Formula::Op::Atom && (part.predicate == P::On || part.predicate == P::Inside);
  if (const Formula* binder = put ? binder_of(goal, part.terms[0].name) : nullptr)
    for (const Domain::Member& member : binder->domain.members) found.push_back(member.category);
  for (const Formula& child : part.children)
    for (std::string& thing : moved_by(child, goal)) found.push_back(std::move(thing));
  return found;
}

class SentenceWriter {
 public:
  SentenceWriter(const Trace& start, const Formula& goal, const std::vector<std::string>& own,
                 const Knowledge& knowledge, const NounTable& nouns)
      : start_(start),
        facts_(start.states.front()),
        own_(own),
        places_(places_of_all(moved_by(goal, goal))),
        knowledge_(knowledge),
        nouns_(nouns) {}

  std::vector<std::string> sentences() {
    const auto size = static_cast<std::uint32_t>(start_.entities.size());
    for (std::uint32_t i = 0; i < size; ++i) {
      const EntityIndex thing(i);
      if (start_.entities[thing].kind != Entity::Kind::Object || !facts_.exists(thing) || name_of(thing).empty())
        continue;
      for (const auto& [relation, place] : facts_.relations(thing)) tell_place(thing, relation, place);
    }
    sort_unique(sentences_);
    return std::move(sentences_);
  }

 private:
  /// Where the things of these categories are.
  std::vector<EntityIndex> places_of_all(const std::vector<std::string>& categories) const {
    std::vector<EntityIndex> found;
    for (const std::string& category : categories)
      for (const EntityIndex thing : start_.entities.of(of_category(category)))
        for (const auto& [relation, place] : facts_.relations(thing))
          if (relation == P::On || relation == P::Inside) found.push_back(place);
    return found;
  }

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

  /// "The book can stay where it is.", of the only one, beside something that is to be moved.
  void tell_place(EntityIndex thing, P relation, EntityIndex place) {
    const Entity &here = start_.entities[thing], &there = start_.entities[place];
    if (std::find(places_.begin(), places_.end(), place) == places_.end()) return;
    const auto *category = knowledge_.find(here.category), *holder = knowledge_.find(there.category);
    if (category == nullptr || holder == nullptr || holder->movable || nouns_.display(there.category) == nullptr)
      return;
    if (relation != P::On && relation != P::Inside) return;
    const auto* known = knowledge_.placement(here.category, relation, there.category);
    if (!category->movable || known == nullptr || known->likelihood < kLikely) return;
    const std::string name = name_of(thing);
    if (alike(thing) != 1 || name.ends_with("door") || name.ends_with("drawer")) return;
    sentences_.push_back("The " + name + " can stay where it is.");
    sentences_.push_back("You can leave the " + name + " where it is.");
  }

  const Trace& start_;
  const Facts& facts_;
  const std::vector<std::string>& own_;
  std::vector<EntityIndex> places_;  // where the things are that are to be moved
  const Knowledge& knowledge_;
  const NounTable& nouns_;
  std::vector<std::string> sentences_;
};

/// Things at home of the category or room type.
std::size_t number_of(const Domain::Member& member, const Trace& start, const NounTable& nouns) {
  if (!nouns.is_room_type(member.category)) return start.entities.of(of_category(member.category)).size();
  const auto& all = start.entities;
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [&](const Entity& one) { return one.category == member.category; }));
}

}  // namespace

bool can_be_said(const std::string& sentence, const Trace& start, const NounTable& nouns) {
  if (start.states.empty()) return true;
  const auto words = tokens_of(sentence);
  for (std::size_t i = 0; i < words.size();) {
    const auto noun = nouns.noun_at(words, i);
    const std::size_t next = i + std::max<std::size_t>(noun.length, 1);
    const bool measures = next < words.size() && words[next].text == "of";
    std::size_t there = 0;
    bool known = false;
    for (const Domain& domain : noun.nouns) {
      known |= domain.kind == Domain::Kind::Categories;
      for (const Domain::Member& member : domain.members) there += number_of(member, start, nouns);
    }
    const std::size_t least = noun.plural && i > 0 && words[i - 1].text == "those" ? 2 : 1;
    const auto before = [&](std::size_t back) { return i >= back ? std::string_view(words[i - back].text) : ""; };
    const bool is_verb = before(1) == "to", is_made = before(1) == "a" && before(2) == "write";
    if (known && !measures && !is_verb && !is_made && there < least) return false;
    i = next;
  }
  return true;
}

std::vector<std::string> home_sentences(const Trace& start, const Formula& goal, const std::vector<std::string>& own,
                                        const Knowledge& knowledge, const NounTable& nouns, Rng rng) {
  if (start.states.empty()) return {};
  auto sentences = SentenceWriter(start, goal, own, knowledge, nouns).sentences();
  rng.shuffle(sentences);
  return sentences;
}

}  // namespace unietp
