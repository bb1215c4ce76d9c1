#include "logic/evaluate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <limits>
#include <memory_resource>
#include <span>
#include <utility>

#include "logic/comparison.h"
#include "logic/membership.h"

namespace unietp {
namespace {

using Op = Formula::Op;
using Bits = std::pmr::vector<std::uint64_t>;

constexpr EntityIndex kNobody = EntityIndex::none();  // exists nowhere
constexpr int kAgentSlot = -1, kSymbolSlot = -2;

/// A formula with its variables resolved to slots of the assignment and its domains to lists of entities, so that
/// reading it touches no text. Built anew for each call, in one buffer.
struct Node {
  Op op = Op::And;
  Predicate predicate = Predicate::Open;
  Comparison comparison = Comparison::Equal;
  std::uint8_t arity = 0;
  int number = 0;
  double cost = 1;             // about how many atoms a reading takes
  std::array<int, 2> slots{};  // of the terms
  std::string_view symbol;
  int slot = 0;                          // of the bound variable
  std::span<const EntityIndex> members;  // of the domain
  const Node* where = nullptr;           // still to be read for each member; null when `members` has it done
  std::span<Node> children;
  const Node* link = nullptr;  // of `exists`: R(x, y) that its body needs of the bound y; y is looked for along R
  bool link_at_end = false;
  std::span<std::int8_t> known;  // by position, -1 until read: of what says the same whatever is chosen around it
};

class Reading {
 public:
  Reading(const Trace& trace, const Assignment& assignment)
      : trace_(trace),
        last_(trace.states.size() - 1),
        buffer_(storage_.data(), storage_.size()),
        names_(&buffer_),
        values_(&buffer_),
        agent_(find_agent(trace)),
        any_position_(&buffer_),
        domains_(&buffer_) {
    assert(!trace.states.empty());
    names_.reserve(16);
    values_.reserve(16);
    domains_.reserve(16);
    for (const auto& [name, entity] : assignment) {
      names_.push_back(name);
      values_.push_back(entity);
    }
    given_ = static_cast<int>(names_.size());
    for (const Facts& facts : trace.states) {
      const auto& words = facts.existing();
      if (any_position_.size() < words.size()) any_position_.resize(words.size());
      for (std::size_t i = 0; i < words.size(); ++i) any_position_[i] |= words[i];
    }
  }

  const Node* prepare(const Formula& formula) {
    Node* node = array<Node>(1);
    fill(*node, formula);
    return node;
  }

  bool holds(const Node& node, std::size_t i) {
    if (node.known.empty()) return read(node, i);
    if (node.known[i] < 0) node.known[i] = read(node, i) ? 1 : 0;
    return node.known[i] == 1;
  }

  std::span<const EntityIndex> members(const Domain& domain) {
    for (const auto& known : domains_) {
      if (known.domain->kind == domain.kind && known.domain->members == domain.members) return known.members;
    }
    const std::vector<EntityIndex> all = trace_.entities.of(domain);
    EntityIndex* list = array<EntityIndex>(all.size());
    std::size_t size = 0;
    for (const EntityIndex e : all) {
      if (exists_somewhere(e)) list[size++] = e;
    }
    domains_.push_back({&domain, {list, size}});
    return domains_.back().members;
  }

  /// The members that also satisfy the domain's `:where`, under the present assignment.
  std::vector<EntityIndex> chosen_members(const Domain& domain, const std::string& variable) {
    std::vector<EntityIndex> chosen;
    for (const EntityIndex e : members(domain)) {
      const int slot = push(variable);
      values_[static_cast<std::size_t>(slot)] = e;
      if (domain.where.empty() || (trace_.states[0].exists(e) && holds(*prepare(domain.where.front()), 0))) {
        chosen.push_back(e);
      }
      pop();
    }
    return chosen;
  }

  int push(std::string_view variable) {
    names_.push_back(variable);
    values_.resize(std::max(values_.size(), names_.size()), kNobody);
    return static_cast<int>(names_.size()) - 1;
  }
  void pop() { names_.pop_back(); }
  void assign(int slot, EntityIndex entity) { values_[static_cast<std::size_t>(slot)] = entity; }

