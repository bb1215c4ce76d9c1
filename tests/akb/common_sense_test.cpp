#include <algorithm>

#include <gtest/gtest.h>

#include "akb/csv.h"
#include "core/files.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

bool holds(const Knowledge& k, const std::string& subject, const std::string& verb, const std::string& object) {
  if (verb == "can") return k.has(subject, object);
  const auto& relations = relation_names();
  if (std::find(relations.begin(), relations.end(), verb) != relations.end()) {
    return k.placement(subject, verb, object) != nullptr;
  }
  return k.effect(subject, verb, object) != nullptr;
}

TEST(CommonSense, TheTablesSayWhatPeopleSay) {
  const auto path = std::filesystem::path(UNIETP_SOURCE_DIR) / "tests" / "akb" / "common_sense.csv";
  const auto text = read_file(path);
  ASSERT_TRUE(text);
  const auto file = read_csv(path.string(), *text);
  ASSERT_TRUE(file.errors.empty()) << format(file.errors.front());
  EXPECT_GE(file.rows.size(), 60U);
  for (const auto simulator : kSimulators) {
    auto t = test::committed(simulator);
    const Knowledge k(simulator, t.categories, t.affordances, t.placements, t.effects, t.aliases);
    for (const auto& row : file.rows) {
      if (row[0].text != name_of(simulator)) continue;
      SCOPED_TRACE(row[0].text + ": " + row[1].text + " " + row[2].text + " " + row[3].text);
      EXPECT_NE(k.find(row[1].text), nullptr);
      EXPECT_EQ(holds(k, row[1].text, row[2].text, row[3].text), row[4].text == "true");
    }
  }
}

}  // namespace
}  // namespace unietp
