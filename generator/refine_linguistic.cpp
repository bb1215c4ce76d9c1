#include <algorithm>
#include <array>

#include "generator/goal_variable.h"
#include "generator/refinement.h"
#include "generator/specification.h"
#include "scene/states.h"

namespace unietp {
namespace {

/// How often a style is tried before others. Those that few goals can be said in come first more often, so that a data
/// set has about as many tasks of each.
struct StyleShare {
  Style style;
  double weight;
};
constexpr std::array kShares = {
    StyleShare{Style::Alias, 1},        StyleShare{Style::Function, 1},       StyleShare{Style::Hypernym, 8},
    StyleShare{Style::Description, 30}, StyleShare{Style::Context, 1.2},      StyleShare{Style::Request, 100},
    StyleShare{Style::Exception, 200},  StyleShare{Style::Ellipsis, 3},       StyleShare{Style::Anaphora, 2},
    StyleShare{Style::Compound, 10},    StyleShare{Style::InvertedOrder, 20}, StyleShare{Style::VagueQuantity, 100},
    StyleShare{Style::Condition, 20}};

bool says(const Formula& goal, const auto& is_asked) {
  return is_asked(goal) || std::any_of(goal.children.begin(), goal.children.end(),
                                       [&](const Formula& child) { return says(child, is_asked); });
}

std::vector<Style> in_drawn_order(Rng& rng) {
  std::vector<StyleShare> left(kShares.begin(), kShares.end());
  std::vector<Style> order;
  while (!left.empty()) {
    std::vector<double> weights;
    for (const auto& share : left) weights.push_back(share.weight);
    const auto at = static_cast<std::ptrdiff_t>(rng.weighted(weights));
    order.push_back(left[static_cast<std::size_t>(at)].style);
    left.erase(left.begin() + at);
  }
  return order;
}

/// Whether some category of the goal that can be carried has another name.
bool has_another_name(const Specification& plain, const Knowledge& knowledge) {
  const auto categories = categories_of(plain.goal);
  return std::any_of(categories.begin(), categories.end(), [&](const std::string& name) {
    const auto* category = knowledge.find(name);
    return category != nullptr && category->movable && !knowledge.aliases_of(name, AliasKind::Synonym).empty();
  });
}

/// Whether the goal is one state of the only such thing in the home, which is in the opposite one: "if the stove is on,
/// turn it off".
bool is_undone_in_one(const Specification& plain, const SceneOffer& offer) {
  const Formula& goal = plain.goal;
  if (goal.op != Formula::Op::Exists || goal.children[0].op != Formula::Op::AtEnd || !goal.domain.where.empty() ||
      goal.domain.members.size() != 1 || number_of(offer, goal.domain.members[0].category) != 1)
    return false;
  const Formula& asked = goal.children[0].children[0];
  const auto opposite =
      asked.op == Formula::Op::Atom && asked.terms.size() == 1 ? opposite_of(asked.predicate) : std::nullopt;
  return opposite && std::any_of(plain.init.begin(), plain.init.end(), [&](const Formula& start) {
           return start.op == Formula::Op::Forall && start.domain == goal.domain &&
                  start.children[0].op == Formula::Op::Atom && start.children[0].predicate == *opposite;
         });
}

Specification reworded(const Specification& plain, Style style) {
  auto changed = plain;
  changed.split = Split::Linguistic;
  changed.style = style;
  return changed;
}

std::optional<Specification> refined(const Specification& plain, const Knowledge& knowledge, const SceneOffer& offer,
                                     Style style, const Rng& rng) {
  if (names_by_phrase(style)) return refine_by_phrase(plain, knowledge, offer, style, rng);
  switch (style) {
    case Style::Alias:
      return has_another_name(plain, knowledge) ? std::optional(reworded(plain, style)) : std::nullopt;
    case Style::Aside:
      return reworded(plain, style);
    case Style::Condition:
      return is_undone_in_one(plain, offer) ? std::optional(reworded(plain, style)) : std::nullopt;
    case Style::InvertedOrder: {
      // "Before you close the fridge, put the egg in it", but not "before you put the apple in the fridge, put the
      // egg in it" nor "before you heat the pan, wash it", which asks for no heat.
      const auto in_order = [](const Formula& f) {
        if (f.op != Formula::Op::Before) return false;
        const auto first = predicates_in(f.children[0]), then = predicates_in(f.children[1]);
        return first != then && std::all_of(then.begin(), then.end(), [](Predicate one) {
                 return one == Predicate::Open || one == Predicate::Closed || one == Predicate::PowerOn ||
                        one == Predicate::PowerOff;
               });
      };
      return says(plain.goal, in_order) ? std::optional(reworded(plain, style)) : std::nullopt;
    }
    case Style::VagueQuantity: {
      const auto few = [](const Formula& f) {
        return f.op == Formula::Op::Count && f.comparison == Comparison::AtLeast && (f.number == 2 || f.number == 3);
      };
      return says(plain.goal, few) ? std::optional(reworded(plain, style)) : std::nullopt;
    }
    case Style::Negation:
    case Style::Exception:
    case Style::Ellipsis:
    case Style::Anaphora:
    case Style::Compound:
      return refine_by_reference(plain, knowledge, offer, style, rng);
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<Specification> refine_linguistic(const Specification& plain, const Knowledge& knowledge,
                                               const SceneOffer& offer, std::string_view style_asked, Rng rng) {
  if (plain.style != Style::Direct || plain.split == Split::InstanceGrounding) return std::nullopt;
  std::vector<Style> styles = in_drawn_order(rng);
  if (!style_asked.empty()) {
    const auto asked = style_named(style_asked);
    if (!asked) return std::nullopt;
    styles = {*asked};
  }
  for (const Style style : styles)
    if (auto found = refined(plain, knowledge, offer, style, rng.fork(name_of(style), 0))) return found;
  return std::nullopt;
}

}  // namespace unietp
