#include "validator/problem_list.h"

#include <iterator>

namespace unietp {

void ProblemList::add(Problem problem) {
  if (!problem.task.empty()) tasks_.insert(key_of(problem.task));
  const auto before = counts_[static_cast<std::size_t>(problem.kind)]++;
  if (static_cast<std::size_t>(before) < kKept) kept_.push_back(std::move(problem));
}

void ProblemList::add(std::vector<Problem> problems) {
  for (Problem& problem : problems) add(std::move(problem));
}

void ProblemList::add(ProblemList other) {
  std::array<std::int64_t, kProblemKinds> added{};
  for (Problem& problem : other.kept_) {
    ++added[static_cast<std::size_t>(problem.kind)];
    add(std::move(problem));
  }
  for (std::size_t kind = 0; kind < kProblemKinds; ++kind) counts_[kind] += other.counts_[kind] - added[kind];
  tasks_.insert(other.tasks_.begin(), other.tasks_.end());
}

}  // namespace unietp
