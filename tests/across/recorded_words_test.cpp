// The words of the readers, which are tables of their own, are those of the writers.
#include "record/recorded_words.h"

#include <gtest/gtest.h>

#include "dataset/configuration.h"
#include "templates/template.h"

namespace unietp {
namespace {

TEST(RecordedWords, AreThoseThatAreWritten) {
  for (const Grade grade : kGrades) {
    const auto same = static_cast<RecordedGrade>(grade);  // both are in the same order
    EXPECT_EQ(recorded_grade(name_of(grade)), same);
    EXPECT_EQ(least_grade(name_of_least(grade)), same);
  }
  for (const HomeSource source : kHomeSources)
    EXPECT_EQ(recorded_homes(name_of(source)), static_cast<RecordedHomes>(source));
  for (const Split split :
       {Split::Atomic, Split::Compositional, Split::Logical, Split::InstanceGrounding, Split::Linguistic})
    EXPECT_EQ(recorded_split(name_of(split)), static_cast<RecordedSplit>(split));
  EXPECT_EQ(recorded_split("natural"), std::nullopt);
  EXPECT_EQ(recorded_grade("any"), std::nullopt);
  EXPECT_EQ(least_grade("senseless"), std::nullopt);
  EXPECT_EQ(recorded_homes("others"), std::nullopt);
}

TEST(Phrasings, AreFoundByTheirNames) {
  for (const Phrasings set : kPhrasings) EXPECT_EQ(phrasings_named(name_of(set)), set);
  EXPECT_EQ(phrasings_named("none"), std::nullopt);
}

}  // namespace
}  // namespace unietp
