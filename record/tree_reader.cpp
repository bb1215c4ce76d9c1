#include "record/tree_reader.h"

#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

namespace unietp {
namespace {

using Op = Formula::Op;

struct OpName {
  std::string_view name;
  Op op;
  std::size_t parts;  // kAny, or how many `parts` it must have; kNone: it has other fields
};
constexpr std::size_t kAny = 1000, kNone = 1001;
constexpr std::array kOps{OpName{"atom", Op::Atom, kNone},     OpName{"equal", Op::Equal, kNone},
                          OpName{"and", Op::And, kAny},        OpName{"or", Op::Or, kAny},
                          OpName{"not", Op::Not, 1},           OpName{"imply", Op::Imply, 2},
                          OpName{"forall", Op::Forall, kNone}, OpName{"exists", Op::Exists, kNone},
                          OpName{"count", Op::Count, kNone},   OpName{"number", Op::Number, kNone},
                          OpName{"at-end", Op::AtEnd, 1},      OpName{"sometime", Op::Sometime, 1},
                          OpName{"always", Op::Always, 1},     OpName{"until", Op::Until, 2},
                          OpName{"before", Op::Before, 2},     OpName{"count-compare", Op::CountCompare, 2}};

template <class List, class NameOf>
std::vector<std::string> names_of(const List& list, NameOf name) {
  std::vector<std::string> names;
  for (const auto& one : list) names.emplace_back(name(one));
  return names;
}

Comparison read_comparison(JsonReader& reader, const JsonAt& at) {
  const auto symbol = reader.text(at);
  constexpr std::array kAll{Comparison::Equal, Comparison::AtLeast, Comparison::AtMost, Comparison::Greater,
                            Comparison::Less};
  for (const auto comparison : kAll) {
    if (symbol_of(comparison) == symbol) return comparison;
  }
  reader.unknown_name(at, "comparison", names_of(kAll, [](Comparison c) { return symbol_of(c); }));
  return Comparison::Equal;
}

Term read_term(JsonReader& reader, const JsonAt& at) {
  JsonFields fields(reader, at);
  Term term;
  if (const auto variable = fields.optional("variable")) {
    term = {Term::Kind::Variable, reader.label(*variable)};
  } else if (const auto agent = fields.optional("agent")) {
    if (!reader.boolean(*agent)) reader.fail(*agent, "expected true");
    term = {Term::Kind::Agent, "agent"};
  } else if (const auto symbol = fields.required("symbol")) {
    term = {Term::Kind::Symbol, reader.label(*symbol)};
  }
  fields.finish();
  return term;
}

std::vector<Term> read_terms(JsonReader& reader, const JsonAt& at) {
  std::vector<Term> terms;
  const std::size_t count = reader.items(at);
  for (std::size_t i = 0; i < count && !reader.error(); ++i) terms.push_back(read_term(reader, reader.item(at, i)));
  return terms;
}

Domain::Member read_member(JsonReader& reader, const JsonAt& at) {
  JsonFields fields(reader, at);
  Domain::Member member;
  if (const auto category = fields.required("category")) member.category = reader.label(*category);
  if (const auto slice = fields.optional("slice")) member.slice = reader.boolean(*slice);
  fields.finish();
  return member;
}

Domain read_domain(JsonReader& reader, const JsonAt& at) {
  JsonFields fields(reader, at);
  Domain domain;
  if (const auto all = fields.optional("all")) {
    const auto kind = reader.text(*all);
    if (kind == "object") {
      domain.kind = Domain::Kind::Object;
    } else if (kind == "room") {
      domain.kind = Domain::Kind::Room;
    } else if (kind == "agent") {
      domain.kind = Domain::Kind::Agent;
    } else {
      reader.unknown_name(*all, "domain", {"object", "room", "agent"});
    }
  } else if (const auto categories = fields.required("categories")) {
    const std::size_t count = reader.items(*categories);
    for (std::size_t i = 0; i < count && !reader.error(); ++i)
      domain.members.push_back(read_member(reader, reader.item(*categories, i)));
  }
  if (const auto where = fields.optional("where")) domain.where.push_back(read_tree(reader, *where));
  fields.finish();
  return domain;
}

void read_parts(JsonReader& reader, const JsonAt& at, std::size_t wanted, Formula& formula) {
  const std::size_t count = reader.items(at);
  if (wanted != kAny && count != wanted)
    reader.fail(at, "expected " + std::to_string(wanted) + " parts, not " + std::to_string(count));
  for (std::size_t i = 0; i < count && !reader.error(); ++i)
    formula.children.push_back(read_tree(reader, reader.item(at, i)));
}

void read_fields(JsonReader& reader, JsonFields& fields, const OpName& name, Formula& formula) {
  if (name.op == Op::Atom) {
    if (const auto predicate = fields.required("predicate")) {
      const auto named = predicate_named(reader.text(*predicate));
      if (named) formula.predicate = *named;
      if (!named && !reader.error())
        reader.unknown_name(*predicate, "predicate", names_of(all_predicates(), [](const auto& p) { return p.name; }));
    }
  }
  if (name.op == Op::Atom || name.op == Op::Equal) {
    if (const auto terms = fields.required("terms")) formula.terms = read_terms(reader, *terms);
  }
  if (name.parts != kNone) {
    if (const auto parts = fields.required("parts")) read_parts(reader, *parts, name.parts, formula);
  }
  const bool quantified =
      name.op == Op::Forall || name.op == Op::Exists || name.op == Op::Count || name.op == Op::Number;
  if (quantified) {
    if (const auto variable = fields.required("variable")) formula.variable = reader.label(*variable);
    if (const auto domain = fields.required("domain")) formula.domain = read_domain(reader, *domain);
  }
  if (name.op == Op::Count || name.op == Op::CountCompare) {
    if (const auto comparison = fields.required("comparison"))
      formula.comparison = read_comparison(reader, *comparison);
  }
  if (name.op == Op::Count) {
    if (const auto number = fields.required("number")) {
      const double value = reader.number(*number);
      if (value < 0 || value > 1e6 || value != std::floor(value)) reader.fail(*number, "expected a whole number");
      if (!reader.error()) formula.number = static_cast<int>(value);
    }
  }
  if (quantified) {
    if (const auto body = fields.required("body")) formula.children.push_back(read_tree(reader, *body));
  }
}

}  // namespace

Formula read_tree(JsonReader& reader, const JsonAt& at) {
  JsonFields fields(reader, at);
  Formula formula;
  const auto op = fields.required("op");
  if (!op) return formula;
  const auto text = reader.text(*op);
  for (const auto& name : kOps) {
    if (name.name != text) continue;
    formula.op = name.op;
    read_fields(reader, fields, name, formula);
    fields.finish();
    return formula;
  }
  reader.unknown_name(*op, "operator", names_of(kOps, [](const OpName& name) { return name.name; }));
  return formula;
}

}  // namespace unietp
