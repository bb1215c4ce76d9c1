#pragma once

#include <string>
#include <utility>
#include <vector>

#include "akb/knowledge.h"
#include "core/rng.h"
#include "generator/referring.h"
#include "generator/scene_offer.h"
#include "generator/style.h"
#include "logic/formula.h"
#include "templates/template.h"

namespace unietp {

/// Categories for the placeholders, in the order of the template's parameters.
using Binding = std::vector<std::pair<std::string, std::string>>;

/// A template on a simulator with categories filled in: what grounding has to find a start for.
struct Specification {
  std::string template_name;
  Split split = Split::Atomic;  // of the task: the template's own, or that of the refinement
  Simulator simulator = Simulator::Ai2thor;
  Binding binding;
  Formula goal;
  std::vector<Formula> init;  // state formulas over categories, all to hold in the start
  Style style = Style::Direct;
  Referring refinement = Referring::None;
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

/// Refinements. Each gives the specification in another split, or nullopt when it does not apply. `kind` is one of
/// refinement_kinds(); "" lets the generator choose among all that fit.
/// Referring: a placeholder's domain gets a `:where` that singles out what is meant, and the start the objects that it
/// excludes ("the dirty mug", "both mugs in the kitchen"). What `offer` shows of the home decides what can be said of
/// things that stay where they are.
std::optional<Specification> refine_referring(const Specification& plain, const Knowledge& knowledge,
                                              const SceneOffer& offer, std::string_view kind, Rng rng);
/// Linguistic: a style of wording that knowledge base and home have material for, with the goal that it needs: the
/// same, one that accepts more, or one of an object that the home has several of.
std::optional<Specification> refine_linguistic(const Specification& plain, const Knowledge& knowledge,
                                               const SceneOffer& offer, std::string_view kind, Rng rng);

}  // namespace unietp
