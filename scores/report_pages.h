#pragma once

#include <functional>
#include <string>

#include "core/result.h"

namespace unietp {

/// The folder beside a report in which its episodes are.
inline constexpr const char* kReportFolder = "report";
inline constexpr int kEpisodesInPage = 32;

/// The episodes of a report as pages in a folder beside it, so many in each, which its viewer opens when it needs them:
/// a page can be opened from a disk, where a browser reads no other file.
class ReportPages {
 public:
  /// Takes the name of a page below the evaluation's folder ("report/0001.html") and its bytes.
  using Take = std::function<Result<Done>(const std::string& name, const std::string& page)>;
  explicit ReportPages(Take take) : take_(std::move(take)) {}

  /// `view`: JSON of an episode_view in one line. Errors: those of `take`.
  Result<Done> add(const std::string& view);
  /// After the last one.
  Result<Done> finish();

 private:
  Take take_;
  std::string views_;  // of the page that is not full yet
  int count_ = 0, pages_ = 0;
};

}  // namespace unietp
