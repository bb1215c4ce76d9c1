#pragma once

#include <string>
#include <utility>
#include <vector>

#include "akb/knowledge.h"
#include "core/rng.h"
#include "logic/formula.h"
#include "templates/template.h"

namespace unietp {

/// Categories for the placeholders, in the order of the template's parameters.
using Binding = std::vector<std::pair<std::string, std::string>>;

/// How an instruction is to be worded: `direct`, or one of the linguistic styles (`alias`, `function`, `context`, …).
using Style = std::string;

/// A template on a simulator with categories filled in: what grounding has to find a start for.
struct Specification {
  std::string template_name;
  Split split = Split::Atomic;  // of the task: the template's own, or that of the refinement
  Simulator simulator = Simulator::Ai2thor;
  Binding binding;
  Formula goal;
  std::vector<Formula> init;  // state formulas over categories, all to hold in the start
  Style style = "direct";
  std::string refinement;  // "", or the name of the referring constraint ("by-state", "by-place", …)
};

/// All bindings that satisfy a template's constraints over a knowledge base, in sorted order, at most `limit`.
std::vector<Binding> enumerate_bindings(const Template& source, const Knowledge& knowledge, std::size_t limit);

/// One binding drawn uniformly over categories placeholder by placeholder (not over objects); nullopt when there is
/// none. `offered` restricts placeholders to categories that a scene has or may be given; empty: no restriction.
std::optional<Binding> sample_binding(const Template& source, const Knowledge& knowledge,
                                      const std::vector<std::string>& offered, Rng rng);

/// Fills a template in. Adds the implied start: every conjunct of the goal false.
/// Errors: Unsatisfiable when the binding breaks a constraint (names it) or the goal is contradictory or already true
/// in every start that meets `init`.
Result<Specification> instantiate(const Template& source, const Knowledge& knowledge, const Binding& binding);

/// Refinements. Each gives the specification in another split, or nullopt when it does not apply.
/// Referring: one placeholder's domain gets a `:where` by state ("the dirty mug"), place ("the mug on the desk") or
/// colour, and the start gets the distractor that the constraint excludes.
std::optional<Specification> refine_referring(const Specification& plain, const Knowledge& knowledge, Rng rng);
/// Linguistic: the same goal, another style of wording that the AKB has material for.
std::optional<Specification> refine_linguistic(const Specification& plain, const Knowledge& knowledge, Rng rng);

}  // namespace unietp