 private:
  bool read(const Node& node, std::size_t i) {
    switch (node.op) {
      case Op::Atom:
        return holds_atom(node, i);
      case Op::Equal:
        return value(node.slots[0]) == value(node.slots[1]);
      case Op::And:
        for (const Node& child : node.children) {
          if (!holds(child, i)) return false;
        }
        return true;
      case Op::Or:
        for (const Node& child : node.children) {
          if (holds(child, i)) return true;
        }
        return false;
      case Op::Not:
        return !holds(node.children[0], i);
      case Op::Imply:
        return !holds(node.children[0], i) || holds(node.children[1], i);
      case Op::Forall:
        return !some_member(node, i, false);
      case Op::Exists:
        return some_member(node, i, true);
      case Op::Count:
        return compares(number_of(node, i), node.comparison, node.number);
      case Op::CountCompare:
        return compares(number_of(node.children[0], i), node.comparison, number_of(node.children[1], i));
      case Op::Number:
        break;
      case Op::AtEnd:
        return holds(node.children[0], last_);
      case Op::Sometime:
        for (std::size_t j = i; j <= last_; ++j) {
          if (holds(node.children[0], j)) return true;
        }
        return false;
      case Op::Always:
        for (std::size_t j = i; j <= last_; ++j) {
          if (!holds(node.children[0], j)) return false;
        }
        return true;
      case Op::Until:
        for (std::size_t j = i; j <= last_; ++j) {
          if (holds(node.children[1], j)) return true;
          if (!holds(node.children[0], j)) return false;
        }
        return false;
      case Op::Before: {
        const std::size_t f = first(node.children[0], i);
        if (f > last_) return false;
        const std::size_t g = first(node.children[1], i);
        return f < g && g <= last_;
      }
    }
    assert(false && "a number stands only in a comparison of counts");
    return false;
  }

  static EntityIndex find_agent(const Trace& trace) {
    for (std::size_t e = 0; e < trace.entities.size(); ++e) {
      if (trace.entities[e].kind == Entity::Kind::Agent) return EntityIndex(e);
    }
    return kNobody;
  }

  bool exists_somewhere(EntityIndex e) const {
    return e.index() / 64 < any_position_.size() && ((any_position_[e.index() / 64] >> (e.index() % 64)) & 1U) != 0;
  }

  template <class T>
  T* array(std::size_t count) {
    T* memory = static_cast<T*>(buffer_.allocate(std::max<std::size_t>(count, 1) * sizeof(T), alignof(T)));
    std::uninitialized_value_construct_n(memory, count);
    return memory;
  }

  int slot_of(const Term& term) const {
    if (term.kind == Term::Kind::Agent) return kAgentSlot;
    if (term.kind == Term::Kind::Symbol) return kSymbolSlot;
    for (std::size_t i = names_.size(); i > 0; --i) {
      if (names_[i - 1] == term.name) return static_cast<int>(i - 1);
    }
    assert(false && "a formula to be read has no free variables");
    return kAgentSlot;
  }

  /// `exists` in `exists`: any of them may come first.
  using Some = std::pmr::vector<const Formula*>;

  void fill(Node& node, const Formula& formula) {
    Some some(&buffer_);
    const Formula* body = &formula;
    const auto is_another = [&](const Formula& one) {
      return one.op == Op::Exists && one.domain.where.empty() &&
             std::none_of(some.begin(), some.end(), [&](auto* other) { return other->variable == one.variable; });
    };
    for (; is_another(*body); body = &body->children[0]) some.push_back(body);
    if (some.size() < 2) return fill_one(node, formula);
    fill_some(node, easiest_order(std::move(some), *body), *body);
  }

  /// An entity that another is related to comes after that one, so that it can be looked up.
  Some easiest_order(Some left, const Formula& body) {
    Some order(&buffer_);
    while (!left.empty()) {
      const auto leads_to = [&](const Formula* one) {
        return [&body, one](const Formula* other) {
          return other != one && relates(body, other->variable, one->variable);
        };
      };
      auto next = std::find_if(left.begin(), left.end(),
                               [&](auto* one) { return std::any_of(order.begin(), order.end(), leads_to(one)); });
      if (next == left.end())
        next = std::find_if(left.begin(), left.end(),
                            [&](auto* one) { return std::none_of(left.begin(), left.end(), leads_to(one)); });
      if (next == left.end()) next = left.begin();
      order.push_back(*next);
      left.erase(next);
    }
    return order;
  }

  /// Whether the formula implies that x is related to y.
  static bool relates(const Formula& formula, std::string_view x, std::string_view y) {
    const auto is = [](const Term& term, std::string_view name) {
      return term.kind == Term::Kind::Variable && term.name == name;
    };
    switch (formula.op) {
      case Op::Atom:
        return formula.terms.size() == 2 && is(formula.terms[0], x) && is(formula.terms[1], y);
      case Op::And:
      case Op::AtEnd:
      case Op::Exists:
        return std::any_of(formula.children.begin(), formula.children.end(),
                           [&](const Formula& child) { return relates(child, x, y); });
      default:
        return false;
    }
  }

