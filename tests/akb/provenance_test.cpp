// Every fact can say where it comes from and on what terms.
#include "akb/provenance.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "akb/coverage.h"
#include "core/files.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

const std::filesystem::path kData = std::filesystem::path(UNIETP_SOURCE_DIR) / "data";

std::set<std::string> sources_in_use() {
  std::set<std::string> sources;
  for (const auto simulator : kSimulators) {
    for (const auto& [table, counted] : coverage_of(test::knowledge_of(simulator, test::committed(simulator))).tables) {
      for (const auto& [source, facts] : counted.by_source) sources.insert(source);
    }
  }
  return sources;
}

TEST(Provenance, EveryDerivedRuleInUseIsExplained) {
  std::vector<Error> errors;
  const auto rules = read_rules(kData / "akb" / "rules.csv", errors);
  EXPECT_TRUE(errors.empty());
  for (const auto& source : sources_in_use()) {
    if (source.starts_with("derived:")) {
      EXPECT_TRUE(meaning_of(rules, source)) << source << " needs a row in data/akb/rules.csv";
    }
  }
  std::set<std::string> once;
  for (const auto& rule : rules) EXPECT_TRUE(once.insert(rule.rule).second) << rule.rule;
}

TEST(Provenance, EverySourceInUseHasALicense) {
  std::vector<Error> errors;
  const auto licenses = read_licenses(kData / "licences.csv", errors);
  EXPECT_TRUE(errors.empty());
  for (const auto& source : sources_in_use()) EXPECT_TRUE(license_of(licenses, source)) << source;
  EXPECT_TRUE(license_of(licenses, "override:mine.csv"));
  EXPECT_FALSE(license_of(licenses, "metadata:nobody_allows_this.json"));
}

TEST(Provenance, TheLongestPrefixDecidesALicense) {
  const std::vector<License> licenses{{"metadata:a", "short", "X"}, {"metadata:a_b", "long", "Y"}};
  EXPECT_EQ(license_of(licenses, "metadata:a_b.json")->origin, "long");
  EXPECT_EQ(license_of(licenses, "metadata:a.json")->origin, "short");
  EXPECT_FALSE(license_of(licenses, "curated"));
}

TEST(Provenance, RowsWrittenByHandAreFoundByWhatTheySay) {
  const ScratchFolder folder;
  const auto write = [&](const std::string& name, const std::string& text) {
    EXPECT_TRUE(write_file(folder.path() / name, text));
  };
  write("lexicon.csv", "display,plural,width,mass\nplate,plates,0.2,\nmug,mugs,0.1,0.3\n");
  write("aliases.csv", "display,kind,text\nmug,synonym,cup\n");
  write("ai2thor/category.csv", "name,display,width,mass\nmug,,,0.4\n");
  write("ai2thor/removed.csv", "table,subject,verb,object\nrelation,mug,on,*\naffordance,mug,openable,\n");
  write("habitat/category.csv", "name,display,width,mass\nmug,,,0.5\n");
  write("ai2thor/broken.csv", "name,\"disp\nmug");
  const auto knowledge = test::small_knowledge();
  const auto rows = [&](std::string_view fact) {
    std::string text;
    for (const auto& row : curated_rows(folder.path(), Simulator::Ai2thor, *knowledge.find("mug"), *parse_fact(fact)))
      text += row.file + ":" + std::to_string(row.line) + " ";
    return text;
  };
  EXPECT_EQ(rows("mass"), "lexicon.csv:3 ai2thor/category.csv:2 ");
  EXPECT_EQ(rows("size"), "lexicon.csv:3 ");
  EXPECT_EQ(rows("alias:cup"), "aliases.csv:2 ");
  EXPECT_EQ(rows("on:plate"), "ai2thor/removed.csv:2 ");
  EXPECT_EQ(rows("openable"), "ai2thor/removed.csv:3 ");
  EXPECT_EQ(rows("rooms"), "");
}

}  // namespace
}  // namespace unietp
