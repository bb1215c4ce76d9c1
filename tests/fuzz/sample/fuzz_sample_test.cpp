#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

#include "../bodies.h"
#include "../json_mutator.h"
#include "../sqlite_mutator.h"
#include "broken.h"
#include "core/files.h"
#include "core/rng.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

using Mutator = std::optional<std::string>(std::string_view text, std::string_view donor, Rng rng);

struct Parser {
  const char* name;  // of its folder of seeds
  bool (*body)(std::string_view);
  Mutator* mutate;  // nullptr: only bytes change
};
void PrintTo(const Parser& parser, std::ostream* out) { *out << parser.name; }
constexpr Parser kParsers[] = {{"sexpr", fuzz::sexpr_body, nullptr},
                               {"formula", fuzz::formula_body, nullptr},
                               {"csv", fuzz::csv_body, nullptr},
                               {"shapes", fuzz::shapes_body, nullptr},
                               {"tables", fuzz::tables_body, nullptr},
                               {"override", fuzz::override_body, nullptr},
                               {"gzip", fuzz::gzip_body, nullptr},
                               {"curated", fuzz::curated_body, nullptr},
                               {"wordnet", fuzz::wordnet_body, nullptr},
                               {"http", fuzz::http_body, nullptr},
                               {"template", fuzz::template_body, nullptr},
                               {"instruction", fuzz::instruction_body, nullptr},
                               {"recipe", fuzz::recipe_body, nullptr},
                               {"benchmark", fuzz::benchmark_body, nullptr},
                               {"names", fuzz::names_body, nullptr},
                               {"sense", fuzz::sense_body, nullptr},
                               {"question", fuzz::question_body, nullptr},
                               {"completion", fuzz::completion_body, fuzz::mutate_json},
                               {"answers", fuzz::answers_body, fuzz::mutate_json},
                               {"metadata", fuzz::metadata_body, fuzz::mutate_json},
                               {"upstream", fuzz::upstream_body, fuzz::mutate_json},
                               {"catalog", fuzz::catalog_body, fuzz::mutate_json},
                               {"ithor", fuzz::ithor_body, fuzz::mutate_json},
                               {"procthor", fuzz::procthor_body, fuzz::mutate_json},
                               {"virtualhome", fuzz::virtualhome_body, fuzz::mutate_json},
                               {"habitat", fuzz::habitat_body, fuzz::mutate_json},
                               {"behavior", fuzz::behavior_body, fuzz::mutate_json},
                               {"models", fuzz::models_body, fuzz::mutate_json},
                               {"foreign", fuzz::foreign_body, fuzz::mutate_json},
                               {"scene", fuzz::scene_body, fuzz::mutate_json},
                               {"delta", fuzz::delta_body, fuzz::mutate_json},
                               {"action", fuzz::action_body, fuzz::mutate_json},
                               {"profile", fuzz::profile_body, fuzz::mutate_json},
                               {"statistics", fuzz::statistics_body, fuzz::mutate_json},
                               {"task", fuzz::task_body, fuzz::mutate_json},
                               {"demonstration", fuzz::demonstration_body, fuzz::mutate_json},
                               {"wordings", fuzz::wordings_body, fuzz::mutate_json},
                               {"rejection", fuzz::rejection_body, fuzz::mutate_json},
                               {"manifest", fuzz::manifest_body, fuzz::mutate_json},
                               {"prompt", fuzz::prompt_body, nullptr},
                               {"chat", fuzz::chat_body, fuzz::mutate_json},
                               {"episode", fuzz::episode_body, fuzz::mutate_json},
                               {"evaluation", fuzz::evaluation_body, fuzz::mutate_json},
                               {"mark", fuzz::mark_body, fuzz::mutate_json},
                               {"lines", fuzz::lines_body, fuzz::mutate_json},
                               {"configuration", fuzz::configuration_body, fuzz::mutate_json},
                               {"shard", fuzz::shard_body, fuzz::mutate_json},
                               {"review", fuzz::review_body, fuzz::mutate_json},
                               {"said", fuzz::said_body, fuzz::mutate_json},
                               {"settings", fuzz::settings_body, fuzz::mutate_json},
                               {"serve", fuzz::serve_body, fuzz::mutate_json},
                               {"database", fuzz::database_body, fuzz::mutate_sqlite},
                               {"rewording", fuzz::rewording_body, fuzz::mutate_sqlite},
                               {"knowledge", fuzz::knowledge_body, fuzz::mutate_sqlite},
                               {"library", fuzz::library_body, fuzz::mutate_sqlite},
                               {"cache", fuzz::cache_body, fuzz::mutate_sqlite},
                               {"ledger", fuzz::ledger_body, fuzz::mutate_sqlite}};

std::vector<fs::path> seeds_of(const Parser& parser) {
  std::vector<fs::path> seeds;
  for (const auto& entry : fs::directory_iterator(fs::path(UNIETP_SOURCE_DIR) / "tests/fuzz/seeds" / parser.name))
    seeds.push_back(entry.path());
  std::sort(seeds.begin(), seeds.end());
  return seeds;
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
  const char* given = std::getenv("UNIETP_FUZZ_TEXTS");  // for a long run
  const std::uint64_t texts = given == nullptr ? 600 : std::stoull(given);
  const auto seeds = seeds_of(GetParam());
  std::uint64_t refused = 0;
  for (std::uint64_t i = 0; i < texts; ++i) {
    Rng rng = Rng(i).fork(GetParam().name, 0);
    const auto text = read_file(seeds.at(rng.below(seeds.size())));
    ASSERT_TRUE(text);
    const auto donor = read_file(seeds.at(rng.below(seeds.size())));
    ASSERT_TRUE(donor);
    std::optional<std::string> changed;
    if (GetParam().mutate != nullptr && rng.chance(0.5)) changed = GetParam().mutate(*text, *donor, rng);
    refused += GetParam().body(changed ? *changed : fuzz::broken(*text, rng)) ? 0 : 1;
  }
  EXPECT_GT(refused, texts / 10);
}

INSTANTIATE_TEST_SUITE_P(Parsers, FuzzSample, ::testing::ValuesIn(kParsers),
                         [](const auto& parser) { return std::string(parser.param.name); });

}  // namespace
}  // namespace unietp
