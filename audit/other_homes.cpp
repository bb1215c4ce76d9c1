#include "audit/other_homes.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "audit/word_key.h"

namespace unietp {
namespace {

using Counts = std::map<std::uint64_t, int>;  // by key

/// What is counted of the things of one kind.
enum class HomeTrait : std::uint8_t { Count, States, Support, Room, Asset };
constexpr std::size_t kTraits = static_cast<std::size_t>(HomeTrait::Asset) + 1;

struct KindCounts {
  std::array<Counts, kTraits> traits;
  const Counts& at(HomeTrait trait) const { return traits[static_cast<std::size_t>(trait)]; }
  int homes = 0;                  // that have it
  int tasks = 0, tasks_need = 0;  // in whose home it is; whose goal needs it
};

/// Counts of some homes and tasks. Those of one home can be taken from those of all.
struct Tally {
  std::map<std::uint64_t, KindCounts> kinds;
  std::map<std::uint64_t, int> template_needs, first_objects;  // by key of template and kind; of split, mode and kind
  std::map<Simulator, int> homes;
};

std::uint64_t trait_of(const GuessOption& thing, HomeTrait trait) {
  switch (trait) {
    case HomeTrait::Count:
      return static_cast<std::uint64_t>(thing.of_kind);
    case HomeTrait::States:
      return thing.states;
    case HomeTrait::Support:
      return thing.support;
    case HomeTrait::Room:
      return thing.room_type;
    case HomeTrait::Asset:
      return thing.has_asset ? 1 : 0;
  }
  return 0;
}

std::uint64_t template_key(const AuditedTask& task, std::uint64_t kind) { return word_key(task.template_name, kind); }
std::uint64_t first_key(const AuditedTask& task, Mode mode, std::uint64_t kind) {
  return word_key(task.split, kind + static_cast<std::uint64_t>(mode));
}

void add_home(Tally& tally, const AuditedTask& task) {
  ++tally.homes[task.simulator];
  Counts seen;
  for (const GuessOption& thing : task.things) {
    KindCounts& counts = tally.kinds[thing.kind];
    const bool is_first = ++seen[thing.kind] == 1;
    if (is_first) ++counts.homes;
    for (std::size_t trait = is_first ? 0 : 1; trait < kTraits; ++trait)  // the count once a home
      ++counts.traits[trait][trait_of(thing, static_cast<HomeTrait>(trait))];
  }
}

void add_task(Tally& tally, const AuditedTask& task) {
  std::map<std::uint64_t, bool> needed;
  for (std::size_t i = 0; i < task.things.size(); ++i) {
    bool& is_needed = needed[task.things[i].kind];
    is_needed = is_needed || task.needed[i];
  }
  for (const GuessQuestion& question : task.questions) {
    for (std::size_t i = 0; i < question.options.size(); ++i) {
      const std::uint64_t kind = question.options[i].kind;
      if (question.choice == GuessChoice::Room) needed[kind] = needed[kind] || question.right[i];
      if (question.choice == GuessChoice::FirstObject && question.right[i])
        ++tally.first_objects[first_key(task, question.mode, kind)];
    }
  }
  for (const auto& [kind, is_needed] : needed) {
    KindCounts& counts = tally.kinds[kind];
    ++counts.tasks;
    if (!is_needed) continue;
    ++counts.tasks_need;
    ++tally.template_needs[template_key(task, kind)];
  }
}

Tally tally_of(const std::vector<const AuditedTask*>& tasks) {
  Tally tally;
  std::map<std::string, bool> homes;
  for (const AuditedTask* task : tasks) {
    if (homes.emplace(task->home, true).second) add_home(tally, *task);
    add_task(tally, *task);
  }
  return tally;
}

template <class Key>
int count_in(const std::map<Key, int>& counts, const Key& key) {
  const auto found = counts.find(key);
  return found == counts.end() ? 0 : found->second;
}

const KindCounts* find_kind(const Tally& tally, std::uint64_t kind) {
  const auto found = tally.kinds.find(kind);
  return found == tally.kinds.end() ? nullptr : &found->second;
}

/// All homes but one.
class Others {
 public:
  Others(const Tally& all, const Tally& own) : all_(all), own_(own) {}

