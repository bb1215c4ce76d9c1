#include "authoring/action_page.h"

#include <gtest/gtest.h>

#include "core/files.h"

namespace unietp {
namespace {

TEST(ActionPage, TheCommittedPageIsWhatTheCatalogAndTheProfilesGive) {
  std::vector<Profile> plain, wide;
  const std::filesystem::path source = UNIETP_SOURCE_DIR;
  for (const Simulator simulator : kSimulators) {
    const auto one = load_profile(source / "data/simulators", simulator);
    const auto other = load_profile(source / "data/simulators", simulator, ActionProfile::Wide);
    ASSERT_TRUE(one) << format(one.error());
    ASSERT_TRUE(other) << format(other.error());
    plain.push_back(*one);
    wide.push_back(*other);
  }
  const auto page = read_file(source / "docs/action-table.md");
  ASSERT_TRUE(page);
  EXPECT_EQ(*page, action_page(plain, wide)) << "write it anew: unietp actions --page > docs/action-table.md";
}

}  // namespace
}  // namespace unietp
