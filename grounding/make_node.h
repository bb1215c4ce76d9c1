#pragma once

#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "core/rng.h"
#include "grounding/workspace.h"

namespace unietp {

/// An instance of a category with a fresh id, default states, color and material drawn from the category's lists. Its
/// size is that of one of the category's usable models, drawn, whose name it then carries; where there is none, one
/// that differs from the typical by at most `spread` (a share; per axis for furniture, as a whole for what moves, so
/// that balls stay balls). The mass follows the volume. The pose is left to the caller.
Node make_node(const Workspace& workspace, const Category& category, double spread, Rng& rng);

/// The models of a category whose boxes may be given to a thing of a scene (`usable` of akb/fit.h), by name.
std::vector<const Asset*> usable_assets(const Knowledge& knowledge, const Category& category);

/// What a thing is on or in; none for furniture.
struct HostRelation {
  Predicate relation = Predicate::On;
  std::string_view receptacle = {};  // category
};
/// States of a lived-in home, with the shares that the workspace's household says of such a thing there: plates in the
/// sink are dirty, those in the cabinet are not. Without a household a seventh is dirty, some lamps and screens are on,
/// some vessels full, some laptops and books open. Furniture with doors stays shut.
void draw_states(Node& node, const Workspace& workspace, const HostRelation& host_relation, Rng& rng);

/// Nobody folds what is dirty: such a thing is unfolded.
void unfold_if_dirty(Node& node);

/// Whether a thing of this kind can be in a state at all.
bool can_be(const Node& node, const Knowledge& knowledge, const State& state);

/// A substance that the knowledge says the category can be filled with; "" when none. Drawn among them.
std::string draw_filling(std::string_view category, const Knowledge& knowledge, Rng& rng);

}  // namespace unietp
