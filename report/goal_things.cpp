#include "report/goal_things.h"

#include <algorithm>
#include <utility>

#include "core/text.h"
#include "scene/fresh_id.h"

namespace unietp {
namespace {

void add_categories(const Formula& part, std::set<std::string>& all) {
  if (part.domain.kind == Domain::Kind::Categories) {
    for (const auto& member : part.domain.members) all.insert(member.category);
  }
  for (const auto& where : part.domain.where) add_categories(where, all);
  for (const auto& child : part.children) add_categories(child, all);
}

/// "coffee_table_12" → "coffee_table"
std::string_view stem_of(std::string_view id) { return id.substr(0, id.rfind('_')); }

/// Ids that edits in words name: "added Book book_88 on desk_31", "moved book_4 on desk_31".
std::set<std::string> named_in(const std::vector<std::string>& edits, std::string_view verb, std::size_t word) {
  std::set<std::string> ids;
  for (const auto& edit : edits) {
    const auto words = split(edit.substr(0, edit.find(',')), ' ');
    if (words.size() > word && words.front() == verb) ids.insert(words[word]);
  }
  return ids;
}

}  // namespace

TaskGoalThings goal_things_of(const FinishedTask& task) {
  TaskGoalThings things;
  add_categories(task.record.goal_tree, things.categories);
  const auto shown = task.shown.find(Mode::M1);
  if (shown == task.shown.end()) return things;
  std::set<std::string> stems, ids;
  for (const auto& category : things.categories) stems.emplace(stem_of(fresh_id(Scene(), category)));
  for (const StepRecord& step : shown->second.steps) {
    for (const auto& argument : step.command.args) {
      if (stems.contains(std::string(stem_of(argument.id)))) ids.insert(argument.id);
    }
  }
  const auto added = named_in(task.record.edits, "added", 2), moved = named_in(task.record.edits, "moved", 1);
  for (const auto& id : ids) {
    ++things.objects;
    things.added += added.contains(id) ? 1 : 0;
    things.moved += moved.contains(id) ? 1 : 0;
  }
  return things;
}

void GoalThings::add(const TaskGoalThings& task) {
  ++tasks;
  objects += task.objects;
  added += task.added;
  moved += task.moved;
  for (const auto& category : task.categories) ++categories[category];
  named.insert(task.categories.begin(), task.categories.end());
}

void GoalThings::finish(const Knowledge& knowledge, const std::map<std::string, int>& in_homes) {
  const auto is_movable = [&](const std::string& name) {
    const auto* category = knowledge.find(name);
    return category != nullptr && category->movable;
  };
  std::erase_if(categories, [&](const auto& entry) { return !is_movable(entry.first); });
  movable = static_cast<int>(std::count_if(knowledge.categories().begin(), knowledge.categories().end(),
                                           [](const Category& one) { return one.movable; }));
  std::vector<std::pair<std::string, int>> common;
  for (const auto& entry : in_homes) {
    if (is_movable(entry.first)) common.push_back(entry);
  }
  std::stable_sort(common.begin(), common.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  common.resize(std::min(common.size(), kCommonest));
  for (const auto& [name, number] : common) {
    if (!categories.contains(name)) common_unused.push_back(name);
  }
}

std::string GoalThings::most_named() const {
  const auto most = std::max_element(categories.begin(), categories.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == categories.end() ? std::string() : most->first;
}

}  // namespace unietp
