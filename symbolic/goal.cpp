#include "symbolic/goal.h"

#include <algorithm>
#include <climits>

#include "logic/evaluate.h"

namespace unietp::symbolic {

using FormulaOp = Formula::Op;

/// Writes a formula out, variable by variable.
class GoalWriter {
 public:
  GoalWriter(Goal& goal, const Setting& setting, const World& start, const SeenStart& seen)
      : goal_(goal), setting_(setting), start_(start), seen_(seen) {}

  std::size_t write(const Formula& formula) {
    switch (formula.op) {
      case FormulaOp::Atom:
        return add_atom(formula);
      case FormulaOp::Equal:
        return constant(id_of(formula.terms[0]) == id_of(formula.terms[1]));
      case FormulaOp::And:
        return add(Goal::Op::And, all(formula.children));
      case FormulaOp::Or:
        return add(Goal::Op::Or, all(formula.children));
      case FormulaOp::Not:
        return add(Goal::Op::Not, {write(formula.children[0])});
      case FormulaOp::Imply:
        return add(Goal::Op::Or, {add(Goal::Op::Not, {write(formula.children[0])}), write(formula.children[1])});
      case FormulaOp::Forall:
        return add(Goal::Op::And, instances(formula, true));
      case FormulaOp::Exists:
        return add(Goal::Op::Or, instances(formula, false));
      case FormulaOp::Count:
        return add_count(formula);
      case FormulaOp::CountCompare:
        return add_compare(formula);
      case FormulaOp::Number:
        return constant(true);
      case FormulaOp::AtEnd:
        return add_temporal(Goal::Op::AtEnd, formula);
      case FormulaOp::Sometime:
        return add_temporal(Goal::Op::Sometime, formula);
      case FormulaOp::Always:
        return add_temporal(Goal::Op::Always, formula);
      case FormulaOp::Until:
        return add_temporal(Goal::Op::Until, formula);
      case FormulaOp::Before:
        return add_temporal(Goal::Op::Before, formula);
    }
    return constant(true);
  }

 private:
  std::size_t add(Goal::Op op, std::vector<std::size_t> children) {
    Goal::Node node;
    node.op = op;
    node.children = std::move(children);
    goal_.nodes_.push_back(std::move(node));
    return goal_.nodes_.size() - 1;
  }
  std::size_t constant(bool truth) { return add(truth ? Goal::Op::And : Goal::Op::Or, {}); }

  std::vector<std::size_t> all(const std::vector<Formula>& formulas) {
    std::vector<std::size_t> written;
    for (const auto& formula : formulas) written.push_back(write(formula));
    return written;
  }

  Id id_of(const Term& term) const {
    if (term.kind == Term::Kind::Agent) return kAgent;
    for (auto bound = scope_.rbegin(); bound != scope_.rend(); ++bound) {
      if (bound->first == term.name) return bound->second;
    }
    return kNobody;
  }

  std::size_t add_atom(const Formula& formula) {
    Atom atom;
    atom.predicate = formula.predicate;
    atom.first = id_of(formula.terms[0]);
    if (formula.terms.size() > 1) {
      const Term& second = formula.terms[1];
      if (second.kind != Term::Kind::Symbol) {
        atom.second = id_of(second);
      } else if (is_attribute(formula.predicate)) {
        return constant(has_attribute(formula.predicate, atom.first, second.name));
      } else if (second.name != "any") {
        const auto symbol = setting_.rules->symbol_named(second.name);
        if (!symbol) return constant(false);  // a substance that no tool gives and no vessel holds
        atom.symbol = *symbol;
      }
    }
    const std::size_t index = add(Goal::Op::Atom, {});
    goal_.nodes_[index].atom = atom;
    return index;
  }

  static bool is_attribute(Predicate predicate) {
    return predicate == Predicate::Color || predicate == Predicate::Material || predicate == Predicate::Size;
  }
  bool has_attribute(Predicate predicate, Id id, const std::string& word) const {
    if (!id.is_thing()) return false;
    const ObjectEntry& role = setting_.objects.object(id);
    const auto& own = predicate == Predicate::Color      ? role.color
                      : predicate == Predicate::Material ? role.material
                                                         : role.size;
    return !own.empty() && (own == word || word == "any");
  }

  Id id_of_entity(EntityIndex entity) const {
    const std::size_t things = setting_.objects.things.size();
    if (entity.index() < things) return Id::thing(entity.index());
    const std::size_t room = entity.index() - things;
    return room < setting_.objects.rooms.size() ? Id::room(room) : kAgent;
  }
  EntityIndex entity_of_id(Id id) const {
    const std::size_t things = setting_.objects.things.size();
    if (id == kAgent) return EntityIndex(things + setting_.objects.rooms.size());
    return EntityIndex(id.is_room() ? things + id.index() : id.index());
  }

