#include "authoring/expert_success.h"

#include <cmath>

#include "core/text.h"

namespace unietp {
namespace {

std::string percent(const ExpertSuccess& success) {
  return std::to_string(static_cast<int>(std::floor(100 * success.share()))) + " %";
}

/// The feedback at the end of a rejection's detail, with "…" for ids, in brackets; "" when it has none.
std::string feedback_in(const std::string& detail) {
  const auto last = detail.rfind(": ");
  if (last == std::string::npos || detail.compare(last + 2, 1, "(") == 0) return "";  // none, or a formula
  std::string text;
  for (const auto& word : split(detail.substr(last + 2), ' ')) {
    const bool names = word.find_first_of("0123456789(") != std::string::npos;
    text += (text.empty() ? "" : " ") + (names ? "…" : word);
  }
  return " (" + text.substr(0, text.find_last_not_of('.') + 1) + ")";
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
    for (const auto& detail : why.details) ++success.reasons[reason + feedback_in(detail)];
    if (why.details.empty()) success.reasons[reason] += why.count;
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
