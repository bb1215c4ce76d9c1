#include "authoring/template_vocabulary.h"

#include <nlohmann/json.hpp>

#include "akb/table_words.h"
#include "core/text.h"
#include "logic/formula_words.h"
#include "scene/action.h"
#include "scene/simulator.h"
#include "templates/constraint_kinds.h"
#include "templates/phrasing.h"
#include "templates/purposes.h"
#include "templates/refinement_kinds.h"
#include "templates/sections.h"
#include "templates/word_meanings.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// Tables of words with a usage and a meaning.
template <class Table>
std::vector<VocabularyWord> used_words(const Table& table) {
  std::vector<VocabularyWord> words;
  for (const auto& row : table) {
    words.push_back({std::string(row.usage), std::string(row.usage), std::string(row.says)});
  }
  return words;
}

template <class Table>
std::vector<VocabularyWord> words_with_meanings(const Table& table) {
  std::vector<VocabularyWord> words;
  for (const auto& row : table) words.push_back({std::string(row.word), std::string(row.word), std::string(row.says)});
  return words;
}

VocabularyGroup sections() {
  VocabularyGroup group{
      "sections", "Sections", "The lists below (template name ...), each once and in any order.", {}, {}};
  for (const auto& section : template_sections()) {
    group.words.push_back({std::string(section.name), std::string(section.usage),
                           std::string(section.says) + (section.required ? "" : "; optional")});
  }
  return group;
}

VocabularyGroup refinements() {
  VocabularyGroup group{"refinements", "Refinements", "In (refinement ...).", {}, {}};
  for (const auto& kind : refinement_kinds()) {
    group.words.push_back({std::string(kind.name), std::string(kind.name),
                           std::string(kind.says) + " (" + std::string(name_of(kind.split)) + ")"});
  }
  return group;
}

VocabularyGroup purposes() {
  VocabularyGroup group{"purposes", "Purposes", "In (purpose ...).", {}, {}};
  for (const auto& kind : purpose_kinds())
    group.words.push_back({std::string(kind.name), std::string(kind.name), std::string(kind.says)});
  return group;
}

VocabularyGroup simulators() {
  VocabularyGroup group{"simulators", "Simulators", "In (simulators ...).", {}, {}};
  for (const auto simulator : kSimulators) {
    const std::string name(name_of(simulator));
    int actions = 0;
    for (const auto& action : all_actions()) actions += offers(action, simulator) ? 1 : 0;
    group.words.push_back({name, name, "offers " + std::to_string(actions) + " of the actions"});
  }
  return group;
}

VocabularyGroup affordances() {
  VocabularyGroup group{"affordances", "Affordances", "In (parameters (A - ...)): requirements on a category.", {}, {}};
  for (const auto& affordance : all_affordances()) {
    group.words.push_back(
        {std::string(affordance.name), std::string(affordance.name), std::string(affordance.meaning)});
  }
  group.groups.push_back({"kinds",
                          "Kinds of category",
                          "Used like affordances, but about the category itself.",
                          words_with_meanings(pseudo_affordance_meanings()),
                          {}});
  return group;
}

VocabularyGroup constraints() {
  VocabularyGroup group{"constraints", "Constraints", "In (constraints ...): constraints between categories.", {}, {}};
  for (const auto& kind : constraint_kinds()) {
    group.words.push_back({std::string(kind.name), std::string(kind.usage), std::string(kind.says)});
  }
  return group;
}

VocabularyGroup starts() {
  VocabularyGroup group{"init",
                        "Start constraints",
                        "In (init ...): the forms that grounding can make true.",
                        used_words(start_shapes()),
                        {}};
  group.groups.push_back({"literals", "Bodies", "The forms of body.", used_words(start_literal_forms()), {}});
  return group;
}

VocabularyGroup operators() {
  VocabularyGroup group{"operators", "Operators", "In goals; without the temporal ones also in :where.", {}, {}};
  VocabularyGroup temporal{"temporal",
                           "Temporal operators",
                           "Every predicate of a goal must be under one of these, or in a :where.",
                           {},
                           {}};
  for (const auto& known : kOperatorWords) {
    auto& words = is_temporal(known.op) ? temporal.words : group.words;
    words.push_back({std::string(known.word), std::string(known.usage), std::string(known.says)});
  }
  group.groups.push_back(std::move(temporal));
  VocabularyGroup comparisons{"comparisons", "Comparisons", "After count.", {}, {}};
  for (const auto& [comparison, says] : kComparisons) {
    const std::string symbol(symbol_of(comparison));
    comparisons.words.push_back({symbol, "(count " + symbol + " 2 (?x - D) f)", std::string(says)});
  }
  group.groups.push_back(std::move(comparisons));
  group.groups.push_back({"domains", "Domains", "For D in (?x - D).", used_words(kDomainForms), {}});
  return group;
}

