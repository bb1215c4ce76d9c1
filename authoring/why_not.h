#pragma once

#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "generator/gate.h"
#include "generator/specification.h"
#include "templates/template.h"

namespace unietp {

/// Categories that could replace the one bound to a placeholder, with the others kept.
struct OtherCategories {
  std::string placeholder;
  std::vector<std::string> categories;  // sorted; each passes all gates
};

/// The result of the generator's gates for a binding.
struct BindingVerdict {
  Binding binding;                     // that was asked about: the given one, completed when it left something open
  std::optional<GateRefusal> refusal;  // of the first gate that rejects it; nullopt: it passes all
  std::string fact;                    // the fact of the knowledge base behind the rejection, or ""
  std::vector<OtherCategories> alternatives;  // of a refused binding; placeholders without any are left out
};

/// Checks a binding by the gates and finds alternatives for rejected categories. Placeholders that it leaves open are
/// filled with categories that fit the others, if there are any. Deterministic.
BindingVerdict why_not(const Template& source, const Knowledge& knowledge, const Binding& given);

}  // namespace unietp
