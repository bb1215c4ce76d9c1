// Every synset that the tables name is one of WordNet 3.0's, read from Debian's wordnet-base.
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "akb/tables.h"
#include "core/text.h"
#include "scene/simulator.h"
#include "tests/support/needs.h"

namespace unietp {
namespace {

/// Number of noun senses by lemma.
std::map<std::string, int> noun_senses(const char* index) {
  std::map<std::string, int> senses;
  std::ifstream file(index);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == ' ') continue;  // the license
    std::istringstream words(line);
    std::string lemma, part;
    int count = 0;
    words >> lemma >> part >> count;
    senses[lemma] = count;
  }
  return senses;
}

TEST(Synsets, AreThoseOfWordNet) {
  const auto senses = noun_senses("/usr/share/wordnet/index.noun");
  if (senses.empty()) GTEST_SKIP() << needs::kWordNet;
  int checked = 0;
  for (const Simulator simulator : kSimulators) {
    std::vector<Error> errors;
    const auto folder = std::filesystem::path(UNIETP_SOURCE_DIR) / "data/akb" / std::string(name_of(simulator));
    const Tables tables = read_tables(folder, errors);
    ASSERT_TRUE(errors.empty()) << format(errors.front());
    for (const Category& category : tables.categories) {
      if (category.synset.empty()) continue;
      SCOPED_TRACE(std::string(name_of(simulator)) + " " + category.name + ": " + category.synset);
      const auto parts = split(category.synset, '.');
      ASSERT_EQ(parts.size(), 3u);
      EXPECT_EQ(parts[1], "n");
      const auto found = senses.find(lower(parts[0]));
      ASSERT_NE(found, senses.end());
      EXPECT_LE(std::stoi(parts[2]), found->second);
      ++checked;
    }
  }
  EXPECT_GT(checked, 200);
}

}  // namespace
}  // namespace unietp
