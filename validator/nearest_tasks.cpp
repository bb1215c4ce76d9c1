#include "validator/nearest_tasks.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace unietp {

double TaskLikeness::nearness() const {
  return std::min({home / kSimilarHome, goal / kSimilarGoal, text / kSimilarText});
}

NearestTasks::NearestTasks(ComparedSet other)
    : other_(std::move(other)), by_home_(std::make_unique<LazyValues<HomeLikenesses>>()) {}

std::optional<Nearest> NearestTasks::of(const TaskRecord& task, const Scene& home) const {
  if (other_.tasks.empty()) return std::nullopt;
  const auto homes = by_home_->get(task.layout, [&] {
    const HomeFingerprint print = print_of_home(home);
    HomeLikenesses likenesses;
    for (const auto& other : other_.homes) likenesses.push_back(likeness_of_homes(print, *other.print));
    return likenesses;
  });
  Nearest nearest;
  nearest.home_place = static_cast<std::size_t>(std::max_element(homes->begin(), homes->end()) - homes->begin());
  nearest.home = homes->at(nearest.home_place);

  const GoalPrint goal = print_of_goal(task.goal_tree);
  const TextFingerprint text = print_of_text(task.instruction);
  const auto by_goal = [](const TaskLikeness& one) { return std::tuple(one.goal, one.home); };
  const auto by_text = [](const TaskLikeness& one) { return std::tuple(one.text, one.goal, one.home); };
  for (std::size_t place = 0; place < other_.tasks.size(); ++place) {
    const auto& other = other_.tasks[place];
    TaskLikeness one{homes->at(other.home), likeness_of_goals(goal, other.goal), 1};
    const bool nearer_goal = place == 0 || by_goal(one) > by_goal(nearest.by_goal.likeness);
    const bool perhaps_nearer = one.nearness() > nearest.by_all.likeness.nearness();
    // The text is the costly part, and is needed exactly only where it can be the nearest.
    const double needed_from = nearer_goal || perhaps_nearer ? -1 : nearest.by_text.likeness.text - 1e-9;
    one.text = likeness_of_texts(text, other.text, needed_from);
    if (nearer_goal) nearest.by_goal = {place, one};
    if (place == 0 || by_text(one) > by_text(nearest.by_text.likeness)) nearest.by_text = {place, one};
    if (place == 0 || one.nearness() > nearest.by_all.likeness.nearness()) nearest.by_all = {place, one};
  }
  return nearest;
}

}  // namespace unietp
