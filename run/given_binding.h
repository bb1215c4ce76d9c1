#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "generator/specification.h"
#include "resources/resources.h"

namespace unietp {

/// Reads `--bind A=Mug B=Fridge`: categories for some or all placeholders of the template, in the order of its
/// parameters. Does not check that the categories exist; the gates do.
/// Errors: Usage for text without '=', an unknown placeholder (with the nearest) and one that is given twice.
Result<Binding> read_binding(const std::vector<std::string>& texts, const Template& source);

/// "A=Mug, B=Fridge"
std::string to_text(const Binding& binding);

/// The simulators that the template claims and that know every category given (or type of room); all that it claims
/// when none does.
std::vector<Simulator> simulators_for(const Template& source, const Binding& binding,
                                      const std::vector<Backend>& backends);

}  // namespace unietp
