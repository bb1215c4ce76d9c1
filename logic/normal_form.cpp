#include <algorithm>
#include <tuple>

#include "logic/formula.h"

namespace unietp {
namespace {

using Op = Formula::Op;

/// Flattens and/or, drops double negations and lone children, so that quantifiers that neighbor in meaning do in form.
Formula flattened(const Formula& formula) {
  Formula result = formula;
  for (auto& where : result.domain.where) where = flattened(where);
  for (auto& child : result.children) child = flattened(child);
  if (result.op == Op::Not && result.children.front().op == Op::Not) {
    Formula inner = std::move(result.children.front().children.front());
    return inner;
  }
  if (result.op != Op::And && result.op != Op::Or) return result;
  std::vector<Formula> parts;
  for (auto& child : result.children) {
    if (child.op == result.op) {
      for (auto& part : child.children) parts.push_back(std::move(part));
    } else {
      parts.push_back(std::move(child));
    }
  }
  if (parts.size() == 1) return std::move(parts.front());
  result.children = std::move(parts);
  return result;
}

struct Binder {
  std::string variable;
  Domain domain;
};

/// Names bound variables by their depth; of the orders of neighboring quantifiers of one kind it takes the one with
/// the smallest text. Orders are tried only among quantifiers of equal domains, so the work stays small.
class Normalizer {
 public:
  explicit Normalizer(std::string prefix) : prefix_(std::move(prefix)) {}

  Formula normal(const Formula& formula, int depth) const {
    if (formula.op == Op::Forall || formula.op == Op::Exists) return normal_block(formula, depth);
    Formula result = formula;
    if (!result.variable.empty()) {  // count, number
      result.variable = name_at(depth);
      result.domain = normal(renamed(result.domain, formula.variable, result.variable), depth + 1);
      result.children.front() =
          normal(rename_variable(formula.children.front(), formula.variable, result.variable), depth + 1);
      return result;
    }
    if (result.op == Op::Equal && to_name(result.terms[1]) < to_name(result.terms[0])) {
      std::swap(result.terms[0], result.terms[1]);
    }
    for (auto& child : result.children) child = normal(child, depth);
    if (result.op == Op::And || result.op == Op::Or) sort_parts(result.children);
    if (result.children.size() == 1 && (result.op == Op::And || result.op == Op::Or)) {
      return std::move(result.children.front());
    }
    return result;
  }

 private:
  static std::string to_name(const Term& term) { return term.name; }
  std::string name_at(int depth) const { return prefix_ + std::to_string(depth); }

  static Domain renamed(Domain domain, const std::string& from, const std::string& to) {
    for (auto& where : domain.where) where = rename_variable(where, from, to);
    return domain;
  }

  Domain normal(Domain domain, int depth) const {
    for (auto& where : domain.where) where = normal(where, depth);
    std::sort(domain.members.begin(), domain.members.end(), [](const auto& a, const auto& b) {
      return std::tie(a.category, a.slice) < std::tie(b.category, b.slice);
    });
    domain.members.erase(std::unique(domain.members.begin(), domain.members.end()), domain.members.end());
    return domain;
  }

  static void sort_parts(std::vector<Formula>& parts) {
    std::vector<std::pair<std::string, Formula>> keyed;
    for (auto& part : parts) {
      std::string text = to_text(part);
      keyed.emplace_back(std::move(text), std::move(part));
    }
    std::sort(keyed.begin(), keyed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    parts.clear();
    for (auto& [text, part] : keyed) {
      if (parts.empty() || parts.back() != part) parts.push_back(std::move(part));
    }
  }

  Formula normal_block(const Formula& outer, int depth) const {
    std::vector<Binder> block;
    Formula body = outer;
    int at = depth;
    while (body.op == outer.op) {
      // Every binder gets a name of its own first, so that a later renaming cannot meet an equal one.
      const std::string own = prefix_ + "block" + std::to_string(at++);
      block.push_back({own, renamed(body.domain, body.variable, own)});
      Formula inner = rename_variable(body.children.front(), body.variable, own);
      body = std::move(inner);
    }
    return best_order(outer.op, std::move(block), body, depth);
  }

  /// Places one binder of the block, then the rest. Candidates: those whose `:where` names no binder still to place,
  /// and of these the ones with the smallest domain.
  Formula best_order(Op op, std::vector<Binder> block, const Formula& body, int depth) const {
    if (block.empty()) return normal(body, depth);
    std::string smallest;
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (depends_on_rest(block, i)) continue;
      Domain plain = normal(block[i].domain, depth);
      std::string key = plain.where.empty() ? "0" : "1";
      plain.where.clear();
      key += to_text(plain);
      if (candidates.empty() || key < smallest) {
        smallest = std::move(key);
        candidates.assign(1, i);
      } else if (key == smallest) {
        candidates.push_back(i);
      }
    }
    constexpr std::size_t kMostTried = 6;  // 720 orders; beyond that equal formulas may get unequal forms
    if (candidates.size() > kMostTried) candidates.erase(candidates.begin() + 1, candidates.end());
    std::string best_text;
    Formula best;
    for (const std::size_t i : candidates) {
      Formula tried = place(op, block, i, body, depth);
      std::string text = candidates.size() == 1 ? "" : to_text(tried);
      if (i != candidates.front() && !(text < best_text)) continue;
      best_text = std::move(text);
      best = std::move(tried);
    }
    return best;
  }

  static bool depends_on_rest(const std::vector<Binder>& block, std::size_t i) {
    for (const auto& where : block[i].domain.where) {
      for (const auto& name : free_variables(where)) {
        for (std::size_t j = 0; j < block.size(); ++j) {
          if (j != i && block[j].variable == name) return true;
        }
      }
    }
    return false;
  }

  Formula place(Op op, std::vector<Binder> block, std::size_t i, const Formula& body, int depth) const {
    const Binder chosen = block[i];
    const std::string name = name_at(depth);
    block.erase(block.begin() + static_cast<std::ptrdiff_t>(i));
    for (auto& other : block) other.domain = renamed(other.domain, chosen.variable, name);
    Formula result;
    result.op = op;
    result.variable = name;
    result.domain = normal(renamed(chosen.domain, chosen.variable, name), depth + 1);
    result.children.push_back(
        best_order(op, std::move(block), rename_variable(body, chosen.variable, name), depth + 1));
    return result;
  }

  std::string prefix_;
};

}  // namespace

Formula normal_form(const Formula& formula) {
  std::string prefix = "v";
  const auto free = free_variables(formula);
  const auto taken = [&] {
    return std::any_of(free.begin(), free.end(), [&](const auto& name) { return name.starts_with(prefix); });
  };
  while (taken()) prefix += '_';
  const Normalizer normalizer(prefix);
  Formula result = normalizer.normal(flattened(formula), 0);
  // Parts that turned out equal were joined, which can bring new neighbors together; each round makes it smaller.
  for (;;) {
    Formula again = normalizer.normal(flattened(result), 0);
    if (to_text(again).size() >= to_text(result).size()) return result;
    result = std::move(again);
  }
}

}  // namespace unietp
