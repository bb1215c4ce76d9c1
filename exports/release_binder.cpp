#include "exports/release_binder.h"

#include <algorithm>

#include "exports/release_words.h"
#include "logic/evaluate.h"
#include "scene/trace.h"

namespace unietp {

bool ReleaseBinder::made_by_cutting(const std::string& category) const {
  return std::any_of(start_.nodes.begin(), start_.nodes.end(), [&](const Node& node) {
    const auto cuts = knowledge_.effects_on(node.category, Treatment::Slices);
    return std::any_of(cuts.begin(), cuts.end(), [&](const Effect* cut) { return cut->gives == category; });
  });
}

std::optional<ReleaseBound> ReleaseBinder::bind(const Formula& f) {
  if (f.domain.kind != Domain::Kind::Categories) {
    refuse("their quantifiers range over all nodes, not over all objects, rooms or agents");
    return std::nullopt;
  }
  ReleaseBound bound;
  bound.name = f.variable;
  for (const auto& member : f.domain.members) {
    if (knowledge_.find(member.category) == nullptr) {
      add_room(member.category, bound);
    } else if (member.slice) {
      add_pieces(member.category, bound);
    } else {
      add_category(member.category, bound);
    }
  }
  if (!f.domain.where.empty()) add_referents(f, bound);
  if (f.domain.where.empty()) plain_.insert(bound.theirs.begin(), bound.theirs.end());
  return why_.empty() ? std::optional<ReleaseBound>(std::move(bound)) : std::nullopt;
}

void ReleaseBinder::add_category(const std::string& category, ReleaseBound& bound) const {
  bound.late = bound.late || made_by_cutting(category);
  bound.ours.push_back(category);
  bound.theirs.push_back(their_category(category));
}

/// Their name for a category; OmniGibson's half_x is shown as xSliced.
std::string ReleaseBinder::their_category(const std::string& category) const {
  constexpr std::string_view kHalf = "half_";
  if (knowledge_.simulator() == Simulator::Behavior && category.starts_with(kHalf))
    return category.substr(kHalf.size()) + "Sliced";
  return category;
}

void ReleaseBinder::add_room(const std::string& type, ReleaseBound& bound) {
  const auto name = release_room(knowledge_.simulator(), type, facts_);
  if (!name) {
    refuse("the room categories of this simulator are unknown in the release");
    return;
  }
  for (const Room& room : start_.rooms) {
    if (room.type != type && release_room(knowledge_.simulator(), room.type, facts_) == name)
      refuse("their category " + *name + " includes more than our " + type);
  }
  bound.room = true;
  bound.ours.push_back(type);
  bound.theirs.push_back(*name);
}

void ReleaseBinder::add_pieces(const std::string& whole, ReleaseBound& bound) {
  std::set<std::string> pieces;
  for (const Effect* effect : knowledge_.effects_on(whole, Treatment::Slices)) pieces.insert(effect->gives);
  if (pieces.size() != 1 || pieces.begin()->empty()) {
    refuse("the slices of " + whole + " have no single category");
    return;
  }
  const std::string& piece = *pieces.begin();
  for (const Node& node : start_.nodes) {
    const bool other_piece = node.category == piece && node.whole_category != whole;
    const auto cuts = knowledge_.effects_on(node.category, Treatment::Slices);
    const bool other_whole =
        node.category != whole && std::any_of(cuts.begin(), cuts.end(), [&](auto* cut) { return cut->gives == piece; });
    if (other_piece || other_whole) refuse("slices of " + whole + " cannot be told from other " + piece);
  }
  bound.late = true;
  add_category(piece, bound);
}

void ReleaseBinder::add_referents(const Formula& f, const ReleaseBound& bound) {
  const Formula& where = f.domain.where.front();
  const auto free = free_variables(where);
  if (std::any_of(free.begin(), free.end(), [&](const auto& name) { return name != f.variable; })) {
    refuse("the referent depends on another object of the goal");
    return;
  }
  if (bound.theirs.size() != 1 || bound.late || bound.room) {
    refuse("their references are to objects of one category");
    return;
  }
  const Trace trace = to_logic(start_, {}, true);
  std::vector<std::string> ids;
  for (const EntityIndex entity : members_of(f.domain, f.variable, trace)) ids.push_back(trace.entities[entity].id);
  const auto [place, is_new] = referents_.emplace(bound.theirs[0], ids);
  if (!is_new && place->second != ids) refuse("their references select the same objects wherever a category occurs");
}

void ReleaseBinder::check_referents(bool counts) {
  if (!why_.empty() || referents_.empty()) return;
  if (counts) refuse("their evaluator has no `forall` and no count together with a reference");
  for (const auto& [category, ids] : referents_) {
    if (plain_.contains(category)) refuse("their references select the same objects wherever a category occurs");
    const Category* own = knowledge_.find(category);
    const auto cuts =
        own == nullptr ? std::vector<const Effect*>() : knowledge_.effects_on(category, Treatment::Slices);
    for (const Effect* cut : cuts) {
      if (plain_.contains(their_category(cut->gives)))
        refuse("their reference would then select only the slices of these");
    }
  }
}

bool ReleaseBinder::vanishes(const ReleaseBound& bound) const {
  if (knowledge_.simulator() != Simulator::Behavior) return false;
  return std::any_of(bound.ours.begin(), bound.ours.end(), [&](const std::string& category) {
    return knowledge_.find(category) != nullptr && !knowledge_.effects_on(category, Treatment::Slices).empty();
  });
}

}  // namespace unietp
