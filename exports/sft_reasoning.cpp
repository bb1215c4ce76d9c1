#include "exports/sft_reasoning.h"

#include <algorithm>
#include <cctype>

#include "core/text.h"
#include "simulation/mode_rules.h"

namespace unietp {
namespace {

bool in_view(const StepRecord& step, const std::string& id) {
  return std::any_of(step.visible.begin(), step.visible.end(),
                     [&](const VisibleObject& object) { return object.id == id; });
}

bool of_a_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; }

/// Begins a sentence; ids stay as they are.
std::string sentence(std::string text) {
  const bool words = text.starts_with("a ") || text.starts_with("an ") || text.starts_with("the ");
  if (words) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

}  // namespace

std::string object_of(const StepRecord& step) {
  if (step.command.args.empty()) return "";
  const Argument& argument = step.command.args.front();
  if (!argument.box) return argument.id;
  for (const VisibleObject& object : step.visible) {
    if (object.box == *argument.box) return object.id;
  }
  return "";
}

SftReasoning::SftReasoning(const FinishedTask& task, Mode mode, const Knowledge& knowledge)
    : shown_(task.shown.at(mode)),
      mode_(mode),
      knowledge_(knowledge),
      facts_(reads_comparisons(task.record.goal_tree)),
      monitor_(task.record.goal_tree) {
  const GlobalInformation known = global_information(task.start, rules_of(mode));
  for (const auto* ids : {&known.rooms, &known.furniture, &known.movables}) known_.insert(ids->begin(), ids->end());
}

std::string SftReasoning::before_step(std::size_t index, const Scene& before) {
  for (const VisibleObject& object : shown_.steps[index].visible) seen_.insert(object.id);
  if (index > 0) {  // the moments that the last step led through; the last of them is `before`
    for (const Delta& moment : shown_.steps[index - 1].moments) {
      last_ = apply(std::move(last_), moment);
      observe(last_);
    }
  }
  last_ = before;
  observe(before);
  std::string text = sight(index, before) + hand(before);
  text += monitor_.satisfied() ? "Nothing is missing." : "Missing: " + in_own_words(monitor_.missing(), before) + ".";
  return text;
}

void SftReasoning::observe(const Scene& scene) {
  const Facts facts = facts_.read(scene);
  monitor_.observe(facts_.entities(), facts);
}

std::string SftReasoning::sight(std::size_t index, const Scene& before) const {
  const StepRecord& step = shown_.steps[index];
  if (step.command.action == info(ActionType::Stop).name) return "";
  const std::string target = object_of(step);
  const std::string sought = sought_after(index, before);
  if (!target.empty() && find_room(before, target) == nullptr) {
    if (in_view(step, target)) return sentence(name(target, before)) + " is in view. ";
    const std::string place = name(target, before);
    if (!sought.empty() && !known_.contains(sought) && !seen_.contains(sought))
      return sentence(name(sought, before)) + " is not in view; I look at " + place + ". ";
    return sentence(place) + (seen_.contains(target) ? " is not in view now; I have seen it. " : " is not in view. ");
  }
  if (sought.empty()) return "";
  if (in_view(step, sought)) return sentence(name(sought, before)) + " is in view, but not well. ";
  return sentence(name(sought, before)) + " is not in view; I look " +
         (target.empty() ? "around. " : "in " + target + ". ");
}

std::string SftReasoning::sought_after(std::size_t index, const Scene& before) const {
  const std::string now = object_of(shown_.steps[index]);
  for (std::size_t i = index + 1; i < shown_.steps.size(); ++i) {
    std::string target = object_of(shown_.steps[i]);
    if (target != now && find_node(before, target) != nullptr) return target;
  }
  return "";
}

std::string SftReasoning::hand(const Scene& before) const {
  if (before.agent.held.empty()) return "My hand is empty. ";
  std::vector<std::string> held;
  for (const auto& id : before.agent.held) held.push_back(name(id, before));
  return "I hold " + join(held, " and ") + ". ";
}

std::string SftReasoning::kind(const std::string& id, const Scene& scene) const {
  const Node* node = find_node(scene, id);
  const Category* category = node == nullptr ? nullptr : knowledge_.find(node->category);
  return category == nullptr ? replace_all(id, "_", " ") : category->display;
}

std::string SftReasoning::name(const std::string& id, const Scene& scene) const {
  if (find_node(scene, id) == nullptr) return id;
  if (mode_ == Mode::M3) return "the " + kind(id, scene);
  if (known_.contains(id) || seen_.contains(id)) return id;
  const std::string words = kind(id, scene);
  return (starts_with_vowel_letter(words) ? "an " : "a ") + words;
}

std::string SftReasoning::in_own_words(std::string_view text, const Scene& scene) const {
  std::string said;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && of_a_name(text[end])) ++end;
    if (end == at) {
      said += text[at++];
      continue;
    }
    said += name(std::string(text.substr(at, end - at)), scene);
    at = end;
  }
  return said;
}

}  // namespace unietp
