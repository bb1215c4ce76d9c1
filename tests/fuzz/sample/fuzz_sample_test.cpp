#include <algorithm>
#include <filesystem>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

#include "../bodies.h"
#include "core/files.h"
#include "core/rng.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

struct Parser {
  const char* name;  // of its folder of seeds
  bool (*body)(std::string_view);
};
void PrintTo(const Parser& parser, std::ostream* out) { *out << parser.name; }
constexpr Parser kParsers[] = {{"csv", fuzz::csv_body},
                               {"tables", fuzz::tables_body},
                               {"override", fuzz::override_body},
                               {"gzip", fuzz::gzip_body},
                               {"completion", fuzz::completion_body},
                               {"answers", fuzz::answers_body},
                               {"metadata", fuzz::metadata_body},
                               {"ithor", fuzz::ithor_body},
                               {"procthor", fuzz::procthor_body},
                               {"virtualhome", fuzz::virtualhome_body},
                               {"habitat", fuzz::habitat_body},
                               {"behavior", fuzz::behavior_body},
                               {"models", fuzz::models_body},
                               {"scene", fuzz::scene_body},
                               {"delta", fuzz::delta_body},
                               {"action", fuzz::action_body},
                               {"template", fuzz::template_body},
                               {"instruction", fuzz::instruction_body},
                               {"profile", fuzz::profile_body},
                               {"recipe", fuzz::recipe_body},
                               {"benchmark", fuzz::benchmark_body},
                               {"statistics", fuzz::statistics_body},
                               {"task", fuzz::task_body},
                               {"demonstration", fuzz::demonstration_body},
                               {"wordings", fuzz::wordings_body},
                               {"rejection", fuzz::rejection_body},
                               {"manifest", fuzz::manifest_body},
                               {"configuration", fuzz::configuration_body},
                               {"shard", fuzz::shard_body},
                               {"ledger", fuzz::ledger_body},
                               {"review", fuzz::review_body}};

std::vector<fs::path> seeds_of(const Parser& parser) {
  std::vector<fs::path> seeds;
  for (const auto& entry : fs::directory_iterator(fs::path(UNIETP_SOURCE_DIR) / "tests/fuzz/seeds" / parser.name))
    seeds.push_back(entry.path());
  std::sort(seeds.begin(), seeds.end());
  return seeds;
}

/// The text with up to four places overwritten, cut out or doubled.
std::string broken(std::string text, Rng& rng) {
  constexpr std::string_view kBytes = "()[]{}?-:,;\"'\\/\n\r|=<>019.eE+aAxtn_ \xff\x00";
  const std::uint64_t changes = 1 + rng.below(4);
  for (std::uint64_t i = 0; i < changes && !text.empty(); ++i) {
    const std::size_t at = rng.below(text.size());
    switch (rng.below(3)) {
      case 0:
        text[at] = kBytes[rng.below(kBytes.size())];
        break;
      case 1:
        text.erase(at, 1 + rng.below(8));
        break;
      default:
        text.insert(at, text.substr(rng.below(text.size()), rng.below(24)));
        break;
    }
  }
  return text;
}

class FuzzSample : public ::testing::TestWithParam<Parser> {};

TEST_P(FuzzSample, SeedsAreAcceptedUnlessTheirNameSaysBad) {
  const auto seeds = seeds_of(GetParam());
  EXPECT_FALSE(seeds.empty());
  for (const fs::path& seed : seeds) {
    const auto text = read_file(seed);
    ASSERT_TRUE(text) << format(text.error());
    EXPECT_EQ(GetParam().body(*text), !seed.filename().string().starts_with("bad-")) << seed;
  }
}

TEST_P(FuzzSample, BrokenSeedsAreRefusedOrReadAndNeverCrash) {
  constexpr std::uint64_t kTexts = 600;
  const auto seeds = seeds_of(GetParam());
  std::uint64_t refused = 0;
  for (std::uint64_t i = 0; i < kTexts; ++i) {
    Rng rng = Rng(i).fork(GetParam().name, 0);
    const auto text = read_file(seeds.at(rng.below(seeds.size())));
    ASSERT_TRUE(text);
    refused += GetParam().body(broken(*text, rng)) ? 0 : 1;
  }
  EXPECT_GT(refused, kTexts / 10);
}

INSTANTIATE_TEST_SUITE_P(Parsers, FuzzSample, ::testing::ValuesIn(kParsers),
                         [](const auto& parser) { return std::string(parser.param.name); });

}  // namespace
}  // namespace unietp
