// Reading goals: the evaluator on bit sets against a plain tree walk over a set of facts (the same answers, checked),
// and the monitor's cost of one more state after short and long traces.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdlib>
#include <map>
#include <set>

#include "core/rng.h"
#include "logic/evaluate.h"
#include "logic/monitor.h"

namespace {

using namespace unietp;

constexpr std::size_t kObjects = 210;
constexpr std::array kGoals = {
    "(exists (?t - C4) (at-end (and (count >= 2 (?x - C1) (on ?x ?t)) (exists (?y - C2) (on ?y ?t)))))",
    "(exists (?x - C1) (exists (?t - C4) (and (before (clean ?x) (on ?x ?t)) (at-end (and (on ?x ?t) (hot ?x))))))",
    "(exists (?t - C4) (forall (?x - (C1 :where (on ?x ?t))) (at-end (not (on ?x ?t)))))",
    "(exists (?x - C3) (and (always (not (held ?x))) (sometime (open ?x))))",
    "(exists (?x - C5) (always (sometime (open ?x))))",
};

/// A house of 20 categories whose facts change a little from state to state.
Trace house(std::size_t states) {
  Rng rng(20260101);
  Trace trace;
  for (std::size_t i = 0; i < kObjects; ++i) {
    Entity object{Entity::Kind::Object, "object_", "C", ""};
    object.id += std::to_string(i);
    object.category += std::to_string(i % 20);
    trace.entities.push_back(std::move(object));
  }
  std::vector<std::array<bool, 4>> states_of(kObjects);
  std::vector<EntityIndex> stands_on(kObjects);
  for (auto& below : stands_on) below = EntityIndex(rng.below(kObjects));
  constexpr std::array kStates = {Predicate::Open, Predicate::Hot, Predicate::Clean, Predicate::Held};
  for (std::size_t n = 0; n < states; ++n) {
    for (int change = 0; change < 4; ++change) {
      auto& flag = states_of[rng.below(kObjects)][rng.below(3)];
      flag = !flag;
      stands_on[rng.below(kObjects)] = EntityIndex(rng.below(kObjects));
    }
    Facts facts;
    for (EntityIndex e; e.index() < kObjects; ++e) {
      facts.set_exists(e);
      for (std::size_t k = 0; k < kStates.size(); ++k) {
        if (states_of[e.index()][k]) facts.set(kStates[k], e);
      }
      facts.set(Predicate::On, e, stands_on[e.index()]);
      facts.set(Predicate::NextTo, e, EntityIndex((e.index() + 1) % kObjects));
      facts.set(Predicate::NextTo, EntityIndex((e.index() + 1) % kObjects), e);
    }
    trace.states.push_back(std::move(facts));
  }
  return trace;
}

Formula goal_of(std::size_t index) {
  auto goal = parse_formula("bench", kGoals.at(index), FormulaUse::Goal);
  if (!goal) std::abort();
  return *goal;
}

/// The baseline: names looked up in maps, facts in a std::set of texts, categories compared object by object.
class PlainReader {
 public:
  explicit PlainReader(const Trace& trace) : trace_(trace) {
    const std::size_t count = trace.entities.size();
    for (const auto& facts : trace.states) {
      std::set<std::array<std::size_t, 3>> known;
      for (EntityIndex a; a.index() < count; ++a) {
        for (const auto& predicate : all_predicates()) {
          const auto p = static_cast<std::size_t>(predicate.predicate);
          if (predicate.arguments.size() == 1 && facts.holds(predicate.predicate, a)) known.insert({p, a.index(), 0});
          if (predicate.predicate != Predicate::On && predicate.predicate != Predicate::NextTo) continue;
          for (EntityIndex b; b.index() < count; ++b) {
            if (facts.holds(predicate.predicate, a, b)) known.insert({p, a.index(), b.index()});
          }
        }
      }
      states_.push_back(std::move(known));
    }
  }

