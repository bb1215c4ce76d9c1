#pragma once

#include <span>
#include <string_view>

#include "templates/template.h"

namespace unietp {

/// One way in which a template's tasks are made harder: what they refer to, or how they are worded.
struct RefinementKind {
  std::string_view name;  // "by-state", "alias"
  Split split = Split::InstanceGrounding;
  /// The template's own goal and start have everything that it needs; else the generator adds it.
  bool written = false;
  std::string_view says;  // one line for people
};

/// `referring`, whose goal has a `:where` of its own; the constraints that the generator adds to an object of the goal
/// (`by-state` … `by-two`); the wordings (`alias` … `vague-quantity`).
std::span<const RefinementKind> refinement_kinds();
/// nullptr when there is none of that name.
const RefinementKind* refinement_kind(std::string_view name);

}  // namespace unietp
