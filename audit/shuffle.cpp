#include "audit/shuffle.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace unietp {

KindPool pool_of(const std::vector<AuditedTask>& tasks, GuessChoice choice) {
  KindPool pool;
  for (const AuditedTask& task : tasks) {
    for (const GuessQuestion& question : task.questions) {
      if (question.choice != choice) continue;
      for (const GuessOption& option : question.options) pool[option.kind].push_back(&option);
    }
  }
  return pool;
}

Shuffler::Shuffler(const std::vector<GuessOption>& options, const LeakChannel& channel, const KindPool& pool)
    : options_(options), channel_(channel), listed_(options.size()), source_(options.size()) {
  for (const GuessOption& option : options) of_kind_.push_back(&pool.at(option.kind));
  std::iota(listed_.begin(), listed_.end(), std::size_t{0});
  std::stable_sort(listed_.begin(), listed_.end(),
                   [&](std::size_t a, std::size_t b) { return options[a].place < options[b].place; });
  std::map<std::uint64_t, std::vector<std::size_t>> kinds;
  for (const std::size_t i : listed_) kinds[options[i].kind].push_back(i);
  for (auto& [kind, members] : kinds) kinds_.push_back(std::move(members));
  std::set<int> begun;
  for (const std::size_t i : listed_) {
    const bool goes_on = !rooms_.empty() && options[rooms_.back().front()].room == options[i].room;
    if (!goes_on && !begun.insert(options[i].room).second) {
      rooms_.clear();  // the list comes back to a room
      break;
    }
    if (!goes_on) rooms_.emplace_back();
    rooms_.back().push_back(i);
  }
}

void Shuffler::draw(Rng& rng, std::vector<GuessOption>& shuffled) {
  for (const LeakChannel::Part& part : channel_.parts) {
    if (part.scope == ShuffleScope::OfAnyHome) {
      draw_of_any_home(part, rng, shuffled);
      continue;
    }
    draw_sources(part.scope, rng);
    for (const auto field : part.fields) {
      for (std::size_t i = 0; i < source_.size(); ++i) shuffled[i].*field = options_[source_[i]].*field;
    }
  }
}

void Shuffler::draw_of_any_home(const LeakChannel::Part& part, Rng& rng, std::vector<GuessOption>& shuffled) const {
  for (std::size_t i = 0; i < shuffled.size(); ++i) {
    const GuessOption& other = *rng.pick(*of_kind_[i]);
    for (const auto field : part.fields) shuffled[i].*field = other.*field;
  }
}

void Shuffler::draw_sources(ShuffleScope scope, Rng& rng) {
  if (scope == ShuffleScope::WithinKind) {
    for (const auto& members : kinds_) {
      order_ = members;
      rng.shuffle(order_);
      for (std::size_t i = 0; i < members.size(); ++i) source_[members[i]] = order_[i];
    }
    return;
  }
  if (scope == ShuffleScope::AcrossKinds) {
    order_.resize(kinds_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    rng.shuffle(order_);
    for (std::size_t k = 0; k < kinds_.size(); ++k) {
      for (const std::size_t i : kinds_[k]) source_[i] = kinds_[order_[k]].front();
    }
    return;
  }
  if (scope == ShuffleScope::InList && rooms_.size() > 1) {
    rng.shuffle(rooms_);
    order_.clear();
    for (auto& members : rooms_) {
      rng.shuffle(members);
      order_.insert(order_.end(), members.begin(), members.end());
    }
  } else {
    order_ = listed_;
    rng.shuffle(order_);
  }
  for (std::size_t i = 0; i < order_.size(); ++i) source_[order_[i]] = listed_[i];
}

}  // namespace unietp
