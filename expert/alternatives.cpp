#include "expert/alternatives.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace unietp {
namespace {

constexpr std::size_t kMostPicks = 64;
constexpr double kNoWay = 1e6;

bool same_standing(const Alternative& a, const Alternative& b) {
  if (a.standing == b.standing) return true;
  return a.standing && b.standing && *a.standing == *b.standing;
}

bool same_choice(const Alternative& a, const Alternative& b) {
  if (a.cost != b.cost || a.end != b.end || !same_standing(a, b) || a.moments.size() != b.moments.size()) return false;
  for (std::size_t i = 0; i < a.moments.size(); ++i) {
    if (a.moments[i].literals != b.moments[i].literals || a.moments[i].after != b.moments[i].after) return false;
  }
  return a.maintained.size() == b.maintained.size();
}

void append_later_parts(Alternative& to, const Alternative& from) {
  const std::size_t offset = to.moments.size();
  for (Moment moment : from.moments) {
    for (std::size_t& before : moment.after) before += offset;
    to.moments.push_back(std::move(moment));
  }
  for (MaintenanceGoal keep : from.maintained) {
    if (keep.until != MaintenanceGoal::kAlways) keep.until += offset;
    to.maintained.push_back(std::move(keep));
  }
}

/// The one way is to leave things as they are.
bool only_stands(const Choices::List& list) {
  return list.size() == 1 && list.front().end.empty() && list.front().moments.empty() &&
         list.front().maintained.empty();
}

bool contradict(const Alternative& a, const Alternative& b, const Situation& situation) {
  const auto clashes = [&](const Literal& one, const Alternative& other) {
    return other.standing && clash(one, *other.standing, situation);
  };
  return std::any_of(b.end.begin(), b.end.end(), [&](const Literal& one) { return clashes(one, a); }) ||
         std::any_of(a.end.begin(), a.end.end(), [&](const Literal& one) {
           return clashes(one, b) || std::any_of(b.end.begin(), b.end.end(),
                                                 [&](const Literal& other) { return clash(one, other, situation); });
         });
}

std::shared_ptr<const LiteralSets> both_stand(const std::shared_ptr<const LiteralSets>& a,
                                              const std::shared_ptr<const LiteralSets>& b) {
  if (!a || a == b) return b;
  return b ? std::make_shared<const LiteralSets>(together(*a, *b)) : a;
}

double price_of(const Choices::List& list) { return list.empty() ? kNoWay : list.front().cost; }

}  // namespace

Choices::List Choices::trimmed(List list) const {
  std::stable_sort(list.begin(), list.end(),
                   [](const Alternative& a, const Alternative& b) { return a.cost < b.cost; });
  List kept;
  for (Alternative& alternative : list) {
    if (kept.size() == beam_) break;
    const bool repeated = std::any_of(kept.begin(), kept.end(),
                                      [&](const Alternative& other) { return same_choice(other, alternative); });
    if (!repeated) kept.push_back(std::move(alternative));
  }
  return kept;
}

Choices::List Choices::single(Literal literal) const {
  Alternative alternative;
  if (holds_in(literal, situation_.facts())) {
    alternative.standing = std::make_shared<const LiteralSets>(literal_sets({std::move(literal)}));
  } else {
    alternative.end.push_back(std::move(literal));
  }
  alternative.cost = estimate(alternative, situation_, experience_);
  return {std::move(alternative)};
}

Choices::List Choices::either(List a, List b) const {
  std::move(b.begin(), b.end(), std::back_inserter(a));
  return trimmed(std::move(a));
}

void Choices::leave_out_costlier(List& list, const List& than) const {
  if (than.size() < beam_) return;
  std::erase_if(list, [&](const Alternative& alternative) { return alternative.cost >= than.back().cost; });
}

void Choices::add(List& to, List more) const {
  leave_out_costlier(more, to);
  if (!more.empty()) to = either(std::move(to), std::move(more));
}

Choices::List Choices::both(List a, const List& b) const {
  List list;
  for (Alternative& left : a) {
    for (const Alternative& right : b) {
      // NOLINTNEXTLINE(bugprone-use-after-move): `left` is moved from with the last of `b`
      if (contradict(left, right, situation_)) continue;
      std::vector<Literal> end;
      std::set_union(left.end.begin(), left.end.end(), right.end.begin(), right.end.end(), std::back_inserter(end));
      Alternative merged = &right == &b.back() ? std::move(left) : left;  // of hundreds of members each has one way
      merged.end = std::move(end);
      merged.standing = both_stand(merged.standing, right.standing);
      append_later_parts(merged, right);
      merged.cost = estimate(merged, situation_, experience_);
      list.push_back(std::move(merged));
    }
  }
  return trimmed(std::move(list));
}

