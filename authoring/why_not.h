#pragma once

#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "generator/gate.h"
#include "generator/specification.h"
#include "templates/template.h"

namespace unietp {

/// Categories that could take the place of what a placeholder is bound to, the others kept.
struct OtherCategories {
  std::string placeholder;
  std::vector<std::string> categories;  // sorted; with each all gates are passed
};

/// What the generator's gates say of a binding.
struct BindingVerdict {
  Binding binding;                     // that was asked about: the given one, completed when it left something open
  std::optional<GateRefusal> refusal;  // of the first gate that refuses; nullopt: all are passed
  std::string fact;                    // what the knowledge base says or lacks about it, or ""
  std::vector<OtherCategories> alternatives;  // of a refused binding; placeholders without any are left out
};

/// Sends a binding through the gates, and looks for what else could be bound. Placeholders that it leaves open are
/// filled with what goes with the rest, when there is something. Deterministic.
BindingVerdict why_not(const Template& source, const Knowledge& knowledge, const Binding& given);

}  // namespace unietp