  void fill(GuessOption& option, const AuditedTask& task, Mode mode) const {
    const KindCounts* all = find_kind(all_, option.kind);
    const KindCounts* own = find_kind(own_, option.kind);
    const auto rest = [&](int KindCounts::*member) {
      return static_cast<float>((all == nullptr ? 0 : all->*member) - (own == nullptr ? 0 : own->*member));
    };
    const auto homes = static_cast<float>(count_in(all_.homes, task.simulator) - count_in(own_.homes, task.simulator));
    option.elsewhere = homes == 0 ? 0 : rest(&KindCounts::homes) / homes;
    option.goal_share = (rest(&KindCounts::tasks_need) + 0.5F) / (rest(&KindCounts::tasks) + 5);
    const std::uint64_t by_template = template_key(task, option.kind), by_first = first_key(task, mode, option.kind);
    option.template_share =
        static_cast<float>(count_in(all_.template_needs, by_template) - count_in(own_.template_needs, by_template));
    option.first_share =
        static_cast<float>(count_in(all_.first_objects, by_first) - count_in(own_.first_objects, by_first));
    option.odd_states = oddness(all, own, option, HomeTrait::States);
    option.odd_support =
        option.is_where_asked ? least_odd(all, own, HomeTrait::Support) : oddness(all, own, option, HomeTrait::Support);
    option.odd_room = oddness(all, own, option, HomeTrait::Room);
    option.odd_asset = oddness(all, own, option, HomeTrait::Asset);
    option.odd_count = oddness(all, own, option, HomeTrait::Count);
    option.more = fewer(all, own, option);
  }

 private:
  /// Calls `visit(value, count)` for the values of a trait in the other homes; returns the sum of the counts.
  template <class Visit>
  static float each(const KindCounts* all, const KindCounts* own, HomeTrait trait, const Visit& visit) {
    float sum = 0;
    if (all == nullptr) return sum;
    for (const auto& [value, count] : all->at(trait)) {
      const int rest = count - (own == nullptr ? 0 : count_in(own->at(trait), value));
      if (rest <= 0) continue;
      sum += static_cast<float>(rest);
      visit(value, rest);
    }
    return sum;
  }

  /// The share of things in other homes whose value is more frequent there than this one's; of equal ones, half.
  static float oddness(const KindCounts* all, const KindCounts* own, const GuessOption& option, HomeTrait trait) {
    const std::uint64_t value = trait_of(option, trait);
    int mine = 0;
    each(all, own, trait, [&](std::uint64_t other, int count) { mine = other == value ? count : mine; });
    float above = 0;
    const float sum = each(all, own, trait, [&](std::uint64_t, int count) {
      above += static_cast<float>(count) * (count > mine ? 1.0F : count == mine ? 0.5F : 0.0F);
    });
    return sum == 0 ? 0.5F : above / sum;
  }

  /// What oddness gives for the most frequent value.
  static float least_odd(const KindCounts* all, const KindCounts* own, HomeTrait trait) {
    int most = 0;
    each(all, own, trait, [&](std::uint64_t, int count) { most = std::max(most, count); });
    float equal = 0;
    const float sum = each(
        all, own, trait, [&](std::uint64_t, int count) { equal += count == most ? static_cast<float>(count) : 0.0F; });
    return sum == 0 ? 0.5F : equal / sum / 2;
  }

  /// The share of other homes with fewer of the kind, of those that have it; of as many, half.
  static float fewer(const KindCounts* all, const KindCounts* own, const GuessOption& option) {
    const std::uint64_t mine = trait_of(option, HomeTrait::Count);
    float below = 0;
    const float sum = each(all, own, HomeTrait::Count, [&](std::uint64_t other, int count) {
      below += static_cast<float>(count) * (other < mine ? 1.0F : other == mine ? 0.5F : 0.0F);
    });
    return sum == 0 ? 0.5F : below / sum;
  }

  const Tally& all_;
  const Tally& own_;
};

}  // namespace

void compare_with_other_homes(std::vector<AuditedTask>& tasks, const std::vector<AuditedTask>& examples) {
  std::vector<const AuditedTask*> all;
  std::map<std::string, std::vector<const AuditedTask*>> by_home;
  for (const AuditedTask& task : examples) {
    all.push_back(&task);
    by_home[task.home].push_back(&task);
  }
  const Tally tally = tally_of(all);
  std::map<std::string, Tally> own;
  for (const auto& [home, members] : by_home) own.emplace(home, tally_of(members));
  const Tally nothing;
  for (AuditedTask& task : tasks) {
    const auto found = own.find(task.home);
    const Others others(tally, found == own.end() ? nothing : found->second);
    for (GuessOption& thing : task.things) others.fill(thing, task, Mode::M1);
    for (GuessQuestion& question : task.questions) {
      for (GuessOption& option : question.options) others.fill(option, task, question.mode);
    }
  }
}

}  // namespace unietp
