#include "sense/question.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <vector>

#include "core/sort_unique.h"
#include "core/text.h"
#include "core/unknown_name.h"
#include "sense/action_roles.h"
#include "sense/word_kinds.h"

namespace unietp {
namespace {

/// A verb with a preposition, and the relation or state with a symbol that it means.
struct LinkVerb {
  std::string_view words, between;
  Predicate predicate;
};
constexpr std::array<LinkVerb, 15> kLinkVerbs{{{"place", "next to", Predicate::NextTo},
                                               {"place", "under", Predicate::Under},
                                               {"place", "inside", Predicate::Inside},
                                               {"place", "into", Predicate::Inside},
                                               {"place", "in", Predicate::Inside},
                                               {"place", "onto", Predicate::On},
                                               {"place", "on", Predicate::On},
                                               {"attach", "to", Predicate::Attached},
                                               {"bring", "into", Predicate::InRoom},
                                               {"bring", "to", Predicate::InRoom},
                                               {"fill", "with", Predicate::Filled},
                                               {"cover", "with", Predicate::Covered},
                                               {"spread", "over", Predicate::Covered},
                                               {"spread", "on", Predicate::Covered},
                                               {"wipe", "off", Predicate::Covered}}};

Error usage(std::string message) { return {Error::Kind::Usage, "question", {}, std::move(message)}; }

std::vector<std::string> verbs() {
  std::vector<std::string> all{"dust", "throw away"};
  for (const StateAction& action : state_actions()) {
    for (const auto verb : action.verbs) {
      if (!verb.empty()) all.emplace_back(verb);
    }
  }
  for (const auto& verb : kLinkVerbs) all.emplace_back(verb.words);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

constexpr std::size_t kMostSuggested = 4;
constexpr std::size_t kShortestEnding = 3;  // letters

/// The categories that people call so, else those whose names have the word in them, else those whose names the word
/// ends with ("notebook": book), else the one of the most similar name. Sorted; at most kMostSuggested.
std::vector<std::string> suggested(const std::string& name, const Knowledge& knowledge) {
  const std::string asked = normal_word(name);
  std::vector<std::string> called, containing, ending, names;
  for (const Alias& alias : knowledge.aliases())
    if (alias.kind == AliasKind::Synonym && normal_word(alias.text) == asked) called.push_back(alias.category);
  for (const auto& category : knowledge.categories()) {
    names.push_back(category.name);
    if (("_" + normal_word(category.display) + "_").find("_" + asked + "_") != std::string::npos)
      containing.push_back(category.name);
    const std::string own = normal_word(category.display);
    if (own.size() >= kShortestEnding && asked.ends_with(own)) ending.push_back(category.name);
  }
  auto& found = !called.empty() ? called : !containing.empty() ? containing : ending;
  sort_unique(found);
  if (found.size() > kMostSuggested) found.resize(kMostSuggested);
  if (!found.empty()) return found;
  const auto near = nearest_name(name, names);
  return near.empty() ? found : std::vector<std::string>{near};
}

Error no_category(const std::string& name, const Knowledge& knowledge) {
  const auto near = suggested(name, knowledge);
  const std::string simulator(name_of(knowledge.simulator()));
  return usage(simulator + " has no category \"" + name + "\"" +
               (near.empty() ? "" : ", did you mean \"" + join(near, "\" or \"") + "\"") + "; `unietp knowledge show " +
               simulator + "` lists them");
}

Result<std::string> category_of(std::string_view words, const Knowledge& knowledge) {
  const auto asked = normal_word(trim(words));
  for (const auto& category : knowledge.categories()) {
    if (normal_word(category.name) == asked || normal_word(category.display) == asked ||
        lower(category.name) == lower(trim(words)))
      return category.name;
  }
  return no_category(std::string(trim(words)), knowledge);
}

/// The rest of the text behind a verb; nullopt when it does not begin so.
std::optional<std::string_view> after(std::string_view text, std::string_view verb) {
  if (text.size() <= verb.size() || lower(text.substr(0, verb.size())) != verb || text[verb.size()] != ' ')
    return std::nullopt;
  return trim(text.substr(verb.size()));
}

Result<Formula> stated(Predicate predicate, std::string_view words, const Knowledge& knowledge) {
  const auto category = category_of(words, knowledge);
  if (!category) return category.error();
  return exists("a", of_category(*category), at_end(atom(predicate, {"a"})));
}

Result<Formula> related(Predicate predicate, std::string_view first, std::string_view second,
                        const Knowledge& knowledge) {
  const auto thing = category_of(first, knowledge);
  if (!thing) return thing.error();
  const bool room = predicate == Predicate::InRoom;
  const auto other = room ? Result<std::string>(normal_word(second)) : category_of(second, knowledge);
  if (!other) return other.error();
  return exists("a", of_category(*thing), exists("b", of_category(*other), at_end(atom(predicate, {"a", "b"}))));
}

Result<Formula> covered(bool wiped, Predicate predicate, std::string_view thing, std::string_view substance,
                        const Knowledge& knowledge) {
  const auto category = category_of(thing, knowledge);
  if (!category) return category.error();
  auto state = atom_with_symbol(predicate, "a", normal_word(substance));
  return exists("a", of_category(*category), at_end(wiped ? negation(std::move(state)) : std::move(state)));
}

Result<Formula> thrown(std::string_view words, const Knowledge& knowledge) {
  for (const auto* can : {"GarbageCan", "garbagecan", "trashcan", "trash_can"}) {
    if (knowledge.find(can) != nullptr) return related(Predicate::Inside, words, can, knowledge);
  }
  return usage("this simulator has no garbage can");
}

Result<Formula> linked(const LinkVerb& verb, std::string_view rest, std::size_t at, const Knowledge& knowledge) {
  const auto first = trim(rest.substr(0, at)), second = trim(rest.substr(at + verb.between.size() + 2));
  const bool substance_first = verb.words == "spread" || verb.words == "wipe";
  if (verb.predicate == Predicate::Filled || verb.predicate == Predicate::Covered)
    return covered(verb.words == "wipe", verb.predicate, substance_first ? second : first,
                   substance_first ? first : second, knowledge);
  return related(verb.predicate, first, second, knowledge);
}

/// "heat Potato in Microwave": the thing is put there, and then comes to be in the state.
std::optional<Result<Formula>> done_at(Predicate state, std::string_view rest, const Knowledge& knowledge) {
  for (const auto& [between, relation] : {std::pair<std::string_view, Predicate>{" in ", Predicate::Inside},
                                          std::pair<std::string_view, Predicate>{" on ", Predicate::On}}) {
    const auto at = lower(rest).find(between);
    if (at == std::string::npos) continue;
    auto place = related(relation, rest.substr(0, at), rest.substr(at + between.size()), knowledge);
    if (!place) return place;
    Formula& there = place->children.front().children.front();  // below both quantifiers: at-end
    there = conjunction({there, at_end(atom(state, {"a"}))});
    return place;
  }
  return std::nullopt;
}

Result<Formula> read_one(std::string_view text, const Knowledge& knowledge) {
  if (const auto rest = after(text, "throw away")) return thrown(*rest, knowledge);
  if (const auto rest = after(text, "dust")) return covered(true, Predicate::Covered, *rest, "dust", knowledge);
  std::vector<std::string> accepted;
  for (const auto& verb : kLinkVerbs) {
    auto rest = after(text, verb.words);
    if (!rest && verb.words == "place") rest = after(text, "put");
    if (!rest) continue;
    accepted.push_back("\"" + std::string(verb.between) + "\"");
    const auto at = lower(*rest).find(" " + std::string(verb.between) + " ");
    if (at != std::string::npos) return linked(verb, *rest, at, knowledge);
  }
  if (!accepted.empty()) return usage("expected one of " + join(accepted, ", ") + " in \"" + std::string(text) + "\"");
  for (const StateAction& action : state_actions()) {
    for (const auto verb : action.verbs) {
      const auto rest = verb.empty() ? std::nullopt : after(text, verb);
      if (!rest) continue;
      if (auto there = done_at(action.predicate, *rest, knowledge)) return std::move(*there);
      return stated(action.predicate, *rest, knowledge);
    }
  }
  return unknown_name_error("question", split(text, ' ').front(), verbs());
}

/// What can be in or on a thing, as the simulator's facts have it. Sorted.
std::vector<std::string> substances_of(const Knowledge& knowledge) {
  std::vector<std::string> all{"dust", "stain"};
  all.insert(all.end(), kLiquids.begin(), kLiquids.end());
  for (const Effect& effect : knowledge.effects())
    if (effect.treatment == Treatment::Fills || effect.treatment == Treatment::Dispenses) all.push_back(effect.gives);
  sort_unique(all);
  return all;
}

/// The variables that a goal takes for rooms.
void find_rooms(const Formula& part, std::set<std::string>& rooms) {
  if (part.op == Formula::Op::Atom && part.predicate == Predicate::InRoom && part.terms.size() > 1)
    rooms.insert(part.terms[1].name);
  for (const Formula& test : part.domain.where) find_rooms(test, rooms);
  for (const Formula& child : part.children) find_rooms(child, rooms);
}

Result<Done> check_part(const Formula& part, const Knowledge& knowledge, const WordKinds& words,
                        const std::set<std::string>& rooms) {
  for (const Domain::Member& member : part.domain.members) {
    if (!rooms.contains(part.variable) && knowledge.find(member.category) == nullptr)
      return no_category(member.category, knowledge);
  }
  for (const Term& term : part.terms) {
    const bool substance = part.predicate == Predicate::Filled || part.predicate == Predicate::Covered;
    if (!substance || term.kind != Term::Kind::Symbol || words.of_word(term.name)) continue;
    const auto known = substances_of(knowledge);
    if (std::find(known.begin(), known.end(), term.name) == known.end())
      return unknown_name_error("substance", term.name, known);
  }
  for (const auto* parts : {&part.domain.where, &part.children}) {
    for (const Formula& each : *parts)
      if (auto checked = check_part(each, knowledge, words, rooms); !checked) return checked;
  }
  return Done{};
}

}  // namespace

Result<Done> check_names(const Formula& goal, const Knowledge& knowledge, const WordKinds& words) {
  std::set<std::string> rooms;
  find_rooms(goal, rooms);
  return check_part(goal, knowledge, words, rooms);
}

Result<Formula> read_question(std::string_view text, const Knowledge& knowledge) {
  constexpr std::string_view then = " then ";
  const auto at = text.find(then);
  if (at == std::string_view::npos) return read_one(trim(text), knowledge);
  auto first = read_one(trim(text.substr(0, at)), knowledge);
  if (!first) return first;
  auto second = read_question(text.substr(at + then.size()), knowledge);
  if (!second) return second;
  // One thing, first in one state and then in the other, when both are about the same category.
  if (first->domain == second->domain) {
    Formula both = *first;
    both.children = {conjunction({first->children.front(), second->children.front()})};
    return both;
  }
  return conjunction({std::move(*first), std::move(*second)});
}

}  // namespace unietp