Choices::List Choices::all(const std::vector<const List*>& lists, std::vector<Literal> standing) const {
  List result;
  add_all_of(result, lists, std::move(standing));
  return result;
}

Choices::List Choices::with_standing(const List& list, const std::vector<const List*>& others,
                                     std::vector<Literal> standing) const {
  std::vector<std::shared_ptr<const LiteralSets>> shared;
  for (const List* other : others) {
    if (only_stands(*other) && other->front().standing) shared.push_back(other->front().standing);
  }
  if (standing.empty() && shared.empty()) return list;
  Alternative still;
  if (standing.empty() && shared.size() == 1) {
    still.standing = std::move(shared.front());
  } else {
    for (const auto& truths : shared) {
      for (const auto* part : {&truths->yes, &truths->no}) standing.insert(standing.end(), part->begin(), part->end());
    }
    still.standing = std::make_shared<const LiteralSets>(literal_sets(std::move(standing)));
  }
  return both(list, {still});
}

/// What only stands makes nothing cheaper: it is listed for what is cheap enough without.
void Choices::add_all_of(List& to, const std::vector<const List*>& lists, std::vector<Literal> standing) const {
  List common = nothing_to_do();
  for (const List* list : lists) {
    if (only_stands(*list)) continue;
    common = both(std::move(common), *list);
    leave_out_costlier(common, to);
    if (common.empty()) return;
  }
  add(to, with_standing(common, lists, std::move(standing)));
}

Choices::List Choices::in_turn(const List& a, const List& b) const {
  List list;
  for (const Alternative& left : a) {
    for (const Alternative& right : b) {
      Alternative merged;
      merged.moments.push_back({wanted_at_end(left), {}});
      merged.moments.push_back({wanted_at_end(right), {0}});
      merged.cost = estimate(merged, situation_, experience_);
      list.push_back(std::move(merged));
    }
  }
  return trimmed(std::move(list));
}

/// Which k of the members to take: the cheapest first, then neighbors of that choice.
std::vector<std::vector<bool>> Choices::picks(std::size_t k, const std::vector<double>& price) const {
  std::vector<std::size_t> order(price.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return price[a] < price[b]; });
  std::vector<bool> ranks(price.size(), false);  // by place in `order`
  std::fill(ranks.begin(), ranks.begin() + static_cast<std::ptrdiff_t>(k), true);
  std::vector<std::vector<bool>> result;
  do {
    std::vector<bool> pick(price.size(), false);
    for (std::size_t i = 0; i < ranks.size(); ++i) pick[order[i]] = ranks[i];
    result.push_back(std::move(pick));
  } while (result.size() < kMostPicks && std::prev_permutation(ranks.begin(), ranks.end()));
  return result;
}

Choices::List Choices::exactly(int k, const std::vector<Member>& members) const {
  if (k < 0 || static_cast<std::size_t>(k) > members.size()) return none();
  std::vector<double> price;
  for (const Member& member : members) price.push_back(price_of(member.yes) - price_of(member.no));
  List result;
  for (const std::vector<bool>& pick : picks(static_cast<std::size_t>(k), price)) {
    std::vector<const List*> lists;
    for (std::size_t i = 0; i < members.size(); ++i) lists.push_back(pick[i] ? &members[i].yes : &members[i].no);
    add_all_of(result, lists, {});
  }
  return result;
}

Choices::List Choices::at_least(int k, const std::vector<Member>& members) const {
  if (k <= 0) return nothing_to_do();
  if (static_cast<std::size_t>(k) > members.size()) return none();
  std::vector<double> price;
  for (const Member& member : members) price.push_back(price_of(member.yes));
  List result;
  for (const std::vector<bool>& pick : picks(static_cast<std::size_t>(k), price)) {
    std::vector<const List*> lists;
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (pick[i]) lists.push_back(&members[i].yes);
    }
    add_all_of(result, lists, {});
  }
  return result;
}

Choices::List Choices::at_most(int k, const std::vector<Member>& members) const {
  std::vector<Member> turned;
  for (const Member& member : members) turned.push_back({member.no, member.yes});
  return at_least(static_cast<int>(members.size()) - k, turned);
}

}  // namespace unietp
