#include "logic/monitor_report.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "core/text.h"

namespace unietp::monitoring {
namespace {

using Kind = Node::Kind;

constexpr double kAlmost = 0.999;  // the most that something unmet can count

double mean(const std::vector<double>& shares) {
  if (shares.empty()) return 1;
  return std::accumulate(shares.begin(), shares.end(), 0.0) / static_cast<double>(shares.size());
}

double best(const std::vector<double>& shares) {
  return shares.empty() ? 0 : *std::max_element(shares.begin(), shares.end());
}

bool is_conjunctive(Kind kind) { return kind == Kind::And || kind == Kind::Forall; }

std::string relation_words(Relation relation, int number) {
  std::string text = std::to_string(number);
  switch (relation) {
    case Relation::Equal:
      return "exactly " + text;
    case Relation::Unequal:
      return "any number but " + text;
    case Relation::AtLeast:
      return "at least " + text;
    case Relation::AtMost:
      return "at most " + text;
    case Relation::Greater:
      return "more than " + text;
    case Relation::Less:
      return "fewer than " + text;
  }
  return text;
}

std::string relation_symbol(Relation relation) {
  switch (relation) {
    case Relation::Equal:
      return "=";
    case Relation::Unequal:
      return "!=";
    case Relation::AtLeast:
      return ">=";
    case Relation::AtMost:
      return "<=";
    case Relation::Greater:
      return ">";
    case Relation::Less:
      return "<";
  }
  return "";
}

}  // namespace

double Report::share_of_sum(const Node& node, const std::vector<double>& shares, int value) const {
  const bool grows =
      node.relation == Relation::AtLeast || node.relation == Relation::Greater || node.relation == Relation::Equal;
  const int needed = -node.constant + (node.relation == Relation::Greater ? 1 : 0);
  if (grows && node.summands.size() == 1 && value < 0 && needed > 0) {
    std::vector<double> sorted = shares;
    std::sort(sorted.begin(), sorted.end(), std::greater<>());
    sorted.resize(std::min(sorted.size(), static_cast<std::size_t>(needed)));
    return std::accumulate(sorted.begin(), sorted.end(), 0.0) / needed;
  }
  return 1.0 / (2.0 + std::abs(value));
}

/// The share of a formula that holds if it is read in the last state only.
double Report::share(const Node& node) {
  if (step_.now(node)) return 1;
  std::vector<double> shares;
  const auto over_members = [&](Slot slot, NodeId body) {
    for (const EntityIndex e : known_.members[slot]) {
      step_.value(slot) = Value(e);
      shares.push_back(share(program_.nodes[body]));
    }
    step_.value(slot) = Value::waiting(slot);
  };
  double result = 0;
  switch (node.kind) {
    case Kind::And:
    case Kind::Or:
      for (const NodeId child : node.children) shares.push_back(share(program_.nodes[child]));
      result = is_conjunctive(node.kind) ? mean(shares) : best(shares);
      break;
    case Kind::Forall:
    case Kind::Exists:
      over_members(node.slot, node.children.front());
      result = is_conjunctive(node.kind) ? mean(shares) : best(shares);
      break;
    case Kind::Sum: {
      int value = node.constant;
      for (const auto& summand : node.summands) {
        const std::size_t from = shares.size();
        over_members(summand.slot, summand.body);
        for (std::size_t i = from; i < shares.size(); ++i) value += shares[i] == 1 ? summand.weight : 0;
      }
      result = share_of_sum(node, shares, value);
      break;
    }
    case Kind::AtEnd:
    case Kind::Sometime:
    case Kind::Always:
      result = share(program_.nodes[node.children[0]]);
      break;
    case Kind::Until:
    case Kind::Release:
      result = share(program_.nodes[node.children[1]]);
      break;
    default:
      break;
  }
  return std::min(result, kAlmost);
}

double Report::progress(const Part& part) {
  if (part.now) return 1;
  const Node& node = program_.nodes[part.node];
  if (part.groups.empty()) {
    if (part.residual == kFalse) return 0;
    step_.enter(part.origin);
    return std::min(share(node), kAlmost);
  }
  std::vector<double> shares;
  int value = node.constant;
  for (const auto& group : part.groups) {
    for (const auto& inner : group.parts) {
      shares.push_back(progress(inner));
      value += inner.now ? group.weight : 0;
    }
  }
  const double result = node.kind == Kind::Sum      ? share_of_sum(node, shares, value)
                        : is_conjunctive(node.kind) ? mean(shares)
                                                    : best(shares);
  return std::min(result, kAlmost);
}

std::string Report::missing(const Part& part) {
  Reasons reasons;
  explain(part, reasons);
  Reasons distinct;
  for (auto& reason : reasons) {
    if (std::find(distinct.begin(), distinct.end(), reason) == distinct.end()) distinct.push_back(std::move(reason));
  }
  constexpr std::size_t kMost = 5;
  if (distinct.size() > kMost) {
    const std::size_t more = distinct.size() - kMost;
    distinct.resize(kMost);
    distinct.push_back("and " + std::to_string(more) + " more");
  }
  return join(distinct, "; ");
}

void Report::explain(const Part& part, Reasons& reasons) {
  if (part.now) return;
  if (part.groups.empty()) return explain_leaf(part, reasons);
  const Node& node = program_.nodes[part.node];
  if (is_conjunctive(node.kind)) {
    for (const auto& inner : part.groups.front().parts) explain(inner, reasons);
    return;
  }
  const Part* nearest = nullptr;
  double nearest_share = -1;
  int value = node.constant;
  for (const auto& group : part.groups) {
    for (const auto& inner : group.parts) {
      value += inner.now ? group.weight : 0;
      if (inner.now || group.weight < 0) continue;
      const double here = progress(inner);
      if (here <= nearest_share) continue;
      nearest = &inner;
      nearest_share = here;
    }
  }
  if (node.kind == Kind::Sum) reasons.push_back(sum_words(node, value));
  if (nearest != nullptr && (node.kind != Kind::Sum || value < 0))
    explain(*nearest, reasons);
  else if (node.kind == Kind::Exists)
    reasons.push_back("there is no " + program_.quantifiers[node.slot].words);
}

void Report::explain_leaf(const Part& part, Reasons& reasons) {
  const Node& node = program_.nodes[part.node];
  step_.enter(part.origin);
  if (part.residual == kFalse && node.kind != Kind::Atom && node.kind != Kind::Same && node.kind != Kind::Guard) {
    reasons.push_back("no longer possible: " + formula_words(node));
    return;
  }
  const std::size_t before = reasons.size();
  explain(node, reasons);
  if (reasons.size() == before) reasons.push_back("not yet: " + formula_words(node));
}

/// Why a formula does not hold in the last state.
void Report::explain(const Node& node, Reasons& reasons) {
  if (step_.now(node)) return;
  switch (node.kind) {
    case Kind::Atom:
    case Kind::Same:
      reasons.push_back(atom_words(node));
      return;
    case Kind::And:
      for (const NodeId child : node.children) explain(program_.nodes[child], reasons);
      return;
    case Kind::Or: {
      const auto nearest = std::max_element(node.children.begin(), node.children.end(), [&](NodeId a, NodeId b) {
        return share(program_.nodes[a]) < share(program_.nodes[b]);
      });
      if (nearest != node.children.end()) explain(program_.nodes[*nearest], reasons);
      return;
    }
    case Kind::Forall:
      for (const EntityIndex e : known_.members[node.slot]) {
        step_.value(node.slot) = Value(e);
        explain(program_.nodes[node.children[0]], reasons);
      }
      step_.value(node.slot) = Value::waiting(node.slot);
      return;
    case Kind::Exists:
    case Kind::Sum: {
      const bool is_sum = node.kind == Kind::Sum;
      const Slot slot = is_sum ? node.summands.front().slot : node.slot;
      const NodeId body = is_sum ? node.summands.front().body : node.children.front();
      int value = node.constant;
      std::optional<EntityIndex> nearest;
      double nearest_share = -1;
      for (const EntityIndex e : known_.members[slot]) {
        step_.value(slot) = Value(e);
        const double here = share(program_.nodes[body]);
        value += here == 1 ? 1 : 0;
        if (here == 1 || here <= nearest_share) continue;
        nearest = e;
        nearest_share = here;
      }
      for (std::size_t i = 1; i < node.summands.size(); ++i) {
        const auto& other = node.summands[i];
        for (const EntityIndex e : known_.members[other.slot]) {
          step_.value(other.slot) = Value(e);
          value += step_.now(program_.nodes[other.body]) ? other.weight : 0;
        }
        step_.value(other.slot) = Value::waiting(other.slot);
      }
      if (is_sum)
        reasons.push_back(sum_words(node, value));
      else if (!nearest)
        reasons.push_back("there is no " + program_.quantifiers[slot].words);
      if (nearest && (!is_sum || value < 0)) {
        step_.value(slot) = Value(*nearest);
        explain(program_.nodes[body], reasons);
      }
      step_.value(slot) = Value::waiting(slot);
      return;
    }
    case Kind::AtEnd:
    case Kind::Sometime:
    case Kind::Always:
      explain(program_.nodes[node.children[0]], reasons);
      return;
    case Kind::Until:
    case Kind::Release:
      explain(program_.nodes[node.children[1]], reasons);
      return;
    case Kind::Guard:
      reasons.push_back("at the start it was not so that " + formula_words(node));
      return;
    case Kind::True:
    case Kind::False:
      return;
  }
}

std::string Report::sum_words(const Node& node, int value) const {
  const std::string& counted = program_.quantifiers[node.summands.front().slot].words;
  if (node.summands.size() == 1) {
    return std::to_string(value - node.constant) + " of kind " + counted + " count, " +
           relation_words(node.relation, -node.constant) + " must";
  }
  const std::string& other = program_.quantifiers[node.summands.back().slot].words;
  return "counting " + counted + " against " + other + " gives a difference of " + std::to_string(value) +
         ", it must be " + relation_words(node.relation, 0);
}

std::string Report::name(const Node::Argument& argument) const {
  if (argument.kind == Node::Argument::Kind::Agent) return "agent";
  if (argument.kind == Node::Argument::Kind::Symbol) return argument.symbol;
  const Value value = step_.value(argument);
  if (value.waits() || value.entity().index() >= entities_.size()) return program_.quantifiers[argument.slot].words;
  return entities_[value.entity()].id;
}

/// The opposite of the literal, which does not hold: "mug_1 is not on table_2".
std::string Report::atom_words(const Node& node) const {
  const std::string a = node.arguments[0].kind == Node::Argument::Kind::None ? "" : name(node.arguments[0]);
  const std::string b = node.arguments[1].kind == Node::Argument::Kind::None ? "" : name(node.arguments[1]);
  if (node.kind == Kind::Same) return a + (node.positive ? " is not " : " is ") + b;
  const std::string not_word = node.positive ? "not " : "";
  const auto is = [&](const std::string& what) { return a + " is " + not_word + what; };
  switch (node.predicate) {
    case Predicate::Held:
      return is("held");
    case Predicate::SatOn:
      return "the agent does " + not_word + "sit on " + a;
    case Predicate::LainOn:
      return "the agent does " + not_word + "lie on " + a;
    case Predicate::Filled:
      return is("filled with " + b);
    case Predicate::Covered:
      return is("covered with " + b);
    case Predicate::Color:
    case Predicate::Material:
    case Predicate::Size:
      return is("of " + std::string(info(node.predicate).name) + " " + b);
    case Predicate::SliceOf:
      return is("a slice of " + b);
    case Predicate::Attached:
      return is("attached to " + b);
    case Predicate::Nearest:
      return is("the one nearest to " + b);
    case Predicate::OnFloor:
      return is("on the floor of " + b);
    case Predicate::InRoom:
      return is("in " + b);
    default:
      break;
  }
  const std::string word = replace_all(std::string(info(node.predicate).name), "_", " ");
  return is(b.empty() ? word : word + " " + b);
}

/// The formula with the objects' ids in place of variables that have one.
std::string Report::formula_words(const Node& node) const {
  const auto with_parts = [&](const std::string& word) {
    std::string text = "(" + word;
    for (const NodeId child : node.children) text += ' ' + formula_words(program_.nodes[child]);
    return text + ')';
  };
  switch (node.kind) {
    case Kind::True:
      return "(and)";
    case Kind::False:
      return "(or)";
    case Kind::Atom:
    case Kind::Same: {
      std::string text = "(";
      text += node.kind == Kind::Same ? "=" : info(node.predicate).name;
      for (const auto& argument : node.arguments) {
        if (argument.kind != Node::Argument::Kind::None) text += ' ' + name(argument);
      }
      text += ')';
      return node.positive ? text : "(not " + text + ")";
    }
    case Kind::And:
      return with_parts("and");
    case Kind::Or:
      return with_parts("or");
    case Kind::Forall:
      return with_parts("forall " + program_.quantifiers[node.slot].words);
    case Kind::Exists:
      return with_parts("exists " + program_.quantifiers[node.slot].words);
    case Kind::AtEnd:
      return with_parts("at-end");
    case Kind::Sometime:
      return with_parts("sometime");
    case Kind::Always:
      return with_parts("always");
    case Kind::Until:
      return with_parts("until");
    case Kind::Release:
      return with_parts("release");
    case Kind::Guard:
      return formula_words(program_.nodes[node.children.front()]);
    case Kind::Sum:
      break;
  }
  std::string text = "(count " + relation_symbol(node.relation) + ' ' + std::to_string(-node.constant);
  for (const auto& summand : node.summands) {
    text += summand.weight < 0 ? " less " : " ";
    text += program_.quantifiers[summand.slot].words + ' ' + formula_words(program_.nodes[summand.body]);
  }
  return text + ')';
}

}  // namespace unietp::monitoring
