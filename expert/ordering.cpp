#include "expert/ordering.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

#include "expert/achievers.h"

namespace unietp {
namespace {

enum Stage {
  kBeforeCutting,
  kCutting,
  kClearing,
  kMoving,
  kFixedDevices,
  kHolding,
  kClosing,
  kSwitchingOn,
  kWalking,
  kSitting
};

class Ranker {
 public:
  Ranker(const Attempt& attempt, std::vector<Literal> open, const OrderPreferences& preferences)
      : attempt_(attempt), open_(std::move(open)), preferences_(preferences) {}

  auto key(const Literal& literal) const {
    const Node* node = attempt_.node(literal.subject);
    double meters = node == nullptr || attempt_.is_held(node->id) ? 0 : attempt_.world().walking_distance(node->id);
    if (preferences_.far_first) meters = -meters;
    const double room = preferences_.large_first && node != nullptr ? -node->size.x() * node->size.y() : 0;
    return std::tuple(stage(literal), depth(literal), room, meters, literal.subject, place_in_group(literal), literal);
  }

 private:
  bool movable(EntityIndex entity) const {
    const Node* node = attempt_.situation().node(entity);
    return node != nullptr && node->movable;
  }

  template <class Test>
  bool any_of_subject(EntityIndex subject, const Test& test) const {
    return std::any_of(open_.begin(), open_.end(),
                       [&](const Literal& other) { return other.subject == subject && test(other); });
  }

  Stage stage(const Literal& literal) const {
    if (literal.predicate == Predicate::Sliced) return kCutting;
    if (literal.predicate == Predicate::SatOn || literal.predicate == Predicate::LainOn) return kSitting;
    if (!movable(literal.subject)) {
      switch (literal.predicate) {
        case Predicate::InRoom:
          return kWalking;
        case Predicate::Closed:
          return kClosing;
        case Predicate::PowerOn:
          return kSwitchingOn;
        default:
          return kFixedDevices;
      }
    }
    const auto is_sliced = [](const Literal& other) { return other.predicate == Predicate::Sliced; };
    const auto is_held = [](const Literal& other) { return other.predicate == Predicate::Held && other.positive; };
    if (changes_in_hand(literal.predicate)) {
      if (any_of_subject(literal.subject, is_sliced)) return kBeforeCutting;
      if (depth(literal) > 0) return kClearing;  // wash the plate before something lies on it
    }
    if (any_of_subject(literal.subject, is_held)) return kHolding;
    const bool only_clearing = !any_of_subject(literal.subject, [](const Literal& other) { return other.positive; });
    return only_clearing ? kClearing : kMoving;
  }

  /// How many layers of things still have to be put into or on the literal's subject.
  int depth(const Literal& literal) const { return depth(literal.subject, 0); }
  int depth(EntityIndex carrier, int above) const {
    int deepest = 0;
    if (above > 4) return deepest;
    for (const Literal& other : open_) {
      if (other.object == carrier && other.positive && is_placement(other.predicate)) {
        deepest = std::max(deepest, 1 + depth(other.subject, above + 1));
      }
    }
    return deepest;
  }

  int place_in_group(const Literal& literal) const {
    const bool device =
        !changes_in_hand(literal.predicate) && !is_placement(literal.predicate) && literal.predicate != Predicate::Held;
    if (device) {
      const bool waits = literal.predicate == Predicate::Open || literal.predicate == Predicate::PowerOn;
      const bool then_out_of_reach = any_of_subject(literal.subject, [](const Literal& other) {
        return other.predicate == Predicate::Inside || other.predicate == Predicate::Held;
      });
      return waits && !then_out_of_reach && !preferences_.switch_before_placing ? 20 : 0;
    }
    switch (literal.predicate) {
      case Predicate::Empty:
        return 2;
      case Predicate::Clean:
        return 1;
      case Predicate::Soaked:
      case Predicate::Filled:
        return 3;
      case Predicate::Cooked:
      case Predicate::Burnt:
        return 4;
      case Predicate::Held:
        return 12;
      default:
        return is_placement(literal.predicate) ? 10 : 5;
    }
  }

  const Attempt& attempt_;
  std::vector<Literal> open_;
  OrderPreferences preferences_;
};

/// The thing to cut for a literal about a slice that does not exist yet.
std::optional<Literal> cut_for(const Attempt& attempt, const Literal& literal) {
  for (const EntityIndex entity : {literal.subject, literal.object}) {
    if (entity == kNobody || !attempt.situation().is_imagined(entity) || !attempt.id_of(entity).empty()) continue;
    Literal cut;
    cut.predicate = Predicate::Sliced;
    cut.subject = attempt.situation().slice(entity).whole;
    return cut;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Literal> next_literal(const Attempt& attempt, const std::vector<Literal>& literals,
                                    const OrderPreferences& preferences) {
  std::vector<Literal> open;
  for (const Literal& literal : literals) {
    if (attempt.holds(literal)) continue;
    open.push_back(cut_for(attempt, literal).value_or(literal));
  }
  if (open.empty()) return std::nullopt;
  if (open.size() == 1) return open.front();
  const Ranker ranker(attempt, open, preferences);
  const Literal* first = &open.front();
  auto least = ranker.key(*first);
  for (const Literal& literal : std::span(open).subspan(1)) {
    auto key = ranker.key(literal);
    if (key < least) least = std::move(key), first = &literal;
  }
  return *first;
}

std::vector<std::size_t> order_of_moments(const Alternative& alternative, const OrderPreferences& preferences) {
  std::vector<std::size_t> order;
  const std::size_t n = alternative.moments.size();
  std::vector<bool> done(n, false);
  for (std::size_t round = 0; round < n; ++round) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t m = preferences.far_first ? n - 1 - i : i;
      const auto& after = alternative.moments[m].after;
      if (done[m] || !std::all_of(after.begin(), after.end(), [&](std::size_t earlier) { return done[earlier]; })) {
        continue;
      }
      done[m] = true;
      order.push_back(m);
      break;
    }
  }
  return order;
}

}  // namespace unietp
