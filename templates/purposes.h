#pragma once

#include <span>
#include <string_view>

#include "logic/vocabulary.h"

namespace unietp {

/// What a goal may ask for: `dirty` is to hold, or, negated, no longer to hold.
struct PurposeSign {
  Predicate predicate = Predicate::On;
  bool negated = false;
  bool operator==(const PurposeSign&) const = default;
};

/// What tasks are for in a home: a word of (purpose ...).
struct PurposeKind {
  std::string_view name;               // "cleaning"
  std::string_view says;               // one line for people
  std::span<const PurposeSign> signs;  // a goal for this purpose asks for at least one of them
  bool meanwhile = false;              // what happens on the way may be all that is wanted: a room is aired
  bool of_dangers = false;             // something may be at first where safety forbids it
};
/// All purposes, in the order in which help lists them.
std::span<const PurposeKind> purpose_kinds();
/// nullptr when there is none of that name.
const PurposeKind* purpose_kind(std::string_view name);

}  // namespace unietp
