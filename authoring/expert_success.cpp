#include "authoring/expert_success.h"

#include <cmath>

#include "core/text.h"

namespace unietp {
namespace {

std::string percent(const ExpertSuccess& success) {
  return std::to_string(static_cast<int>(std::floor(100 * success.share()))) + " %";
}

std::string row_of(const std::string& name, const ExpertSuccess& success) {
  std::vector<std::string> reasons;
  for (const auto& [reason, count] : success.reasons) reasons.push_back(reason + " " + std::to_string(count));
  return "| " + name + " | " + std::to_string(success.grounded) + " | " + std::to_string(success.shown) + " | " +
         percent(success) + " | " + join(reasons, ", ") + " |\n";
}

std::string head_of(const std::string& first) {
  return "| " + first + " | passed the gates | solved | share | failures |\n|---|---|---|---|---|\n";
}

}  // namespace

ExpertSuccess& ExpertSuccess::operator+=(const ExpertSuccess& other) {
  grounded += other.grounded;
  shown += other.shown;
  for (const auto& [reason, count] : other.reasons) reasons[reason] += count;
  return *this;
}

ExpertSuccess expert_success(const CoverageCell& cell) {
  ExpertSuccess success;
  success.grounded = cell.candidates;
  for (const auto& why : cell.reasons) {
    const auto stage = stage_of(why.reason);
    if (stage == RejectionStage::Generator || stage == RejectionStage::Grounding) success.grounded -= why.count;
    if (stage != RejectionStage::Expert) continue;
    const std::string reason(name_of(why.reason));
    int others = why.count;
    for (const auto& [failure, count] : why.failures) {
      success.reasons[reason + " (" + std::string(name_of(failure)) + ")"] += count;
      others -= count;
    }
    if (others > 0) success.reasons[reason] += others;
  }
  success.shown = success.grounded;
  for (const auto& [reason, count] : success.reasons) success.shown -= count;
  return success;
}

ExpertSuccess expert_success(const std::vector<CoverageRow>& rows, std::size_t simulator) {
  ExpertSuccess all;
  for (const auto& row : rows) all += expert_success(row.cells[simulator]);
  return all;
}

std::string expert_success_tables(const std::vector<CoverageRow>& rows) {
  auto text = head_of("simulator");
  ExpertSuccess all;
  for (std::size_t i = 0; i < kSimulators.size(); ++i) {
    const auto success = expert_success(rows, i);
    if (success.grounded > 0) text += row_of(std::string(name_of(kSimulators[i])), success);
    all += success;
  }
  text += row_of("all", all) + "\n";
  std::string below;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < kSimulators.size(); ++i) {
      const auto success = expert_success(row.cells[i]);
      if (success.share() < kWantedSuccess)
        below += row_of("`" + row.name + "` on " + std::string(name_of(kSimulators[i])), success);
    }
  }
  if (below.empty()) return text + "No template is below 95 % on any simulator.\n";
  return text + "Below 95 %:\n\n" + head_of("template and simulator") + below;
}

}  // namespace unietp