  void fill_some(Node& node, std::span<const Formula* const> some, const Formula& body) {
    if (some.empty()) return fill(node, body);
    node.op = Op::Exists;
    node.members = members(some.front()->domain);
    node.slot = push(some.front()->variable);
    node.children = {array<Node>(1), 1};
    fill_some(node.children[0], some.subspan(1), body);
    pop();
    if (!set_apart(node)) finish(node);
  }

  void fill_one(Node& node, const Formula& formula) {
    node.op = formula.op;
    node.predicate = formula.predicate;
    node.comparison = formula.comparison;
    node.number = formula.number;
    node.arity = static_cast<std::uint8_t>(formula.terms.size());
    for (std::size_t i = 0; i < formula.terms.size(); ++i) {
      node.slots[i] = slot_of(formula.terms[i]);
      if (node.slots[i] == kSymbolSlot) node.symbol = formula.terms[i].name;
    }
    if (!formula.variable.empty()) {
      node.members = members(formula.domain);
      node.slot = push(formula.variable);
      if (!formula.domain.where.empty()) fill_where(node, formula);
    }
    Node* children = array<Node>(formula.children.size());
    node.children = {children, formula.children.size()};
    for (std::size_t i = 0; i < formula.children.size(); ++i) fill(children[i], formula.children[i]);
    if (!formula.variable.empty()) pop();
    if (node.op == Op::Exists && set_apart(node)) return;
    finish(node);
  }

  /// Prepares a node whose children are complete for fast evaluation.
  void finish(Node& node) {
    set_cost(node);
    if (node.op == Op::Exists) find_link(node);
    const bool quantifies = node.op == Op::Forall || node.op == Op::Exists || node.op == Op::Count;
    if (quantifies && node.slot > given_ && !names_any(node, given_, node.slot)) {
      node.known = {array<std::int8_t>(last_ + 1), last_ + 1};
      std::fill(node.known.begin(), node.known.end(), std::int8_t{-1});
    }
    if (node.op == Op::And || node.op == Op::Or) {  // cheap parts first: they often decide
      std::stable_sort(node.children.begin(), node.children.end(),
                       [](const Node& a, const Node& b) { return a.cost < b.cost; });
    }
  }

  /// Rewrites `exists y: P(x) and Q(y)` as `P(x) and exists y: Q(y)`: parts without y are evaluated once for all y, and
  /// the rest may have the same value for every x. Returns false and changes nothing when all parts contain y.
  bool set_apart(Node& node) {
    const bool at_end = node.children[0].op == Op::AtEnd;
    Node& body = at_end ? node.children[0].children[0] : node.children[0];
    if (body.op != Op::And) return false;
    const auto others = std::stable_partition(body.children.begin(), body.children.end(), [&](const Node& part) {
      return names_any(part, node.slot, node.slot + 1);
    });
    const auto own = static_cast<std::size_t>(others - body.children.begin());
    if (own == body.children.size()) return false;
    Node* parts = array<Node>(2);
    parts[0] = conjunction_of(body.children.subspan(own));
    body.children = body.children.first(own);
    finish(body);
    if (at_end) {
      Node* inner = array<Node>(1);
      *inner = std::exchange(parts[0], {});
      parts[0].op = Op::AtEnd;
      parts[0].children = {inner, 1};
      finish(parts[0]);
      finish(node.children[0]);
    }
    finish(node);
    parts[1] = node;
    node = conjunction_of({parts, 2});
    return true;
  }

  Node conjunction_of(std::span<Node> parts) {
    Node all;
    all.op = Op::And;
    all.children = parts;
    finish(all);
    return all;
  }

  static void find_link(Node& node) { static_cast<void>(find_link(node, node.children[0], false)); }
  /// Searches the parts that must hold for the node to hold.
  static bool find_link(Node& node, const Node& part, bool at_end) {
    switch (part.op) {
      case Op::Atom:
        if (part.arity != 2 || part.slots[1] != node.slot || part.slots[0] >= node.slot) return false;
        node.link = &part;
        node.link_at_end = at_end;
        return true;
      case Op::AtEnd:
        return find_link(node, part.children[0], true);
      case Op::And:
      case Op::Exists:
        return std::any_of(part.children.begin(), part.children.end(),
                           [&](const Node& child) { return find_link(node, child, at_end); });
      default:
        return false;
    }
  }

