#pragma once

#include <optional>
#include <vector>

#include "core/sexpr.h"
#include "templates/template.h"

namespace unietp {

/// A template as read, with the expressions that its parts were read from, so that checks can say where.
struct TemplateSource {
  Template value;
  Sexpr name, title;
  std::optional<Sexpr> refinement;
  std::vector<Sexpr> init;      // every expression of the section, also one that is no formula
  std::vector<bool> init_read;  // of each: whether it became the next entry of value.init
  std::vector<Sexpr> goal;      // none or one
  bool goal_read = false;
  bool parameters_read = true;   // false when one was malformed: then nobody knows what is declared
  bool constraints_read = true;  // false when one was malformed: then nobody knows what is used
  std::vector<Sexpr> phrasings;  // of value.instructions, same order
};

/// `(?x - D)`, where a quantifier names its variable and domain
bool is_binder(const Sexpr& expression);

/// What is wrong with a template beyond the grammar of its sections: placeholders that are not declared or not used,
/// start constraints that grounding cannot enforce, a `forall` or `count` of the goal that may range over nothing,
/// phrasings with bad slots or without a placeholder of the goal. Errors: Schema, all of them, in order of appearance.
std::vector<Error> check_template(const TemplateSource& source);

}  // namespace unietp
