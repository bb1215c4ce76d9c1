#include "validator/task_facts.h"

#include <algorithm>
#include <map>

#include "core/text.h"
#include "logic/formula.h"
#include "simulation/digest.h"

namespace unietp {
namespace {

std::string text_of(const Digest& digest) { return std::to_string(digest.a) + "." + std::to_string(digest.b); }

void add_point(Digester& digest, const Vec3& v) { digest.add(v.x()).add(v.y()).add(v.z()); }

/// Everything of a start that a task can begin with, but what it is called.
std::string content_of(const Scene& start) {
  Digester digest;
  for (const Node& node : start.nodes) {
    digest.add(node.id).add(node.category).add(node.opening).add(node.mass);
    add_point(digest, node.size);
    add_point(digest, node.pose.position);
    const Quat& turn = node.pose.rotation;
    digest.add(turn.w()).add(turn.x()).add(turn.y()).add(turn.z());
    for (const State& state : node.states.all())
      digest.add(static_cast<std::uint64_t>(state.predicate)).add(state.symbol);
    digest.add(node.color).add(node.material).add(node.slice_of);
  }
  digest.add(start.agent.position.x()).add(start.agent.position.y()).add(start.agent.yaw).add(start.agent.pitch);
  for (const std::string& held : start.agent.held) digest.add(held);
  return text_of(digest.digest());
}

std::string start_key_of(const TaskRecord& task, const Scene& start) {
  std::string key = task.template_name + "\n" + task.goal_text + "\n" + task.layout + "\n";
  for (const auto& [placeholder, value] : task.bindings) key += placeholder + "=" + value + "\n";
  return key + home_key_of(start) + "\n" + content_of(start);
}

std::string arguments_text(const Command& command) {
  std::vector<std::string> texts;
  for (const Argument& argument : command.args) {
    if (!argument.box) {
      texts.push_back(argument.id);
      continue;
    }
    std::vector<std::string> edges;
    for (const int edge : *argument.box) edges.push_back(std::to_string(edge));
    texts.push_back("{\"bbox\":[" + join(edges, ",") + "]}");
  }
  return join(texts, ", ");
}

std::vector<TextRow> rows_of_steps(const std::map<Mode, DemonstrationRecord>& shown) {
  std::vector<TextRow> rows;
  for (const auto& [mode, demonstration] : shown) {
    for (std::size_t i = 0; i < demonstration.steps.size(); ++i) {
      const StepRecord& step = demonstration.steps[i];
      rows.push_back({std::string(name_of(mode)), std::to_string(i + 1), step.command.action,
                      arguments_text(step.command), step.success ? "1" : "0", step.failure});
    }
  }
  return rows;
}

/// Whether the goal or the start is about things of this category. Glass is a category and a material.
bool names_category(const TaskRecord& task, const std::string& category) {
  const auto in = [&](const Formula& formula) {
    const auto categories = categories_of(formula);
    return std::binary_search(categories.begin(), categories.end(), category);
  };
  return in(task.goal_tree) ||
         std::any_of(task.start_constraints.begin(), task.start_constraints.end(), [&](const std::string& text) {
           const auto constraint = parse_formula("start", text, FormulaUse::State);
           return constraint && in(*constraint);
         });
}

/// The narrowest kind of a category that the knowledge has words for in a style that names things by what they are for,
/// or by an occasion; "" for any other.
std::string use_of(const std::string& category, const std::string& style, const Knowledge& knowledge) {
  const auto named = alias_kind_named(style);
  if (!named || *named == AliasKind::Synonym || *named == AliasKind::Occasion) return "";  // no names of styles
  const AliasKind words = *named == AliasKind::Context ? AliasKind::Occasion : *named;
  const auto& kinds = knowledge.find(category)->kinds;
  return knowledge.aliases_of(category, words).empty() || kinds.empty() ? "" : kinds.front();
}

}  // namespace

std::string plain_words(std::string_view text) {
  std::string words;
  for (const char c : lower(text)) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
    if (letter) {
      words += c;
    } else if (!words.empty() && words.back() != ' ') {
      words += ' ';
    }
  }
  while (!words.empty() && words.back() == ' ') words.pop_back();
  return words;
}

std::string home_key_of(const Scene& home) {
  Digester digest;
  for (const Room& room : home.rooms) {
    digest.add(room.type);
    for (const Vec2& corner : room.polygon) digest.add(corner.x()).add(corner.y());
  }
  for (const Opening& opening : home.openings)
    digest.add(opening.from.x()).add(opening.from.y()).add(opening.to.x()).add(opening.to.y());
  for (const Node& node : home.nodes) {
    if (node.movable) continue;
    digest.add(node.category).add(node.pose.position.x()).add(node.pose.position.y()).add(node.pose.position.z());
  }
  return text_of(digest.digest());
}

TaskFacts facts_of(const TaskRecord& task, const Scene& home, const Scene& start,
                   const std::map<Mode, DemonstrationRecord>& shown, const Knowledge& knowledge) {
  TaskFacts facts;
  facts.start_key = start_key_of(task, start);
  facts.text_key = task.layout + "\n" + plain_words(task.instruction);
  facts.home_key = home_key_of(home);
  std::set<std::string> handled;
  if (const auto in_m1 = shown.find(Mode::M1); in_m1 != shown.end()) {
    for (const auto& step : in_m1->second.steps) {
      for (const Argument& argument : step.command.args) handled.insert(argument.id);
    }
  }
  std::map<std::string, std::string> type_of;
  std::set<std::string> types;
  for (const Room& room : start.rooms) {
    type_of[room.id] = room.type;
    types.insert(room.type);
  }
  for (const Edge& edge : start.edges) {
    if (edge.relation != Predicate::InRoom || handled.count(edge.from) == 0) continue;
    if (const auto type = type_of.find(edge.to); type != type_of.end())
      facts.rooms.insert(task.simulator + "/" + type->second);
  }
  for (const auto& [placeholder, value] : task.bindings) {
    if (knowledge.find(value) != nullptr && names_category(task, value)) {
      facts.bound_categories.insert(task.simulator + "/" + value);
      if (auto use = use_of(value, task.style, knowledge); !use.empty())
        facts.uses.emplace(task.simulator + "/" + value, std::move(use));
    } else if (types.contains(value)) {
      facts.bound_rooms.insert(task.simulator + "/" + value);
    }
  }
  if (shown.size() == task.expert.size()) facts.steps = rows_of_steps(shown);
  return facts;
}

}  // namespace unietp
