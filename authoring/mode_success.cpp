#include "authoring/mode_success.h"

#include <cstdio>

#include "core/text.h"

namespace unietp {

std::array<ModeSuccess, kSimulators.size()> mode_success(const std::vector<CoverageRow>& rows) {
  std::array<ModeSuccess, kSimulators.size()> all;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < kSimulators.size(); ++i) {
      const auto& cell = row.cells[i];
      all[i].in_all += cell.accepted;
      all[i].in_m1 += cell.accepted;
      for (std::size_t mode = 0; mode < kModes.size(); ++mode) all[i].mean_steps[mode] += cell.steps[mode];
      for (const auto& why : cell.reasons) {
        if (why.reason != RejectionReason::NotInM2 && why.reason != RejectionReason::NotInM3) continue;
        all[i].in_m1 += why.count;
        all[i].reasons.push_back(why);
        all[i].reasons.back().example = row.name + ": " + why.example;
      }
    }
  }
  for (auto& one : all) {
    for (double& steps : one.mean_steps) steps = one.in_all > 0 ? steps / one.in_all : 0;
  }
  return all;
}

std::string to_text(const std::array<ModeSuccess, kSimulators.size()>& success, const std::vector<Mode>& modes) {
  std::string text;
  for (std::size_t i = 0; i < kSimulators.size(); ++i) {
    const auto& one = success[i];
    if (one.in_m1 == 0) continue;
    std::vector<std::string> steps;
    for (const Mode mode : modes) {
      std::array<char, 32> number{};
      (void)std::snprintf(number.data(), number.size(), " %.1f", one.mean_steps[static_cast<std::size_t>(mode)]);
      steps.push_back(std::string(name_of(mode)) + number.data());
    }
    std::array<char, 128> head{};
    (void)std::snprintf(
        head.data(), head.size(), "%-12s %d of %d candidates solved in M1 are solved in all modes (%.1f %%)",
        std::string(name_of(kSimulators[i])).c_str(), one.in_all, one.in_m1, 100.0 * one.in_all / one.in_m1);
    text += std::string(head.data()) + "; mean steps: " + join(steps, ", ") + "\n";
    for (const auto& why : one.reasons)
      text += "  " + std::to_string(why.count) + " " + std::string(name_of(why.reason)) + " " + why.example + "\n";
  }
  return text;
}

}  // namespace unietp
