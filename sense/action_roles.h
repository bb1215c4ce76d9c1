#pragma once

#include <array>
#include <span>
#include <string_view>

#include "logic/vocabulary.h"

namespace unietp {

/// The liquids whose roles name them: "fill:water". With another substance a vessel is filled by its kind.
inline constexpr std::array<std::string_view, 3> kLiquids{"water", "coffee", "wine"};

/// What bringing a state of one object about is called: a row of sense/action_roles.cpp.
struct StateAction {
  Predicate predicate;
  std::string_view role;                  // in roles (docs/sense.md): "wash", "switch_on"
  std::array<std::string_view, 2> verbs;  // in questions to `unietp sense`, before the object: "wash", "clean"
};
/// The states that people ask for as such. All that instructions have a verb for, but thawed: no source says of what
/// things thawing is usual.
std::span<const StateAction> state_actions();

/// The role of bringing a state about: "wash" for clean; "" for what has no row.
std::string_view action_of(Predicate predicate);

}  // namespace unietp
