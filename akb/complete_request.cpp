#include "akb/complete_request.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "akb/table_words.h"
#include "core/text.h"

namespace unietp {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr const char* kTask =
    "You fill gaps in tables of household objects for a simulator of home robots. Answer in plain English and in "
    "meters "
    "and kilograms, for a typical object of each category in an ordinary home. Answer with JSON: {\"categories\": "
    "[...]}, one entry for each category that you are asked about, with its name as it is given. Leave a list empty "
    "rather than guess.";

const char* rule_of(FactKind kind) {
  switch (kind) {
    case FactKind::Size:
      return "size: full extents as it usually stands or lies: width (left to right for one who stands before it), "
             "depth, height.";
    case FactKind::Mass:
      return "mass: when empty.";
    case FactKind::Synset:
      return "synset: WordNet 3.0's noun sense as lemma.n.NN, such as mug.n.04; an empty text when none fits or you "
             "are "
             "not sure of the number.";
    case FactKind::Aliases:
      return "aliases: up to 3 other names in lower case that people would understand at once and that fit no other "
             "household object.";
    case FactKind::Function:
      return "function: up to 2 phrases that say what it is for without naming it, such as \"something to drink "
             "from\"; "
             "they begin with something, somewhere, someone, some, a, an or the.";
    case FactKind::Context:
      return "context: up to 2 short sentences that somebody might say who needs it, such as \"I must get up early "
             "tomorrow.\"";
    case FactKind::Placements:
      return "placements: where it is kept or left in a home, as relation (on or inside), receptacle (a name from the "
             "list) and likelihood (a share of 1); the most usual first, up to 8.";
    case FactKind::Affordances:
      return "affordances: what is true of it, from the list.";
  }
  return "";
}

OrderedJson list_of(const OrderedJson& items) { return {{"type", "array"}, {"items", items}}; }
OrderedJson object_of(const OrderedJson& properties) {
  OrderedJson required = OrderedJson::array();
  for (const auto& [name, form] : properties.items()) required.push_back(name);
  return {{"type", "object"}, {"properties", properties}, {"required", required}, {"additionalProperties", false}};
}

OrderedJson form_of(FactKind kind) {
  OrderedJson number = {{"type", "number"}}, text = {{"type", "string"}};
  switch (kind) {
    case FactKind::Size:
      return object_of({{"width", number}, {"depth", number}, {"height", number}});
    case FactKind::Mass:
      return number;
    case FactKind::Synset:
      return text;
    case FactKind::Aliases:
    case FactKind::Function:
    case FactKind::Context:
      return list_of(text);
    case FactKind::Placements:
      return list_of(object_of({{"relation", {{"type", "string"}, {"enum", {"on", "inside"}}}},
                                {"receptacle", text},
                                {"likelihood", number}}));
    case FactKind::Affordances:
      return list_of({{"type", "string"}, {"enum", affordance_names()}});
  }
  return {};
}

OrderedJson schema_of(const CompletionBatch& batch) {
  OrderedJson entry = {{"category", {{"type", "string"}, {"enum", batch.categories}}}};
  for (const auto kind : batch.facts) entry[std::string(name_of(kind))] = form_of(kind);
  return object_of({{"categories", list_of(object_of(entry))}});
}

/// One line of what is known, without what is asked.
std::string known_of(const Category& c, const Tables& tables, const CompletionBatch& batch) {
  const auto asked = [&](FactKind kind) {
    return std::find(batch.facts.begin(), batch.facts.end(), kind) != batch.facts.end();
  };
  std::string line = "- " + c.name + ": " + c.display + ", plural " + c.plural + "; " +
                     (c.movable ? "can be carried" : "furniture or fixed") + "; shape " +
                     std::string(name_of(c.archetype));
  if (!asked(FactKind::Size))
    line += "; " + number_text(c.size.x()) + " x " + number_text(c.size.y()) + " x " + number_text(c.size.z()) + " m";
  if (!asked(FactKind::Mass)) line += "; " + number_text(c.mass) + " kg";
  const auto add = [&](const std::string& label, const std::vector<std::string>& words) {
    if (!words.empty()) line += "; " + label + " " + join(words, ", ");
  };
  add("in", c.rooms);
  add("of", c.materials);
  std::vector<std::string> affordances, synonyms, functions;
  for (const auto& f : tables.affordances) {
    if (f.category == c.name) affordances.push_back(f.affordance);
  }
  for (const auto& a : tables.aliases) {
    if (a.category == c.name && a.kind == AliasKind::Synonym) synonyms.push_back(a.text);
    if (a.category == c.name && a.kind == AliasKind::Function) functions.push_back(a.text);
  }
  add("is", affordances);
  add("also called", synonyms);
  add("serves as", functions);
  return line + "\n";
}

std::vector<const Category*> members_of(const Tables& tables, const CompletionBatch& batch) {
  std::vector<const Category*> members;
  for (const auto& c : tables.categories) {
    if (std::find(batch.categories.begin(), batch.categories.end(), c.name) != batch.categories.end())
      members.push_back(&c);
  }
  return members;
}

/// The things that hold others, by relation, into which something of the batch fits.
std::string receptacles_for(const Tables& tables, const std::vector<const Category*>& members) {
  std::map<std::string, std::set<std::string, std::less<>>, std::less<>> affordances;
  for (const auto& f : tables.affordances) affordances[f.category].insert(f.affordance);
  std::string text;
  for (const Predicate relation : {Predicate::On, Predicate::Inside}) {
    std::vector<std::string> names;
    for (const auto& receptacle : tables.categories) {
      const auto& holds = affordances[receptacle.name];
      if (std::any_of(members.begin(), members.end(),
                      [&](const Category* c) { return can_be_kept(*c, relation, receptacle, holds); }))
        names.push_back(receptacle.name);
    }
    text += "Receptacles for " + std::string(info(relation).name) + ": " + join(names, ", ") + "\n";
  }
  return text;
}

}  // namespace

