#pragma once

#include <string>
#include <vector>

#include "authoring/coverage.h"

namespace unietp {

/// How many of the candidates demonstrated in M1 on one simulator are also demonstrated in the other modes.
struct ModeSuccess {
  int in_m1 = 0, in_all = 0;                       // candidates; in all modes that were asked for
  std::array<double, kModes.size()> mean_steps{};  // of those in all
  std::vector<TemplateTrial::Reason> reasons;      // why the others were rejected, with the detail of the first of each
                                                   // template
};
/// Sums over the rows, in the order of kSimulators.
std::array<ModeSuccess, kSimulators.size()> mode_success(const std::vector<CoverageRow>& rows);

/// A line for each simulator that had candidates, followed by the reasons.
std::string to_text(const std::array<ModeSuccess, kSimulators.size()>& success, const std::vector<Mode>& modes);

}  // namespace unietp
