#pragma once

#include <optional>
#include <variant>

#include "akb/knowledge.h"
#include "generator/gate.h"
#include "generator/specification.h"
#include "templates/template.h"

namespace unietp {

/// Fills a template in and sends it through the gates before StateOfCategory, which cost little. The start has, by
/// itself, something of every category that the binding names.
std::variant<Specification, GateRefusal> fill_in(const Template& source, const Knowledge& knowledge,
                                                 const Binding& binding);
/// The same through all gates; the first that refuses answers. Deterministic.
std::variant<Specification, GateRefusal> propose(const Template& source, const Knowledge& knowledge,
                                                 const Binding& binding);

/// The gates that a specification passes without its template, from StateOfCategory on: for refinements, which change
/// goal and init. nullopt when all are passed.
std::optional<GateRefusal> refused_by(const Specification& specification, const Knowledge& knowledge);

}  // namespace unietp
