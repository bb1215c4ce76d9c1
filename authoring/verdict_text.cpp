#include "authoring/verdict_text.h"

#include "authoring/trial_reasons.h"
#include "core/text.h"
#include "run/given_binding.h"

namespace unietp {
namespace {

constexpr std::size_t kMostNamed = 8;

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

std::string some_of(const std::vector<std::string>& names) {
  const auto shown = std::min(kMostNamed, names.size());
  auto text = join(std::vector<std::string>(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown)), ", ");
  return shown == names.size() ? text : text + " and " + std::to_string(names.size() - shown) + " more";
}

}  // namespace

std::string verdict_text(const Template& source, Simulator simulator, const BindingVerdict& verdict) {
  std::string text =
      source.name + " on " + std::string(name_of(simulator)) + " with " + to_text(verdict.binding) + "\n";
  const auto last = verdict.refusal ? verdict.refusal->gate : Gate::Reachable;
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    const auto gate = static_cast<Gate>(i);
    const bool refused = verdict.refusal && gate == last;
    text += "  " + padded(std::string(name_of(gate)), 18) + (refused ? "refused: " : "passed:  ") +
            std::string(meaning_of(gate)) + "\n";
  }
  if (!verdict.refusal) return text + "  all gates pass\n";
  text += "  why:     " + verdict.refusal->reason + (verdict.fact.empty() ? "" : ": " + verdict.fact) + "\n";
  text += "  change:  " + verdict.refusal->remedy + "\n";
  for (const auto& one : verdict.alternatives)
    text += "  " + one.placeholder + " could be: " + some_of(one.categories) + "\n";
  return text;
}

std::string trial_text(const TemplateTrial& trial) {
  std::string text = "  " + padded("homes", 18) + (trial.tasks.empty() ? "refused: " : "passed:  ") +
                     std::to_string(trial.tasks.size()) + " of " + std::to_string(trial.candidates) +
                     " candidates became verified tasks\n";
  for (const auto& task : trial.tasks) text += "  \"" + task.instruction.text + "\"\n";
  if (!trial.tasks.empty()) return text;
  for (const auto& why : trial.reasons) text += "  why:     " + text_of(why) + "\n";
  if (const auto change = likeliest_change(trial); !change.empty()) text += "  change:  " + change + "\n";
  return text;
}

}  // namespace unietp
