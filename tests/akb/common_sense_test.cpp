#include <algorithm>

#include <gtest/gtest.h>

#include "akb/csv.h"
#include "akb/table_words.h"
#include "core/files.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool holds(const Knowledge& k, const std::string& subject, const std::string& verb, const std::string& object) {
  if (verb == "can") return k.has(subject, object);
  if (const auto relation = placement_relation_named(verb)) return k.placement(subject, *relation, object) != nullptr;
  const auto treatment = treatment_named(verb);
  return treatment && k.effect(subject, *treatment, object) != nullptr;
}

/// What the row names and the tables do not have; "" when it can be asked. Without this, a misspelt false row passes.
std::string unknown_name(const Knowledge& k, const std::string& subject, const std::string& verb,
                         const std::string& object) {
  if (!contains(relation_names(), verb) && !contains(effect_names(), verb) && verb != "can") {
    return "verb '" + verb + "' is neither 'can' nor a relation nor an effect";
  }
  if (k.find(subject) == nullptr) return "subject '" + subject + "' is no category of this simulator";
  if (verb == "can") return contains(affordance_names(), object) ? "" : "'" + object + "' is no affordance";
  return k.find(object) == nullptr ? "object '" + object + "' is no category of this simulator" : "";
}

TEST(CommonSense, TheTablesSayWhatPeopleSay) {
  const auto path = std::filesystem::path(UNIETP_SOURCE_DIR) / "tests" / "akb" / "common_sense.csv";
  const auto text = read_file(path);
  ASSERT_TRUE(text);
  const auto file = read_csv(path.string(), *text);
  ASSERT_TRUE(file.errors.empty()) << format(file.errors.front());
  EXPECT_GE(file.rows.size(), 839U);
  std::size_t asked = 0;
  for (const auto simulator : kSimulators) {
    auto t = test::committed(simulator);
    const Knowledge k(simulator, t.categories, t.affordances, t.placements, t.effects, t.aliases);
    for (const auto& row : file.rows) {
      if (row[0].text != name_of(simulator)) continue;
      ++asked;
      SCOPED_TRACE(row[0].text + ": " + row[1].text + " " + row[2].text + " " + row[3].text);
      const auto unknown = unknown_name(k, row[1].text, row[2].text, row[3].text);
      EXPECT_EQ(unknown, "");
      if (!unknown.empty()) continue;
      EXPECT_TRUE(row[4].text == "true" || row[4].text == "false") << "truth '" << row[4].text << "'";
      EXPECT_EQ(holds(k, row[1].text, row[2].text, row[3].text), row[4].text == "true") << "people say " << row[4].text;
    }
  }
  EXPECT_EQ(asked, file.rows.size()) << "a row names no simulator";
}

}  // namespace
}  // namespace unietp
