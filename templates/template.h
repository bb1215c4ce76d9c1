#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "logic/formula.h"
#include "scene/simulator.h"

namespace unietp {

/// The classes of tasks. The last two are refinements of the others.
enum class Split { Atomic, Compositional, Logical, InstanceGrounding, Linguistic };
std::string_view name_of(Split split);  // "instance_grounding"
/// nullopt for an unknown name.
std::optional<Split> split_named(std::string_view name);

/// A placeholder and what a category must afford to fill it. With `room` as the only affordance a room type fills it,
/// with `color` or `material` a word for one.
struct Parameter {
  std::string name;  // "A"
  std::vector<std::string>
      affordances;  // of the AKB, or one of pseudo_affordances(); `room`, `color`, `material` alone
  SourcePos pos;
};

/// The kinds of conditions on categories, in the order of constraint_kinds() (templates/constraint_kinds.h).
enum class ConstraintType : std::uint8_t {
  Distinct,
  FitsOn,
  FitsInside,
  FitsNextTo,
  FitsUnder,
  Heats,
  Cools,
  Freezes,
  Washes,
  Wipes,
  Cooks,
  Burns,
  Slices,
  Soaks,
  Fills,
  Dispenses,
  Drains,
  Attaches,
  FoundIn,
  ComesIn,
  ComesInSizes,
  HasWords,
  Kind,
  SameKind,
};

/// A condition on which categories may fill the placeholders together, answered from the AKB:
/// (distinct A B …), (fits-on A B [n]), (fits-inside A B [n]), (heats T A), (cools T A), (washes T A), (cooks T A),
/// (slices K A), (fills T A substance), …, and, from the kinds of data/sense, (kind A food …), (same-kind A B).
/// `A/slice` may stand for what slicing an A makes.
struct DomainConstraint {
  ConstraintType type = ConstraintType::Distinct;
  std::vector<std::string> arguments;
  SourcePos pos;
};

/// Something that the start says and that makes a task needed: `(dirty A)`, `(not (inside A B))`.
struct Need {
  bool positive = true;
  Predicate predicate = Predicate::Dirty;
  std::string thing;  // a placeholder, or "agent" for where the agent is
  std::string other;  // of a relation: the other placeholder; of a state with a word: that word; else ""
  SourcePos pos;
};

/// What a task is for (purpose_kinds() of templates/purposes.h), and why it is needed.
struct Purpose {
  std::string name;  // "cleaning"; "" when the template does not say
  std::vector<Need> needs;
};

/// A parameterized task as its file says it (docs/templates.md). Formulas name placeholders where an instance of the
/// template names categories.
struct Template {
  std::string name;   // "place-two-one-inside", equal to the file's stem
  std::string title;  // "place two <A> and one <B> inside <C>"
  Purpose purpose;
  Split split = Split::Atomic;  // the base class
  std::string refinement;       // how its tasks are made harder by default (refinement_kinds()); "" when they are not
  std::vector<Simulator> simulators;
  std::vector<Parameter> parameters;
  std::vector<DomainConstraint> constraints;
  std::vector<Formula> init;  // state formulas that the start must satisfy
  Formula goal;
  std::vector<std::string> instructions;  // reference phrasings with {A}, {A:plural}, {A:indefinite}, …
  std::string file;
};

/// The split that a template's tasks fall in: that of its refinement, or its base class.
Split split_of_tasks(const Template& source);

/// Errors: every problem found, each with file, line, column and what is accepted.
struct TemplateReading {
  std::vector<Template> templates;  // in order of file name
  std::vector<Error> errors;
};
/// One template from its text; `file` names it in errors.
TemplateReading parse_template(std::string_view file, std::string_view text);
/// All `*.template` files below a folder, in order of path; a file with an error is refused and the rest still load.
TemplateReading load_templates(const std::filesystem::path& folder);

}  // namespace unietp