std::vector<CompletionBatch> completion_batches(const Tables& tables, const std::vector<FactKind>& facts, int size) {
  const auto stated = stated_by(tables);
  std::map<std::vector<FactKind>, std::vector<std::string>> lacking;
  for (const auto& c : tables.categories) {
    std::vector<FactKind> lacks;
    for (const auto kind : all_fact_kinds()) {
      if (std::find(facts.begin(), facts.end(), kind) != facts.end() && !is_stated(stated, kind, c.name))
        lacks.push_back(kind);
    }
    if (!lacks.empty()) lacking[lacks].push_back(c.name);
  }
  std::vector<CompletionBatch> batches;
  const auto step = static_cast<std::size_t>(std::max(1, size));
  for (const auto& [kinds, names] : lacking) {
    for (std::size_t at = 0; at < names.size(); at += step) {
      const auto end = std::min(names.size(), at + step);
      batches.push_back(
          {{names.begin() + static_cast<std::ptrdiff_t>(at), names.begin() + static_cast<std::ptrdiff_t>(end)}, kinds});
    }
  }
  return batches;
}

LlmRequest completion_request(const Tables& tables, const CompletionBatch& batch) {
  LlmRequest request;
  request.name = "completed_facts";
  request.schema = schema_of(batch).dump();
  request.system = kTask;
  std::vector<std::string> asked;
  for (const auto kind : batch.facts) {
    request.system += std::string("\n") + rule_of(kind);
    asked.emplace_back(name_of(kind));
  }
  request.user = "Give " + join(asked, ", ") + " of each of these categories:\n";
  const auto members = members_of(tables, batch);
  for (const auto* c : members) request.user += known_of(*c, tables, batch);
  if (std::find(batch.facts.begin(), batch.facts.end(), FactKind::Placements) != batch.facts.end())
    request.user += receptacles_for(tables, members);
  if (std::find(batch.facts.begin(), batch.facts.end(), FactKind::Affordances) != batch.facts.end())
    request.user += "Affordances: " + join(affordance_names(), ", ") + "\n";
  return request;
}

}  // namespace unietp
