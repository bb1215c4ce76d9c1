#include "dataset/formula_json.h"

#include <nlohmann/json.hpp>

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

Json term_to_json(const Term& term) {
  switch (term.kind) {
    case Term::Kind::Variable:
      return {{"variable", term.name}};
    case Term::Kind::Agent:
      return {{"agent", true}};
    case Term::Kind::Symbol:
      return {{"symbol", term.name}};
  }
  return {};
}

Json terms_to_json(const Formula& formula) {
  Json terms = Json::array();
  for (const auto& term : formula.terms) terms.push_back(term_to_json(term));
  return terms;
}

Json domain_to_json(const Domain& domain) {
  Json json = Json::object();
  switch (domain.kind) {
    case Domain::Kind::Categories: {
      Json members = Json::array();
      for (const auto& member : domain.members) {
        Json one{{"category", member.category}};
        if (member.slice) one["slice"] = true;
        members.push_back(std::move(one));
      }
      json["categories"] = std::move(members);
      break;
    }
    case Domain::Kind::Object:
      json["all"] = "object";
      break;
    case Domain::Kind::Room:
      json["all"] = "room";
      break;
    case Domain::Kind::Agent:
      json["all"] = "agent";
      break;
  }
  if (!domain.where.empty()) json["where"] = formula_to_json(domain.where.front());
  return json;
}

Json quantified(std::string_view op, const Formula& formula) {
  return {{"op", op}, {"variable", formula.variable}, {"domain", domain_to_json(formula.domain)}};
}

Json with_parts(std::string_view op, const Formula& formula) {
  Json parts = Json::array();
  for (const auto& child : formula.children) parts.push_back(formula_to_json(child));
  return {{"op", op}, {"parts", std::move(parts)}};
}

}  // namespace

Json formula_to_json(const Formula& formula) {
  using Op = Formula::Op;
  switch (formula.op) {
    case Op::Atom:
      return {{"op", "atom"}, {"predicate", info(formula.predicate).name}, {"terms", terms_to_json(formula)}};
    case Op::Equal:
      return {{"op", "equal"}, {"terms", terms_to_json(formula)}};
    case Op::And:
      return with_parts("and", formula);
    case Op::Or:
      return with_parts("or", formula);
    case Op::Not:
      return with_parts("not", formula);
    case Op::Imply:
      return with_parts("imply", formula);
    case Op::AtEnd:
      return with_parts("at-end", formula);
    case Op::Sometime:
      return with_parts("sometime", formula);
    case Op::Always:
      return with_parts("always", formula);
    case Op::Until:
      return with_parts("until", formula);
    case Op::Before:
      return with_parts("before", formula);
    case Op::Forall:
    case Op::Exists:
    case Op::Number: {
      Json json = quantified(formula.op == Op::Forall   ? "forall"
                             : formula.op == Op::Exists ? "exists"
                                                        : "number",
                             formula);
      json["body"] = formula_to_json(formula.children.front());
      return json;
    }
    case Op::Count: {
      Json json = quantified("count", formula);
      json["comparison"] = symbol_of(formula.comparison);
      json["number"] = formula.number;
      json["body"] = formula_to_json(formula.children.front());
      return json;
    }
    case Op::CountCompare: {
      Json json = with_parts("count-compare", formula);
      json["comparison"] = symbol_of(formula.comparison);
      return json;
    }
  }
  return {};
}

}  // namespace unietp
