#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"
#include "logic/formula.h"
#include "report/data_set.h"

namespace unietp {

/// An instruction with the group of splits that it counts in.
struct CountedText {
  std::string split;
  std::string text;
  bool by_author = false;   // in a phrasing of its template's own
  int parts = 1;            // of its goal (formula_census.h)
  bool like_human = false;  // its goal is of a kind that the human goals are of
};

/// How often each pair of neighboring words occurs within texts; words are lower case, without punctuation.
using Bigrams = std::map<std::pair<std::string, std::string>, int>;

/// How texts ask for things.
struct WordFigures {
  int texts = 0;
  std::map<std::string, double> mean_words;  // by group: "all", "atomic and compositional", "other splits"
  double at_most_10_words = 0;               // shares of the texts, 0 to 1
  double ten_openings = 0;                   // that begin with one of the ten commonest sequences of three words
  double frames = 0;                         // "make sure that", "I want you to": about the request itself
  double polite = 0;                         // "please", "could you"
  double by_author = 0;                      // in phrasings of their templates' own
  double words_for_each_part = 0;            // all words by all parts of the goals
  double over_9_for_each_part = 0;           // texts that have more than nine words for each part of their goal
  Bigrams bigrams;
  int texts_like_human = 0;  // whose goals are of kinds that the human goals are of
  Bigrams like_human;        // of those
};

/// Whether ALFRED has goals of this kind, other things aside: in AI2-THOR, one thing or two are to be on or in another
/// in the end, some of them washed, heated, chilled or sliced, and nothing is described by where or how it is.
bool is_like_human_goals(std::string_view simulator, const Formula& goal);

/// The instructions of a data set, one task after another. Errors: Io, Parse, Schema.
Result<std::vector<CountedText>> counted_texts(const FinishedSet& set);

/// Deterministic. Texts without words count nowhere.
WordFigures word_figures(const std::vector<CountedText>& texts);

/// What is stored of the goals that people wrote for ALFRED: figures, and how often each pair of words occurs. Pairs
/// that occur once are only counted, so no sentence can be made again.
struct HumanGoals {
  std::map<std::string, double> figures;  // by name: "mean_words", "at_most_10_words", …
  Bigrams bigrams;
  int single_bigrams = 0;  // pairs that occur once
};
/// Reads `data/english/human_goals.csv` and `human_bigrams.csv` of a folder. Errors: Io, Parse with file and line.
Result<HumanGoals> read_human_goals(const std::filesystem::path& folder);

/// Jensen–Shannon divergence of two distributions of pairs, in bits: 0 for the same, 1 for nothing in common. As many
/// pairs of the human goals as `ours` has are drawn, by `seed`.
double distance_to_human(const Bigrams& ours, const HumanGoals& human, std::uint64_t seed = 1);
/// The same between two samples of the human goals, of `pairs` each: what chance alone gives.
double distance_within_human(int pairs, const HumanGoals& human, std::uint64_t seed = 1);

/// A table of these figures of several data sets beside the human ones, for people. The last line says what prints the
/// same of parts of speech, for which a tagger is needed.
std::string word_table(const std::vector<std::pair<std::string, WordFigures>>& sets, const HumanGoals& human);

}  // namespace unietp
