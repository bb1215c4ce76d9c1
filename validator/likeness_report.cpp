#include "validator/likeness_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace unietp {
namespace {

constexpr std::size_t kClosest = 10;

/// Of equal values the one that is nearer to a leak comes first.
bool comes_before(const LikenessMeasure::Pair& a, const LikenessMeasure::Pair& b) {
  const auto nearness = [](const auto& pair) { return pair.likeness ? pair.likeness->nearness() : 0; };
  return std::pair(a.value, nearness(a)) > std::pair(b.value, nearness(b));
}

void add_pair(LikenessMeasure& measure, LikenessMeasure::Pair pair) {
  measure.values.push_back(pair.value);
  auto& closest = measure.closest;
  const auto after = std::upper_bound(closest.begin(), closest.end(), pair, comes_before);
  if (after == closest.end() && closest.size() == kClosest) return;
  closest.insert(after, std::move(pair));
  if (closest.size() > kClosest) closest.pop_back();
}

}  // namespace

double LikenessMeasure::quantile(double share) const {
  if (values.empty()) return 0;
  const auto place = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[place == 0 ? 0 : place - 1];
}

LikenessCount::LikenessCount(std::string folder) {
  report_.folder = std::move(folder);
  report_.measures = {LikenessMeasure{"homes", kCopiedHome, {}, {}}, LikenessMeasure{"goals", std::nullopt, {}, {}},
                      LikenessMeasure{"texts", std::nullopt, {}, {}}, LikenessMeasure{"tasks", 1.0, {}, {}}};
}

void LikenessCount::add(const TaskRecord& task, const Nearest& nearest, const ComparedSet& other) {
  auto& [homes, goals, texts, tasks] = report_.measures;
  if (homes_.insert(task.layout).second)
    add_pair(homes, {task.layout, other.homes[nearest.home_place].name, nearest.home, std::nullopt});
  const auto add_task = [&](LikenessMeasure& measure, const Nearest::Task& one, double value) {
    add_pair(measure, {task.id, other.tasks[one.place].name, value, one.likeness});
  };
  add_task(goals, nearest.by_goal, nearest.by_goal.likeness.goal);
  add_task(texts, nearest.by_text, nearest.by_text.likeness.text);
  if (nearest.by_text.likeness.text == 1) ++report_.shared_texts;
  add_task(tasks, nearest.by_all, nearest.by_all.likeness.nearness());
}

LikenessReport LikenessCount::report() const {
  LikenessReport report = report_;
  for (auto& measure : report.measures) std::sort(measure.values.begin(), measure.values.end());
  return report;
}

}  // namespace unietp
