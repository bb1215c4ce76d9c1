#pragma once

#include <string>
#include <vector>

#include "authoring/coverage.h"

namespace unietp {

/// What the other modes make, on one simulator, of the candidates that are demonstrated in M1.
struct ModeSuccess {
  int in_m1 = 0, in_all = 0;                       // candidates; in all modes that were asked for
  std::array<double, kModes.size()> mean_steps{};  // of those in all
  std::vector<TemplateTrial::Reason> reasons;      // why the others were given up, with the detail of the first of each
                                                   // template
};
std::array<ModeSuccess, kSimulators.size()> mode_success(const std::vector<CoverageRow>& rows);

/// A line for each simulator that had candidates, and the reasons below it.
std::string to_text(const std::array<ModeSuccess, kSimulators.size()>& success, const std::vector<Mode>& modes);

}  // namespace unietp
