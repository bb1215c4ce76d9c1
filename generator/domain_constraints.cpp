#include "generator/domain_constraints.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_set>

#include "akb/attributes.h"
#include "core/text.h"
#include "templates/constraint_kinds.h"

namespace unietp {
namespace {

using Meaning = ConstraintKind::Meaning;

/// Names in the knowledge base, or in a template.
using Names = std::vector<std::string_view>;

template <class Name>
std::vector<Name> sorted_unique(std::vector<Name> names) {
  if (!std::is_sorted(names.begin(), names.end())) std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

bool is_slice(std::string_view argument) { return argument.ends_with("/slice"); }

/// Whether all categories that a place of a constraint stands for pass the test: one, none when it is not bound, or the
/// pieces of `A/slice`.
template <class Test>
bool all_categories_of(const std::string& argument, const Binding& binding, const Knowledge& knowledge,
                       const Test& test) {
  if (!is_slice(argument)) {  // by far the most, so nothing is copied
    const auto* category = bound_to(binding, argument);
    return category == nullptr || test(*category);
  }
  const auto* whole = bound_to(binding, placeholder_use(argument).name);
  if (whole == nullptr) return true;
  const auto slices = slices_of(*whole, knowledge);
  return std::all_of(slices.begin(), slices.end(), test);
}

/// The first of these categories; "" when there is none.
std::string first_category_of(const std::string& argument, const Binding& binding, const Knowledge& knowledge) {
  std::string first;
  all_categories_of(argument, binding, knowledge, [&](const std::string& category) {
    first = category;
    return false;
  });
  return first;
}

bool placement_holds(const DomainConstraint& constraint, const ConstraintKind& kind, const Binding& binding,
                     const Knowledge& knowledge) {
  const int capacity = capacity_of(constraint);
  return all_categories_of(constraint.arguments[0], binding, knowledge, [&](const std::string& object) {
    return all_categories_of(constraint.arguments[1], binding, knowledge, [&](const std::string& receptacle) {
      const auto* row = knowledge.placement(object, *kind.relation, receptacle);
      return row != nullptr && row->capacity >= capacity;
    });
  });
}

bool effect_holds(const DomainConstraint& constraint, const ConstraintKind& kind, const Binding& binding,
                  const Knowledge& knowledge) {
  auto substance = substance_of(constraint);
  if (const auto* bound = bound_to(binding, substance)) substance = *bound;
  return all_categories_of(constraint.arguments[0], binding, knowledge, [&](const std::string& tool) {
    // A tool may have several effects of one kind, one for each substance.
    const auto rows = knowledge.effects_of(tool, *kind.treatment);
    return all_categories_of(constraint.arguments[1], binding, knowledge, [&](const std::string& target) {
      return std::any_of(rows.begin(), rows.end(), [&](const Effect* row) {
        return row->target == target && (substance.empty() || row->gives == substance);
      });
    });
  });
}

bool all_distinct(const DomainConstraint& constraint, const Binding& binding) {
  std::vector<const std::string*> seen;
  for (const auto& argument : constraint.arguments) {
    const auto* category =
        is_slice(argument) ? bound_to(binding, placeholder_use(argument).name) : bound_to(binding, argument);
    if (category == nullptr) continue;
    if (std::any_of(seen.begin(), seen.end(), [&](const std::string* other) { return *other == *category; }))
      return false;
    seen.push_back(category);
  }
  return true;
}

/// Categories that one constraint leaves for `placeholder`, read from the table that answers it, when its other place
/// is bound; nullopt when this constraint does not narrow the choice.
std::optional<Names> narrowed(const DomainConstraint& constraint, const std::string& placeholder,
                              const Binding& binding, const Knowledge& knowledge) {
  const ConstraintKind& kind = info(constraint.type);
  if (constraint.arguments.size() < 2) return std::nullopt;
  const auto& first = constraint.arguments[0];
  const auto& second = constraint.arguments[1];
  if (kind.meaning == Meaning::Value || kind.meaning == Meaning::Usual) {
    const auto* bound = second == placeholder ? bound_to(binding, first) : nullptr;
    const auto* category = bound == nullptr ? nullptr : knowledge.find(*bound);
    if (category == nullptr) return std::nullopt;
    if (kind.meaning == Meaning::Usual) return sorted_unique(Names(category->rooms.begin(), category->rooms.end()));
    Names values(category->colors.begin(), category->colors.end());
    values.insert(values.end(), category->materials.begin(), category->materials.end());
    return sorted_unique(std::move(values));
  }
  if (kind.meaning != Meaning::Placement && kind.meaning != Meaning::Effect) return std::nullopt;
  const bool is_first = first == placeholder;
  if (!is_first && second != placeholder) return std::nullopt;
  const std::string other = first_category_of(is_first ? second : first, binding, knowledge);
  if (other.empty()) return std::nullopt;
  Names names;
  if (kind.meaning == Meaning::Placement) {
    const auto rows =
        is_first ? knowledge.placements_at(other, *kind.relation) : knowledge.placements_of(other, *kind.relation);
    for (const auto* row : rows) names.push_back(is_first ? row->object : row->receptacle);
  } else {
    const auto rows =
        is_first ? knowledge.effects_on(other, *kind.treatment) : knowledge.effects_of(other, *kind.treatment);
    for (const auto* row : rows) names.push_back(is_first ? row->tool : row->target);
  }
  return sorted_unique(std::move(names));
}

bool gives_substance(const Effect& effect) {
  return effect.treatment == Treatment::Fills || effect.treatment == Treatment::Dispenses;
}

std::vector<std::string> substances(const Knowledge& knowledge) {
  std::vector<std::string> names;
  for (const auto& effect : knowledge.effects()) {
    if (gives_substance(effect)) names.push_back(effect.gives);
  }
  return sorted_unique(std::move(names));
}

std::vector<std::string> words_for(const Parameter& parameter, const Knowledge& knowledge) {
  if (asks_for(parameter, ParameterWord::Substance)) return substances(knowledge);
  const bool colors = asks_for(parameter, ParameterWord::Color);
  std::vector<std::string> words;
  for (const auto& category : knowledge.categories()) {
    const auto& own = colors ? category.colors : category.materials;
    words.insert(words.end(), own.begin(), own.end());
  }
  return sorted_unique(std::move(words));
}

/// Whether words_for has it, without listing the others.
bool is_word_for(const Parameter& parameter, const std::string& word, const Knowledge& knowledge) {
  if (asks_for(parameter, ParameterWord::Substance)) {
    return std::any_of(knowledge.effects().begin(), knowledge.effects().end(),
                       [&](const Effect& effect) { return effect.gives == word && gives_substance(effect); });
  }
  const bool color = asks_for(parameter, ParameterWord::Color);
  return std::any_of(knowledge.categories().begin(), knowledge.categories().end(), [&](const Category& category) {
    const auto& own = color ? category.colors : category.materials;
    return std::find(own.begin(), own.end(), word) != own.end();
  });
}

/// The first of a parameter's affordances that the knowledge base knows; nullptr when it has none.
const std::string* first_affordance(const Parameter& parameter) {
  for (const auto& affordance : parameter.affordances) {
    if (!parameter_word(affordance)) return &affordance;
  }
  return nullptr;
}

/// Sorted: for a category, all that have the first affordance.
std::vector<std::string> all_names(const Parameter& parameter, const Knowledge& knowledge) {
  if (is_room(parameter)) return room_types(knowledge);
  if (is_value(parameter)) return words_for(parameter, knowledge);
  if (const auto* first = first_affordance(parameter)) return sorted_unique(knowledge.with_affordance(*first));
  std::vector<std::string> names;
  for (const auto& category : knowledge.categories()) names.push_back(category.name);
  return sorted_unique(std::move(names));
}

/// Those of the first list that the other has, too; both are sorted.
Names common_names(const Names& names, const std::vector<std::string>& other) {
  const bool few = names.size() * 8 < other.size();
  Names common;
  auto from = other.begin();
  for (const auto& name : names) {
    if (few)
      from = std::lower_bound(from, other.end(), name);
    else
      while (from != other.end() && *from < name) ++from;
    if (from != other.end() && *from == name) common.push_back(name);
  }
  return common;
}

/// What a parameter asks of a category; its words are read once for many categories.
class Wish {
 public:
  /// `all_have`: an affordance that need not be asked for; may be nullptr.
  explicit Wish(const Parameter& parameter, const std::string* all_have = nullptr)
      : furniture_(asks_for(parameter, ParameterWord::Furniture)),
        movable_(asks_for(parameter, ParameterWord::Movable)),
        countable_(asks_for(parameter, ParameterWord::Countable)) {
    for (const auto& affordance : parameter.affordances) {
      if (&affordance == all_have) continue;
      if (!parameter_word(affordance)) affordances_.push_back(affordance);
    }
  }
  bool met_by(const std::string& category, const Knowledge& knowledge) const {
    const auto* known = knowledge.find(category);
    if (known == nullptr || (furniture_ && known->movable) || (movable_ && !known->movable) ||
        (countable_ && !known->countable))
      return false;
    return std::all_of(affordances_.begin(), affordances_.end(),
                       [&](std::string_view affordance) { return knowledge.has(category, affordance); });
  }

 private:
  bool furniture_, movable_, countable_;
  std::vector<std::string_view> affordances_;  // of the knowledge base
};

bool usual_holds(const DomainConstraint& constraint, const Binding& binding, const Knowledge& knowledge) {
  const auto* name = bound_to(binding, constraint.arguments[0]);
  const auto* room = bound_to(binding, constraint.arguments[1]);
  const auto* category = name == nullptr ? nullptr : knowledge.find(*name);
  return category != nullptr && room != nullptr &&
         std::find(category->rooms.begin(), category->rooms.end(), *room) != category->rooms.end();
}

bool value_holds(const DomainConstraint& constraint, const Binding& binding, const Knowledge& knowledge) {
  const auto* category = bound_to(binding, constraint.arguments[0]);
  const auto* value = bound_to(binding, constraint.arguments[1]);
  const auto* known = category == nullptr ? nullptr : knowledge.find(*category);
  if (known == nullptr || value == nullptr) return false;
  for (const auto* list : {&known->colors, &known->materials}) {
    if (std::find(list->begin(), list->end(), *value) == list->end()) continue;
    return std::any_of(list->begin(), list->end(), [&](const auto& other) { return distinguishable(*value, other); });
  }
  return false;
}

/// Things of every kind are things, and nearly all are movable: kinds as wide as these join nothing.
bool is_narrow(const std::string& kind) {
  return kind != "thing" && kind != "movable" && kind != "place" && kind != "fixture" && kind != "outside";
}

bool kind_holds(const DomainConstraint& constraint, const Binding& binding, const Knowledge& knowledge) {
  const auto asked = std::span(constraint.arguments).subspan(1);
  return all_categories_of(constraint.arguments[0], binding, knowledge, [&](const std::string& name) {
    const auto* category = knowledge.find(name);
    return category != nullptr &&
           std::any_of(category->kinds.begin(), category->kinds.end(), [&](const std::string& kind) {
             return std::find(asked.begin(), asked.end(), kind) != asked.end();
           });
  });
}

/// Whether those that are bound share a kind: one of those that the constraint lists, or, if it lists none, any.
bool same_kind(const DomainConstraint& constraint, const Binding& binding, const Knowledge& knowledge) {
  const auto is_kind = [](const std::string& word) {
    return std::isupper(static_cast<unsigned char>(word.front())) == 0;
  };
  const auto placeholders = static_cast<std::size_t>(
      std::find_if(constraint.arguments.begin(), constraint.arguments.end(), is_kind) - constraint.arguments.begin());
  const auto listed = std::span(constraint.arguments).subspan(placeholders);
  std::vector<const Category*> categories;
  for (const auto& argument : std::span(constraint.arguments).first(placeholders)) {
    const bool known = all_categories_of(argument, binding, knowledge, [&](const std::string& name) {
      categories.push_back(knowledge.find(name));
      return categories.back() != nullptr;
    });
    if (!known) return false;
  }
  if (categories.empty()) return true;
  const auto& kinds = categories.front()->kinds;
  return std::any_of(kinds.begin(), kinds.end(), [&](const std::string& kind) {
    const bool counts =
        listed.empty() ? is_narrow(kind) : std::find(listed.begin(), listed.end(), kind) != listed.end();
    return counts && std::all_of(categories.begin() + 1, categories.end(), [&](const Category* other) {
             return std::find(other->kinds.begin(), other->kinds.end(), kind) != other->kinds.end();
           });
  });
}

bool is_complete(const DomainConstraint& constraint, const Binding& binding) {
  const auto uses = placeholders_of(constraint);
  return std::all_of(uses.begin(), uses.end(),
                     [&](const PlaceholderUse& use) { return bound_to(binding, use.name) != nullptr; });
}

bool speaks_of(const DomainConstraint& constraint, const std::string& placeholder) {
  const auto uses = placeholders_of(constraint);
  return std::any_of(uses.begin(), uses.end(), [&](const PlaceholderUse& use) { return use.name == placeholder; });
}

}  // namespace

std::vector<std::string> room_types(const Knowledge& knowledge) {
  std::unordered_set<std::string_view> types;
  for (const auto& category : knowledge.categories()) types.insert(category.rooms.begin(), category.rooms.end());
  std::vector<std::string> sorted(types.begin(), types.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

bool affords(const Parameter& parameter, const std::string& category, const Knowledge& knowledge) {
  if (is_room(parameter)) {
    const auto& all = knowledge.categories();
    return std::any_of(all.begin(), all.end(), [&](const Category& one) {
      return std::find(one.rooms.begin(), one.rooms.end(), category) != one.rooms.end();
    });
  }
  if (is_value(parameter)) return is_word_for(parameter, category, knowledge);
  return Wish(parameter).met_by(category, knowledge);
}

std::vector<std::string> slices_of(const std::string& category, const Knowledge& knowledge) {
  std::vector<std::string> pieces;
  for (const auto* row : knowledge.effects_on(category, Treatment::Slices)) {
    pieces.push_back(row->gives.empty() ? category : row->gives);
  }
  if (pieces.empty()) pieces.push_back(category);
  return sorted_unique(std::move(pieces));
}

const std::string* bound_to(const Binding& binding, const std::string& placeholder) {
  for (const auto& [name, category] : binding) {
    if (name == placeholder) return &category;
  }
  return nullptr;
}

bool satisfies(const DomainConstraint& constraint, const Binding& binding, const Knowledge& knowledge) {
  const ConstraintKind& kind = info(constraint.type);
  if (kind.meaning == Meaning::Distinct) return all_distinct(constraint, binding);
  if (kind.meaning == Meaning::OfKind) return kind_holds(constraint, binding, knowledge);
  if (kind.meaning == Meaning::SameKind) return same_kind(constraint, binding, knowledge);
  if (constraint.arguments.size() >= 2) {
    if (kind.meaning == Meaning::Placement) return placement_holds(constraint, kind, binding, knowledge);
    if (kind.meaning == Meaning::Effect) return effect_holds(constraint, kind, binding, knowledge);
    if (kind.meaning == Meaning::Usual) return usual_holds(constraint, binding, knowledge);
    if (kind.meaning == Meaning::Value) return value_holds(constraint, binding, knowledge);
  }
  const auto* first = bound_to(binding, placeholder_use(constraint.arguments[0]).name);
  const auto* category = first == nullptr ? nullptr : knowledge.find(*first);
  if (kind.meaning == Meaning::Sizes) return category != nullptr && comes_in_sizes(*category, knowledge);
  if (kind.meaning == Meaning::Words && constraint.arguments.size() >= 2) {
    const auto words = alias_kind_named(constraint.arguments[1]);
    return category != nullptr && words && !knowledge.aliases_of(category->name, *words).empty();
  }
  return false;
}

std::string to_text(const DomainConstraint& constraint, const Binding& binding) {
  std::vector<std::string> words = {std::string(info(constraint.type).name)};
  for (const auto& argument : constraint.arguments) {
    const auto use = placeholder_use(argument);
    const auto* category = bound_to(binding, use.name);
    words.push_back(category == nullptr ? argument : *category + (use.slice ? "/slice" : ""));
  }
  return std::string("(").append(join(words, " ")).append(")");
}

bool each_candidate(const Parameter& parameter, const std::vector<DomainConstraint>& constraints,
                    const Binding& binding, const Knowledge& knowledge, const std::vector<std::string>* among,
                    const std::function<bool(const std::string& category)>& visit) {
  std::optional<Names> base;
  for (const auto& constraint : constraints) {
    auto names = narrowed(constraint, parameter.name, binding, knowledge);
    if (names && (!base || names->size() < base->size())) base = std::move(names);
  }
  const bool room = is_room(parameter), value = is_value(parameter);
  std::vector<std::string> all;
  Names names;
  const std::string* all_have = nullptr;
  if (base) {
    names = among != nullptr ? common_names(*base, *among) : std::move(*base);
  } else if (among != nullptr && !room && !value) {
    names = sorted_unique(Names(among->begin(), among->end()));
  } else {
    all = all_names(parameter, knowledge);
    all_have = first_affordance(parameter);
    names.assign(all.begin(), all.end());
    if (among != nullptr) names = common_names(names, *among);
  }
  std::vector<const DomainConstraint*> own;
  auto trial = binding;
  trial.emplace_back(parameter.name, "");
  for (const auto& constraint : constraints) {
    const bool partial = constraint.type == ConstraintType::Distinct || constraint.type == ConstraintType::SameKind;
    if (speaks_of(constraint, parameter.name) && (partial || is_complete(constraint, trial)))
      own.push_back(&constraint);
  }
  const bool all_are_offered = !base && (room || value);
  const Wish wish(parameter, all_have);
  std::string& category = trial.back().second;
  for (const std::string_view name : names) {
    category = name;
    const bool offers =
        all_are_offered || (room || value ? affords(parameter, category, knowledge) : wish.met_by(category, knowledge));
    if (!offers) continue;
    const auto holds = [&](const auto* one) { return satisfies(*one, trial, knowledge); };
    if (std::all_of(own.begin(), own.end(), holds) && !visit(category)) return false;
  }
  return true;
}

std::vector<std::string> candidates_for(const Parameter& parameter, const std::vector<DomainConstraint>& constraints,
                                        const Binding& binding, const Knowledge& knowledge,
                                        const std::vector<std::string>* among) {
  std::vector<std::string> names;
  each_candidate(parameter, constraints, binding, knowledge, among, [&](const std::string& category) {
    names.push_back(category);
    return true;
  });
  return names;
}

}  // namespace unietp
