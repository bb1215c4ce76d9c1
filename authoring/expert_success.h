#pragma once

#include <map>
#include <string>
#include <vector>

#include "authoring/coverage.h"

namespace unietp {

/// Of candidates that passed the geometric gates (a start was built, rests and meets its constraints), those that the
/// expert showed in all modes asked for: its plan was executed, makes the goal true, and withstands all mutations.
struct ExpertSuccess {
  int grounded = 0, shown = 0;
  std::map<std::string, int> reasons;  // why the others were not: reason and feedback
  double share() const { return grounded == 0 ? 1 : static_cast<double>(shown) / grounded; }
  ExpertSuccess& operator+=(const ExpertSuccess& other);
};
inline constexpr double kWantedSuccess = 0.95;

ExpertSuccess expert_success(const CoverageCell& cell);
/// Over all templates.
ExpertSuccess expert_success(const std::vector<CoverageRow>& rows, std::size_t simulator);

/// In Markdown: the share by simulator, then each template and simulator below kWantedSuccess with the reasons.
std::string expert_success_tables(const std::vector<CoverageRow>& rows);

}  // namespace unietp