  void set_cost(Node& node) const {
    double factor = 1;
    if (is_temporal(node.op) && node.op != Op::AtEnd) factor = static_cast<double>(last_ + 1);
    if (!node.members.empty()) factor = static_cast<double>(node.members.size());
    double below = 0;
    for (const Node& child : node.children) below += child.cost;
    node.cost = 1 + factor * below;
  }

  /// A `:where` about its own variable only is read once here; one that names outer variables, for each member later.
  void fill_where(Node& node, const Formula& formula) {
    Node* where = array<Node>(1);
    fill(*where, formula.domain.where.front());
    const bool own = !names_any(*where, 0, node.slot);
    EntityIndex* list = array<EntityIndex>(node.members.size());
    std::size_t size = 0;
    for (const EntityIndex e : node.members) {
      assign(node.slot, e);
      if (trace_.states[0].exists(e) && (!own || holds(*where, 0))) list[size++] = e;
    }
    node.members = {list, size};
    if (!own) node.where = where;
  }

  /// Whether a variable in one of the slots from `from` to before `to` occurs in it.
  static bool names_any(const Node& node, int from, int to) {
    for (std::size_t i = 0; i < node.arity; ++i) {
      if (node.slots[i] >= from && node.slots[i] < to) return true;
    }
    if (node.where != nullptr && names_any(*node.where, from, to)) return true;
    return std::any_of(node.children.begin(), node.children.end(),
                       [&](const Node& child) { return names_any(child, from, to); });
  }

  EntityIndex value(int slot) const { return slot == kAgentSlot ? agent_ : values_[static_cast<std::size_t>(slot)]; }

  bool holds_atom(const Node& node, std::size_t i) const {
    const Facts& facts = trace_.states[i];
    const EntityIndex entity = value(node.slots[0]);
    if (node.arity == 1) return facts.holds(node.predicate, entity);
    if (node.slots[1] == kSymbolSlot) return facts.holds(node.predicate, entity, node.symbol);
    return facts.holds(node.predicate, entity, value(node.slots[1]));
  }

  /// Whether the body of a quantifier has the value `wanted` for some member of its domain.
  bool some_member(const Node& node, std::size_t i, bool wanted) {
    if (wanted && node.link != nullptr) {  // a thing stands in few relations
      const Facts& facts = trace_.states[node.link_at_end ? last_ : i];
      return facts.any_related(node.link->predicate, value(node.link->slots[0]), [&](EntityIndex e) {
        assign(node.slot, e);
        return std::binary_search(node.members.begin(), node.members.end(), e) &&
               (node.where == nullptr || holds(*node.where, 0)) && holds(node.children[0], i);
      });
    }
    for (const EntityIndex e : node.members) {
      assign(node.slot, e);
      if (node.where != nullptr && !holds(*node.where, 0)) continue;
      if (holds(node.children[0], i) == wanted) return true;
    }
    return false;
  }

  int number_of(const Node& node, std::size_t i) {
    int number = 0;
    for (const EntityIndex e : node.members) {
      assign(node.slot, e);
      if (node.where != nullptr && !holds(*node.where, 0)) continue;
      if (holds(node.children[0], i)) ++number;
    }
    return number;
  }

  /// The first position from i on at which the node holds; one past the last if there is none.
  std::size_t first(const Node& node, std::size_t i) {
    while (i <= last_ && !holds(node, i)) ++i;
    return i;
  }

  struct KnownDomain {
    const Domain* domain;
    std::span<const EntityIndex> members;
  };

  const Trace& trace_;
  std::size_t last_;
  alignas(std::max_align_t) std::array<std::byte, 16384> storage_;
  std::pmr::monotonic_buffer_resource buffer_;
  std::pmr::vector<std::string_view> names_;  // by slot; those in scope while a formula is prepared
  std::pmr::vector<EntityIndex> values_;      // by slot
  int given_ = 0;                             // how many of the slots were assigned before
  EntityIndex agent_;
  Bits any_position_;
  std::pmr::vector<KnownDomain> domains_;
};

}  // namespace

bool holds(const Formula& goal, const Trace& trace) { return holds_in(goal, trace, 0); }

bool holds_in(const Formula& formula, const Trace& trace, std::size_t position) {
  return holds_in(formula, trace, position, {});
}

bool holds_in(const Formula& formula, const Trace& trace, std::size_t position, const Assignment& assignment) {
  Reading reading(trace, assignment);
  return reading.holds(*reading.prepare(formula), position);
}

std::vector<EntityIndex> members_of(const Domain& domain, const std::string& variable, const Trace& trace,
                                    const Assignment& assignment) {
  return Reading(trace, assignment).chosen_members(domain, variable);
}

}  // namespace unietp
