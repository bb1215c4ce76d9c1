#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "logic/formula.h"

namespace unietp {

/// The operator words of the text form; `number` stands only inside a `count` of two counts.
struct OperatorWord {
  Formula::Op op;
  std::string_view word;
  std::string_view usage;
  std::string_view says;  // one line for people
};
inline constexpr std::array<OperatorWord, 14> kOperatorWords = {{
    {Formula::Op::Equal, "=", "(= ?x ?y)", "the two are the same object"},
    {Formula::Op::And, "and", "(and f g ...)", "all of them hold; (and) is true"},
    {Formula::Op::Or, "or", "(or f g ...)", "at least one of them holds; (or) is false"},
    {Formula::Op::Not, "not", "(not f)", "f does not hold"},
    {Formula::Op::Imply, "imply", "(imply f g)", "if f holds, g does"},
    {Formula::Op::Forall, "forall", "(forall (?x - D) f)", "f holds for every object of the domain"},
    {Formula::Op::Exists, "exists", "(exists (?x - D) f)", "f holds for some object of the domain"},
    {Formula::Op::Count, "count", "(count >= 2 (?x - D) f)", "so many objects of the domain satisfy f"},
    {Formula::Op::Number, "number", "(count > (number (?x - D) f) (number (?y - E) g))",
     "inside count: more objects of D satisfy f than of E satisfy g"},
    {Formula::Op::AtEnd, "at-end", "(at-end f)", "f holds in the last state"},
    {Formula::Op::Sometime, "sometime", "(sometime f)", "f holds at some point"},
    {Formula::Op::Always, "always", "(always f)", "f holds all the time"},
    {Formula::Op::Until, "until", "(until f g)", "g holds at some point, and f at every point before that"},
    {Formula::Op::Before, "before", "(before f g)", "both happen, and f happens first before g does"},
}};

/// A comparison and what it says of a count.
struct ComparisonWord {
  Comparison comparison;
  std::string_view says;
};
inline constexpr std::array<ComparisonWord, 5> kComparisons = {{
    {Comparison::Equal, "exactly so many"},
    {Comparison::AtLeast, "at least so many"},
    {Comparison::AtMost, "at most so many"},
    {Comparison::Greater, "more than so many"},
    {Comparison::Less, "fewer than so many"},
}};

/// What may stand behind the dash of `(?x - D)`.
struct DomainForm {
  std::string_view usage, says;
};
inline constexpr std::array<DomainForm, 7> kDomainForms = {{
    {"A", "the objects of a category; in a template, of what fills the placeholder"},
    {"A/slice", "what slicing an A makes"},
    {"(either A B)", "the objects of one of several categories"},
    {"(A :where f)", "those A for which f holds in the first state"},
    {"object", "all objects"},
    {"room", "all rooms"},
    {"agent", "the agent"},
}};

}  // namespace unietp