  bool holds(const Formula& f, std::size_t i) {
    using enum Formula::Op;
    const std::size_t last = states_.size() - 1;
    const auto child = [&](std::size_t k, std::size_t at) { return holds(f.children[k], at); };
    switch (f.op) {
      case Atom:
        return states_[i].count({static_cast<std::size_t>(f.predicate), value_[f.terms[0].name].index(),
                                 f.terms.size() > 1 ? value_[f.terms[1].name].index() : 0}) > 0;
      case And:
        for (std::size_t k = 0; k < f.children.size(); ++k) {
          if (!child(k, i)) return false;
        }
        return true;
      case Not:
        return !child(0, i);
      case Forall:
        return number_of(f, i, false) == 0;
      case Exists:
        return number_of(f, i, true) > 0;
      case Count:
        return number_of(f, i, true) >= f.number;
      case AtEnd:
        return child(0, last);
      case Sometime:
        for (std::size_t j = i; j <= last; ++j) {
          if (child(0, j)) return true;
        }
        return false;
      case Always:
        for (std::size_t j = i; j <= last; ++j) {
          if (!child(0, j)) return false;
        }
        return true;
      case Before:
        for (std::size_t j = i; j <= last; ++j) {
          if (child(1, j)) return false;
          if (!child(0, j)) continue;
          for (++j; j <= last; ++j) {
            if (child(1, j)) return true;
          }
        }
        return false;
      default:
        std::abort();
    }
  }

 private:
  int number_of(const Formula& f, std::size_t i, bool wanted) {
    int number = 0;
    for (EntityIndex e; e.index() < trace_.entities.size(); ++e) {
      if (trace_.entities[e].category != f.domain.members.front().category) continue;
      value_[f.variable] = e;
      if (!f.domain.where.empty() && !holds(f.domain.where.front(), 0)) continue;
      if (holds(f.children.front(), i) == wanted) ++number;
      if (number > 0 && f.op != Formula::Op::Count) break;
    }
    return number;
  }

  const Trace& trace_;
  std::vector<std::set<std::array<std::size_t, 3>>> states_;
  std::map<std::string, EntityIndex> value_;
};

void evaluator(benchmark::State& state) {
  const Trace trace = house(21);
  const Formula goal = goal_of(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(holds(goal, trace));
  state.SetLabel(to_text(goal));
}
BENCHMARK(evaluator)->DenseRange(0, kGoals.size() - 1)->Unit(benchmark::kMicrosecond);

void plain_tree_walk(benchmark::State& state) {
  const Trace trace = house(21);
  const Formula goal = goal_of(static_cast<std::size_t>(state.range(0)));
  PlainReader reader(trace);
  if (reader.holds(goal, 0) != holds(goal, trace)) std::abort();
  for (auto _ : state) benchmark::DoNotOptimize(reader.holds(goal, 0));
}
BENCHMARK(plain_tree_walk)->DenseRange(0, kGoals.size() - 1)->Unit(benchmark::kMicrosecond);

/// One more state after `range(1)` states; the monitor is copied back so that its past keeps that length.
void monitor_step(benchmark::State& state) {
  const auto length = static_cast<std::size_t>(state.range(1));
  const Trace trace = house(length + 32);
  Monitor after(goal_of(static_cast<std::size_t>(state.range(0))));
  for (std::size_t i = 0; i < length; ++i) after.observe(trace.entities, trace.states[i]);
  Monitor running = after;
  std::size_t ahead = 0;
  for (auto _ : state) {
    if (ahead == 32) {
      state.PauseTiming();
      running = after;
      ahead = 0;
      state.ResumeTiming();
    }
    running.observe(trace.entities, trace.states[length + ahead++]);
    benchmark::DoNotOptimize(running.satisfied());
  }
}
BENCHMARK(monitor_step)->ArgsProduct({{0, 1, 2, 3, 4}, {20, 2000}})->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