  bool is_of(Id id, const Domain& domain) const {
    switch (domain.kind) {
      case Domain::Kind::Object:
        return id.is_thing();
      case Domain::Kind::Room:
        return id.is_room();
      case Domain::Kind::Agent:
        return id == kAgent;
      case Domain::Kind::Categories:
        break;
    }
    if (id == kAgent) return false;
    return std::any_of(domain.members.begin(), domain.members.end(), [&](const Domain::Member& member) {
      if (id.is_room()) return !member.slice && setting_.objects.room(id).type == member.category;
      const Id whole = setting_.objects.object(id).whole;
      if (!member.slice) return setting_.kind_of(id).category == member.category;
      return whole != kNobody && setting_.kind_of(whole).category == member.category;
    });
  }

  std::vector<Id> members(const Formula& quantifier) {
    std::vector<Id> found;
    const Domain& domain = quantifier.domain;
    if (domain.where.empty()) {
      const std::size_t all = setting_.objects.things.size() + setting_.objects.rooms.size() + 1;
      for (std::size_t i = 0; i < all; ++i) {
        const Id id = id_of_entity(EntityIndex(i));
        if (is_of(id, domain)) found.push_back(id);
      }
      return found;
    }
    if (seen_.trace != nullptr) return seen_members(quantifier);
    if (!trace_) trace_ = whole_trace_of(setting_, start_);
    Assignment assignment;
    for (const auto& [name, id] : scope_) assignment.emplace_back(name, entity_of_id(id));
    for (const auto entity : members_of(domain, quantifier.variable, *trace_, assignment))
      found.push_back(id_of_entity(entity));
    return found;
  }

  std::vector<Id> seen_members(const Formula& quantifier) const {
    Assignment assignment;
    for (const auto& [name, id] : scope_) {
      const auto place = std::find(seen_.ids->begin(), seen_.ids->end(), id);
      if (place != seen_.ids->end()) assignment.emplace_back(name, EntityIndex(place - seen_.ids->begin()));
    }
    std::vector<Id> found;
    for (const auto entity : members_of(quantifier.domain, quantifier.variable, *seen_.trace, assignment)) {
      if (const Id id = (*seen_.ids)[entity.index()]; id != kNobody) found.push_back(id);
    }
    return found;
  }

  /// The body for each member. A piece that does not exist yet counts only once it exists: before that, `forall` asks
  /// nothing of it, and nothing else can be true of it.
  std::vector<std::size_t> instances(const Formula& quantifier, bool universal) {
    std::vector<std::size_t> written;
    for (const Id id : members(quantifier)) {
      scope_.emplace_back(quantifier.variable, id);
      std::size_t body = write(quantifier.children.front());
      scope_.pop_back();
      if (id.is_thing() && !start_[id].exists) {
        const std::size_t is_there = add(Goal::Op::Atom, {});
        goal_.nodes_[is_there].atom = {Predicate::SliceOf, id, setting_.objects.object(id).whole, kAnySymbol};
        body = universal ? add(Goal::Op::Or, {add(Goal::Op::Not, {is_there}), body})
                         : add(Goal::Op::And, {is_there, body});
      }
      written.push_back(body);
    }
    return written;
  }

  std::size_t add_count(const Formula& formula) {
    const std::size_t index = add(Goal::Op::Count, instances(formula, false));
    auto& node = goal_.nodes_[index];
    const int n = formula.number;
    node.least = formula.comparison == Comparison::Greater ? n + 1 : n;
    node.most = formula.comparison == Comparison::Less ? n - 1 : n;
    if (formula.comparison == Comparison::AtLeast || formula.comparison == Comparison::Greater) node.most = INT_MAX;
    if (formula.comparison == Comparison::AtMost || formula.comparison == Comparison::Less) node.least = 0;
    return index;
  }

  std::size_t add_compare(const Formula& formula) {
    auto children = instances(formula.children[0], false);
    const std::size_t split = children.size();
    for (const auto child : instances(formula.children[1], false)) children.push_back(child);
    const std::size_t index = add(Goal::Op::Compare, std::move(children));
    goal_.nodes_[index].comparison = formula.comparison;
    goal_.nodes_[index].split = split;
    return index;
  }

  std::size_t add_temporal(Goal::Op op, const Formula& formula) {
    if (depth_ > 0) goal_.understood_ = false;
    ++depth_;
    const std::size_t index = add(op, all(formula.children));
    --depth_;
    if (op != Goal::Op::AtEnd) goal_.nodes_[index].memory = goal_.memories_++;
    return index;
  }

  Goal& goal_;
  const Setting& setting_;
  const World& start_;
  const SeenStart& seen_;
  std::optional<Trace> trace_;
  std::vector<std::pair<std::string, Id>> scope_;
  int depth_ = 0;
};

Goal::Goal(const Formula& goal, const Setting& setting, const World& start, const SeenStart& seen) {
  root_ = GoalWriter(*this, setting, start, seen).write(goal);
}

}  // namespace unietp::symbolic