std::string usage_of(const PredicateInfo& predicate) {
  std::string usage = "(" + std::string(predicate.name) + " ?x";
  if (predicate.arguments.size() < 2) return usage + ")";
  return usage + (predicate.arguments[1] == ArgumentKind::Symbol ? " word)" : " ?y)");
}

VocabularyGroup predicates() {
  VocabularyGroup group{"predicates", "Predicates", "Properties of objects, and relations between them.", {}, {}};
  const auto of = [](const char* name, const char* title, auto belongs) {
    VocabularyGroup part{name, title, "", {}, {}};
    for (const auto& predicate : all_predicates()) {
      if (belongs(predicate.arguments)) {
        part.words.push_back({std::string(predicate.name), usage_of(predicate), std::string(predicate.meaning)});
      }
    }
    return part;
  };
  using enum ArgumentKind;
  using Arguments = std::span<const ArgumentKind>;
  group.groups = {of("states", "Of an object", [](Arguments a) { return a.size() == 1; }),
                  of("words", "Of an object, with a word", [](Arguments a) { return a.size() == 2 && a[1] == Symbol; }),
                  of("relations", "Of two objects", [](Arguments a) { return a.size() == 2 && a[1] == Object; }),
                  of("rooms", "Of an object and a room", [](Arguments a) { return a.size() == 2 && a[1] == Room; })};
  return group;
}

VocabularyGroup slots() {
  VocabularyGroup group{"slots", "Slots", "In a phrasing of (instruction ...), in braces.", {}, {}};
  group.words.push_back({"A", "{A}", "mug"});
  for (const auto& form : slot_forms()) {
    group.words.push_back({std::string(form.name), "{A:" + std::string(form.name) + "}", std::string(form.example)});
  }
  return group;
}

VocabularyGroup actions() {
  VocabularyGroup group{"actions", "Actions", "The actions of an agent; templates do not mention them.", {}, {}};
  for (const auto& action : all_actions()) {
    std::vector<std::string> names;
    for (const auto simulator : kSimulators) {
      if (offers(action, simulator)) names.emplace_back(name_of(simulator));
    }
    std::string usage(action.name);
    switch (action.argument) {
      case ActionArgument::None:
        break;
      case ActionArgument::Object:
        usage += "(object)";
        break;
      case ActionArgument::ObjectOrRoom:
        usage += "(object or room)";
        break;
      case ActionArgument::Tool:
        usage += "(tool)";
        break;
    }
    group.words.push_back(
        {std::string(action.name), usage, std::string(action.effect) + " (" + join(names, ", ") + ")"});
  }
  return group;
}

void append_group(const VocabularyGroup& group, int level, std::string& page) {
  page += std::string(static_cast<std::size_t>(level), '#') + " " + group.title + "\n\n";
  if (!group.says.empty()) page += group.says + "\n\n";
  if (!group.words.empty()) {
    page += "| form | meaning |\n|---|---|\n";
    for (const auto& word : group.words) {
      page += "| `" + replace_all(word.usage, "|", "\\|") + "` | " + word.meaning + " |\n";
    }
    page += "\n";
  }
  for (const auto& part : group.groups) append_group(part, level + 1, page);
}

}  // namespace

std::vector<VocabularyGroup> template_vocabulary() {
  std::vector<VocabularyGroup> groups = {sections()};
  groups.push_back({"splits",
                    "Splits",
                    "The first three can be used in (split ...); the others are the splits of refined tasks.",
                    words_with_meanings(split_meanings()),
                    {}});
  for (auto& group : {purposes(), refinements(), simulators(), affordances(), constraints(), starts(), operators(),
                      predicates(), slots(), actions()}) {
    groups.push_back(group);
  }
  return groups;
}

Json vocabulary_json(const std::vector<VocabularyGroup>& groups) {
  const auto json_of = [](const auto& self, const std::vector<VocabularyGroup>& all) -> Json {
    Json list = Json::array();
    for (const auto& group : all) {
      Json words = Json::array();
      for (const auto& word : group.words) {
        words.push_back({{"word", word.word}, {"usage", word.usage}, {"meaning", word.meaning}});
      }
      Json one = {{"name", group.name}, {"title", group.title}, {"says", group.says}, {"words", std::move(words)}};
      if (!group.groups.empty()) one["groups"] = self(self, group.groups);
      list.push_back(std::move(one));
    }
    return list;
  };
  return {{"format", "unietp-vocabulary/1"}, {"groups", json_of(json_of, groups)}};
}

std::string vocabulary_page(const std::vector<VocabularyGroup>& groups) {
  std::string page =
      "# Vocabulary of the template language\n"
      "\n"
      "Generated by `unietp template vocabulary --markdown` from the tables that the parser uses; do not edit.\n"
      "`unietp template vocabulary --json` prints the same for editors. [templates.md](templates.md) describes the "
      "language.\n"
      "\n";
  for (const auto& group : groups) append_group(group, 2, page);
  page.pop_back();
  return page;
}

}  // namespace unietp
