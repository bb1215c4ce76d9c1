#include <cmath>
#include <iostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "import_rates.h"
#include "interchange/formats.h"

namespace unietp::testing {
namespace {

std::vector<SourceScene> real_scenes() {
  const auto text = read_maybe_gzip(upstream() / "ai2thor/ithor_scenes.json.gz");
  if (!text) return {};
  auto scenes = read_ithor("ithor_scenes.json.gz", *text);
  EXPECT_TRUE(scenes) << format(scenes.error());
  return scenes ? std::move(*scenes) : std::vector<SourceScene>{};
}

TEST(Ithor, RealScenesArriveAndHold) {
  const auto scenes = real_scenes();
  if (scenes.empty()) GTEST_SKIP() << "the simulators' own files are not there";
  const char* whole = std::getenv("UNIETP_WHOLE_IMPORT");
  const auto all = import_all(scenes, whole ? 1 : 10);
  for (const auto& [scene, report] : all) {
    SCOPED_TRACE(scene);
    EXPECT_GE(arrived_share(report), 0.95);
    EXPECT_GE(held_share(report), 0.9);
    if (!whole) continue;
    std::cout << scene << " objects " << report.objects << " known " << report.known << " arrived " << report.arrived
              << " stayed " << report.stayed << " relations " << report.relations << " held " << report.relations_held
              << " loose " << report.loose << " held " << report.loose_held << "\n";
    for (const auto& issue : report.issues) {
      std::cout << "  " << issue.reason << ": " << issue.object << ": " << issue.detail << "\n";
    }
  }
  std::cout << table_row("ithor", all) << "\n";
}

}  // namespace
}  // namespace unietp::testing
