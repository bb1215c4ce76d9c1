#include <algorithm>

#include "generator/consistency.h"
#include "generator/goal_variable.h"
#include "generator/specification.h"

namespace unietp {
namespace {

/// Categories with an alias of this kind, among the movable ones that the goal speaks of.
std::vector<std::string> with_alias(const Specification& plain, const Knowledge& knowledge, AliasKind kind) {
  std::vector<std::string> found;
  for (const auto& name : categories_of(plain.goal)) {
    const auto* category = knowledge.find(name);
    if (category != nullptr && category->movable && !knowledge.aliases_of(name, kind).empty()) found.push_back(name);
  }
  return found;
}

/// Whether some part of the goal is about the end, so that a command can say it.
bool asks_for_an_end(const Specification& plain) {
  const auto at_end = [](const Formula& f, const auto& self) -> bool {
    return f.op == Formula::Op::AtEnd ||
           std::any_of(f.children.begin(), f.children.end(), [&](const Formula& child) { return self(child, self); });
  };
  return at_end(plain.goal, at_end);
}

/// Whether the start has something that is so, which an instruction can be tied to: "if a fridge is closed, …".
bool starts_with_something(const Specification& plain) {
  return std::any_of(plain.init.begin(), plain.init.end(), [](const Formula& start) {
    const bool some = start.op == Formula::Op::Exists || start.op == Formula::Op::Forall ||
                      (start.op == Formula::Op::Count && start.number >= 1 &&
                       (start.comparison == Comparison::AtLeast || start.comparison == Comparison::Equal));
    return some && (start.children[0].op == Formula::Op::Atom || start.children[0].op == Formula::Op::Exists);
  });
}

Specification reworded(const Specification& plain, Style style) {
  auto changed = plain;
  changed.split = Split::Linguistic;
  changed.style = style;
  return changed;
}

Specification substituted(const Specification& plain, const std::string& category,
                          const std::vector<std::string>& values) {
  auto changed = plain;
  changed.goal = substitute_names(plain.goal, {{category, values}});
  for (auto& start : changed.init) start = substitute_names(start, {{category, values}});
  return changed;
}

/// "something to drink from" is served by every category with that function, so the goal must accept them all, and the
/// start must leave none of them where it would already do.
std::optional<Specification> by_function(const Specification& plain, const Knowledge& knowledge, Rng& rng) {
  std::vector<std::string> choices;
  for (const auto& variable : singular_variables(plain.goal)) {
    const auto* category = knowledge.find(variable.category);
    if (category != nullptr && category->movable) choices.push_back(variable.category);
  }
  rng.shuffle(choices);
  for (const auto& category : choices) {
    const auto functions = knowledge.aliases_of(category, AliasKind::Function);
    if (functions.empty()) continue;
    const auto& text = rng.pick(functions)->text;
    std::vector<std::string> serving;
    bool clash = false;
    for (const auto& alias : knowledge.aliases()) {
      if (alias.kind != AliasKind::Function || alias.text != text) continue;
      // One that could never satisfy the goal need not be among them.
      if (contradiction(substituted(plain, category, {alias.category}), knowledge)) continue;
      const bool other_part = std::any_of(plain.binding.begin(), plain.binding.end(), [&](const auto& pair) {
        return pair.second == alias.category && alias.category != category;
      });
      clash = clash || other_part;
      serving.push_back(alias.category);
    }
    if (clash || serving.empty()) continue;  // one word for two parts of the goal would be ambiguous
    std::sort(serving.begin(), serving.end());
    serving.erase(std::unique(serving.begin(), serving.end()), serving.end());
    auto widened = reworded(substituted(plain, category, serving), Style::Function);
    if (contradiction(widened, knowledge) || bad_start(widened, knowledge, kStartsDrawn)) continue;
    return widened;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Specification> refine_linguistic(const Specification& plain, const Knowledge& knowledge,
                                               std::string_view style_asked, Rng rng) {
  if (plain.style != Style::Direct || plain.split == Split::InstanceGrounding) return std::nullopt;
  std::vector<Style> styles = {Style::Alias,     Style::Function,     Style::Context,  Style::Background,
                               Style::Bystander, Style::NestedSyntax, Style::Condition};
  if (!style_asked.empty()) {
    const auto asked = style_named(style_asked);
    if (!asked) return std::nullopt;
    styles = {*asked};
  }
  rng.shuffle(styles);
  for (const Style style : styles) {
    if (style == Style::Function) {
      if (auto widened = by_function(plain, knowledge, rng)) return widened;
    } else if (style == Style::Background || style == Style::Bystander ||
               (style == Style::NestedSyntax && asks_for_an_end(plain)) ||
               (style == Style::Condition && asks_for_an_end(plain) && starts_with_something(plain))) {
      return reworded(plain, style);
    } else if (style == Style::Alias || style == Style::Context) {
      const AliasKind kind = style == Style::Alias ? AliasKind::Synonym : AliasKind::Context;
      if (!with_alias(plain, knowledge, kind).empty()) return reworded(plain, style);
    }
  }
  return std::nullopt;
}

}  // namespace unietp
