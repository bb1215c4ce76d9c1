#pragma once

#include <map>
#include <string>
#include <vector>

#include "authoring/coverage.h"

namespace unietp {

/// Of the candidates that passed the geometric gates (a start was built, is at rest and meets its constraints), those
/// that the expert demonstrated in all modes asked for: its plan was executed, makes the goal true, and no mutation of
/// it does.
struct ExpertSuccess {
  int grounded = 0, shown = 0;
  std::map<std::string, int>
      reasons;  // why the others were not: "action-failed (too_far)", the failure where one is known
  double share() const { return grounded == 0 ? 1 : static_cast<double>(shown) / grounded; }
  ExpertSuccess& operator+=(const ExpertSuccess& other);
};
/// Templates with a lower share are listed.
inline constexpr double kWantedSuccess = 0.95;

/// Of one template on one simulator.
ExpertSuccess expert_success(const CoverageCell& cell);
/// Over all templates.
ExpertSuccess expert_success(const std::vector<CoverageRow>& rows, std::size_t simulator);

/// In Markdown: the share by simulator, then each template and simulator below kWantedSuccess with the reasons.
std::string expert_success_tables(const std::vector<CoverageRow>& rows);

}  // namespace unietp
