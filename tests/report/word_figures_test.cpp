#include "report/word_figures.h"
#include "report/formula_census.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <sstream>

#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

TEST(WordFigures, AreCountedByText) {
  const auto figures = word_figures({{"atomic", "Wash a mug.", true},
                                     {"atomic", "Wash a mug, please."},
                                     {"logical", "Make sure that the large red mug that is on a table is clean."},
                                     {"logical", "Could you wash a plate?"},
                                     {"logical", "..."}});
  EXPECT_EQ(figures.texts, 4);
  EXPECT_DOUBLE_EQ(figures.mean_words.at("all"), (3 + 4 + 14 + 5) / 4.0);
  EXPECT_DOUBLE_EQ(figures.mean_words.at("atomic and compositional"), 3.5);
  EXPECT_DOUBLE_EQ(figures.mean_words.at("other splits"), 9.5);
  EXPECT_DOUBLE_EQ(figures.at_most_10_words, 0.75);
  EXPECT_DOUBLE_EQ(figures.ten_openings, 1);
  EXPECT_DOUBLE_EQ(figures.frames, 0.25);
  EXPECT_DOUBLE_EQ(figures.polite, 0.5);
  EXPECT_DOUBLE_EQ(figures.by_author, 0.25);
  EXPECT_EQ(figures.bigrams.at({"a", "mug"}), 2);
  EXPECT_FALSE(figures.bigrams.contains({"mug", "please."}));
}

TEST(WordFigures, CountTheWordsForEachPartOfTheGoal) {
  const auto figures =
      word_figures({{"atomic", "Wash a mug and put it in the sink.", false, 2},
                    {"logical", "Wash the mug that I left next to the sink in the kitchen.", false, 1}});
  EXPECT_DOUBLE_EQ(figures.words_for_each_part, (9 + 13) / 3.0);
  EXPECT_DOUBLE_EQ(figures.over_9_for_each_part, 0.5);
  const auto parts = [](const char* goal) { return parts_of(*parse_formula("goal", goal, FormulaUse::Goal)); };
  EXPECT_EQ(parts("(exists (?a - Mug) (at-end (clean ?a)))"), 1);
  EXPECT_EQ(
      parts("(exists (?a - Mug) (exists (?b - Sink) (and (before (clean ?a) (inside ?a ?b)) (at-end (and (clean ?a) "
            "(inside ?a ?b))))))"),
      2);
  EXPECT_EQ(parts("(exists (?a - (Mug :where (exists (?c - Desk) (on ?a ?c)))) (at-end (clean ?a)))"), 2);
}

TEST(WordFigures, CompareTheGoalsOfPeoplesKindsAlone) {
  const auto like = [](const char* simulator, const char* goal) {
    return is_like_human_goals(simulator, *parse_formula("goal", goal, FormulaUse::Goal));
  };
  constexpr const char* kPlace = "(exists (?a - Mug) (exists (?b - Desk) (at-end (and (clean ?a) (on ?a ?b)))))";
  EXPECT_TRUE(like("ai2thor", kPlace));
  EXPECT_TRUE(like("ai2thor", "(exists (?b - Desk) (at-end (count >= 2 (?a - Mug) (on ?a ?b))))"));
  EXPECT_FALSE(like("behavior", kPlace));
  EXPECT_FALSE(like("ai2thor", "(exists (?a - Mug) (at-end (clean ?a)))"));
  EXPECT_FALSE(like("ai2thor", "(exists (?a - Mug) (forall (?b - Desk) (at-end (on ?a ?b))))"));
  EXPECT_FALSE(like("ai2thor", "(exists (?a - (Mug :where (dirty ?a))) (exists (?b - Desk) (at-end (on ?a ?b))))"));
  const auto figures = word_figures({{"atomic", "Wash a mug.", false, 1, true}, {"atomic", "Open it."}});
  EXPECT_EQ(figures.texts_like_human, 1);
  EXPECT_EQ(figures.like_human, (Bigrams{{{"wash", "a"}, 1}, {{"a", "mug"}, 1}}));
}

TEST(WordFigures, TheDivergenceIsNoneFromTheSameAndOneFromOthers) {
  HumanGoals human;
  human.bigrams[{"wash", "a"}] = 500;
  human.bigrams[{"a", "mug"}] = 500;
  EXPECT_LT(distance_to_human({{{"wash", "a"}, 400}, {{"a", "mug"}, 400}}, human), 0.001);
  EXPECT_DOUBLE_EQ(distance_to_human({{{"close", "the"}, 400}}, human), 1);
  const double half = distance_to_human({{{"wash", "a"}, 400}, {{"close", "the"}, 400}}, human);
  EXPECT_NEAR(half, 0.5, 0.02);
  EXPECT_LT(distance_within_human(800, human), 0.001);
}

TEST(WordFigures, TheTableHasTheWordsOfPeopleBesideThoseOfAllSplitsAlone) {
  HumanGoals human;
  human.figures["mean_words"] = 9.25;
  human.bigrams[{"wash", "a"}] = 5;
  const auto table =
      word_table({{"mine", word_figures({{"atomic", "Wash a mug."}, {"logical", "Wash a plate."}})}}, human);
  const auto cells_after = [&](const std::string& label) {
    std::istringstream rest(table.substr(table.find(label) + label.size()));
    std::string line, cell;
    std::getline(rest, line);
    std::istringstream words(line);
    std::vector<std::string> cells;
    while (words >> cell) cells.push_back(cell);
    return cells;
  };
  using Cells = std::vector<std::string>;
  EXPECT_EQ(cells_after("mean words, all"), (Cells{"3.0", "9.2"})) << table;
  EXPECT_EQ(cells_after("mean words, atomic and compositional"), (Cells{"3.0"}));
  EXPECT_EQ(cells_after("mean words, other splits"), (Cells{"3.0"}));
  EXPECT_TRUE(table.ends_with("parts of speech: ./check tags FOLDER GOALS.jsonl.gz, with a tagger of npm\n")) << table;
}

TEST(WordFigures, OfPeopleAreReadFromTheirFilesAndFaultsAreTold) {
  const ScratchFolder folder;
  const auto write = [&](const char* name, const char* text) { std::ofstream(folder.path() / name) << text; };
  write("human_goals.csv", "# from somewhere\nfigure,value\nmean_words,9.25\npairs_that_occur_once,12\n");
  write("human_bigrams.csv", "first,second,count\nput,a,7\n");
  const auto read = read_human_goals(folder.path());
  ASSERT_TRUE(read) << format(read.error());
  EXPECT_DOUBLE_EQ(read->figures.at("mean_words"), 9.25);
  EXPECT_EQ(read->single_bigrams, 12);
  EXPECT_EQ(read->bigrams.at({"put", "a"}), 7);
  for (const char* wrong : {"first,second,count\nput,a\n", "first,second,count\nput,a,one\n"}) {
    write("human_bigrams.csv", wrong);
    EXPECT_FALSE(read_human_goals(folder.path())) << wrong;
  }
  std::filesystem::remove(folder.path() / "human_bigrams.csv");
  ASSERT_EQ(::mkfifo(folder.at("human_bigrams.csv").c_str(), 0600), 0);
  const auto fifo = read_human_goals(folder.path());
  ASSERT_FALSE(fifo) << "it must not wait for a writer";
  EXPECT_EQ(fifo.error().message, "is a FIFO; expected a file");
}

}  // namespace
}  // namespace unietp
