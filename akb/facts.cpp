#include "akb/facts.h"

#include <algorithm>

#include "akb/table_words.h"
#include "akb/tables.h"
#include "core/text.h"

namespace unietp {
namespace {

bool among(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> joined(std::vector<std::string> names, const std::vector<std::string>& more) {
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

Error unknown_fact(std::string_view text, std::string_view word, bool with_object) {
  const auto names = with_object ? joined(joined(relation_names(), effect_names()), {"alias", "asset"})
                                 : joined(fact_properties(), affordance_names());
  const auto near = nearest_name(word, names);
  return {Error::Kind::Usage,
          "fact",
          {},
          "unknown fact '" + std::string(text) + "'" + (near.empty() ? "" : "; did you mean '" + near + "'?") +
              (with_object ? "; accepted before a colon: " : "; accepted without a colon: ") + join(names, ", ")};
}

/// Cuts `:detail` off the end.
std::string take_detail(std::string& object, std::string_view detail) {
  const std::string end = ":" + std::string(detail);
  if (!object.ends_with(end)) return "";
  object.resize(object.size() - end.size());
  return std::string(detail);
}

/// Collects the facts of a category; a second value of one name is joined to the first.
class Collector {
 public:
  explicit Collector(std::string category) : category_(std::move(category)) {}
  void add(std::string name, std::string value, const Source& source) {
    if (!facts_.empty() && facts_.back().name == name) {
      facts_.back().value += "|" + value;
    } else {
      facts_.push_back({category_, std::move(name), std::move(value), source});
    }
  }
  void add_unless_empty(std::string name, const std::string& value, const Source& source) {
    if (!value.empty()) add(std::move(name), value, source);
  }
  std::vector<Fact> take() { return std::move(facts_); }

 private:
  std::string category_;
  std::vector<Fact> facts_;
};

void add_properties(Collector& into, const Category& c) {
  into.add("display", c.display, c.source);
  into.add("plural", c.plural, c.source);
  into.add_unless_empty("synset", c.synset, c.synset_source);
  into.add("countable", c.countable ? "true" : "false", c.source);
  into.add("movable", c.movable ? "true" : "false", c.source);
  into.add("archetype", std::string(name_of(c.archetype)), c.source);
  into.add("size", size_text(c.size), c.size_source);
  into.add("mass", number_text(c.mass), c.mass_source);
  into.add_unless_empty("rooms", join(c.rooms, "|"), c.source);
  into.add_unless_empty("colours", join(c.colors, "|"), c.source);
  into.add_unless_empty("materials", join(c.materials, "|"), c.source);
}

void add_placements(Collector& into, const Knowledge& knowledge, const std::string& name) {
  for (const Predicate relation : kPlacementRelations) {
    for (const Placement* p : knowledge.placements_of(name, relation)) {
      const std::string fact = std::string(info(relation).name) + ":" + p->receptacle;
      into.add(fact, number_text(p->likelihood), p->source);
      into.add(fact + ":capacity", std::to_string(p->capacity), p->source);
    }
  }
}

void add_effects(Collector& into, const Knowledge& knowledge, const std::string& name) {
  for (const TreatmentInfo& treatment : all_treatments()) {
    const auto rows = knowledge.effects_of(name, treatment.treatment);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Effect& e = *rows[i];
      const std::string fact = std::string(treatment.name) + ":" + e.target;
      const std::string given = e.gives.empty() ? "true" : e.gives;
      into.add(fact, e.amount > 0 ? std::to_string(e.amount) + " " + given : given, e.source);
      const bool last = i + 1 == rows.size() || rows[i + 1]->target != e.target;
      if (last) into.add_unless_empty(fact + ":needs", join(names_of(e.needs), "|"), e.source);
    }
  }
}

void add_aliases(Collector& into, const Knowledge& knowledge, const std::string& name) {
  std::vector<const Alias*> aliases;
  for (const AliasKind kind : kAliasKinds) {
    const auto some = knowledge.aliases_of(name, kind);
    aliases.insert(aliases.end(), some.begin(), some.end());
  }
  std::stable_sort(aliases.begin(), aliases.end(), [](const Alias* a, const Alias* b) { return a->text < b->text; });
  for (const Alias* alias : aliases) into.add("alias:" + alias->text, std::string(name_of(alias->kind)), alias->source);
}

}  // namespace

const std::vector<std::string>& fact_properties() {
  static const std::vector<std::string> names{"display", "plural", "synset", "countable", "movable",  "archetype",
                                              "size",    "mass",   "rooms",  "colours",   "materials"};
  return names;
}

Result<FactName> parse_fact(std::string_view text) {
  const auto colon = text.find(':');
  FactName fact;
  fact.word = text.substr(0, colon);
  if (colon == std::string_view::npos) {
    const bool property = among(fact_properties(), fact.word);
    if (!property && !among(affordance_names(), fact.word)) return unknown_fact(text, fact.word, false);
    fact.kind = property ? FactName::Kind::Property : FactName::Kind::Affordance;
    return fact;
  }
  fact.object = text.substr(colon + 1);
  if (fact.word == "alias") {
    fact.kind = FactName::Kind::Alias;
  } else if (fact.word == "asset") {
    fact.kind = FactName::Kind::Asset;
  } else if (placement_relation_named(fact.word)) {
    fact.kind = FactName::Kind::Placement;
    fact.detail = take_detail(fact.object, "capacity");
  } else if (treatment_named(fact.word)) {
    fact.kind = FactName::Kind::Effect;
    fact.detail = take_detail(fact.object, "needs");
  } else {
    return unknown_fact(text, fact.word, true);
  }
  if (fact.object.empty()) {
    return Error{Error::Kind::Usage,
                 "fact",
                 {},
                 "nothing after the colon of '" + std::string(text) + "'; expected a name, as in " + fact.word +
                     (fact.kind == FactName::Kind::Alias ? ":cup" : ":Mug")};
  }
  return fact;
}

std::string to_text(const FactName& fact) {
  return fact.word + (fact.object.empty() ? "" : ":" + fact.object) + (fact.detail.empty() ? "" : ":" + fact.detail);
}

std::string size_text(const Vec3& size) {
  return number_text(size.x()) + " x " + number_text(size.y()) + " x " + number_text(size.z());
}

std::vector<Fact> facts_of(const Knowledge& knowledge, const Category& category) {
  Collector facts(category.name);
  add_properties(facts, category);
  for (const AffordanceFact* f : knowledge.affordance_facts_of(category.name))
    facts.add(f->affordance, "true", f->source);
  add_placements(facts, knowledge, category.name);
  add_effects(facts, knowledge, category.name);
  add_aliases(facts, knowledge, category.name);
  for (const Asset* a : knowledge.asset_rows_of(category.name))
    facts.add("asset:" + a->name, size_text(a->size), a->source);
  return facts.take();
}

}  // namespace unietp
