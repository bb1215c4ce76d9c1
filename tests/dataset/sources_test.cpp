#include <gtest/gtest.h>

#include "dataset/manifest.h"
#include "tests/resources/committed.h"

namespace unietp {
namespace {

TEST(Sources, EverySourceOfAFactHasALicense) {
  const DataFolders folders{UNIETP_SOURCE_DIR, {}};
  const auto sources = sources_of(RunConfiguration{}, committed(), folders.licenses());
  ASSERT_TRUE(sources) << format(sources.error());
  EXPECT_GT(sources->size(), 5U);
  for (const auto& source : *sources) EXPECT_FALSE(source.license.empty()) << source.source;
}

}  // namespace
}  // namespace unietp
