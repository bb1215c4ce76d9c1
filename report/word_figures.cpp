#include "report/word_figures.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>

#include "core/files.h"
#include "core/rng.h"
#include "core/text.h"
#include "record/dataset_reader.h"
#include "record/recorded_words.h"
#include "report/formula_census.h"

namespace unietp {
namespace {

using Words = std::vector<std::string>;

constexpr std::array<std::string_view, 22> kFrames{
    "make sure",        "ensure",       "see to it",   "see to the",       "i want you",     "i need you",
    "i would like you", "i'd like you", "you should",  "you need to",      "you have to",    "your task",
    "your job",         "the task is",  "the goal is", "what counts",      "what is wanted", "take care",
    "at the end",       "in the end",   "by the end",  "when you are done"};
constexpr std::array<std::string_view, 8> kPolite{"please",    "kindly",   "could you", "can you",
                                                  "would you", "will you", "thank you", "would you mind"};

Words words_in(std::string_view text) {
  Words words;
  std::string word;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) || c == '\'' || c == '-') {
      word += static_cast<char>(std::tolower(byte));
    } else if (!word.empty()) {
      words.push_back(std::move(word));
      word.clear();
    }
  }
  if (!word.empty()) words.push_back(std::move(word));
  return words;
}

template <class List>
bool has_one_of(const std::string& spaced, const List& phrases) {
  return std::any_of(phrases.begin(), phrases.end(), [&](std::string_view phrase) {
    return spaced.find(" " + std::string(phrase) + " ") != std::string::npos;
  });
}

double share(int part, int of) { return of == 0 ? 0 : static_cast<double>(part) / of; }

Error fault(const std::filesystem::path& file, int line, const std::string& what) {
  return {Error::Kind::Parse, file.string(), {line, 1}, what};
}

/// The cells of each line of a table without quotes; comment lines start with '#'.
Result<std::vector<Words>> rows_of(const std::filesystem::path& file, std::size_t columns) {
  const auto text = read_file(file);
  if (!text) return text.error();
  std::vector<Words> rows;
  bool heading = true;
  int number = 0;
  for (const auto& line : split(*text, '\n')) {
    ++number;
    if (line.empty() || line[0] == '#') continue;
    Words cells = split(line, ',');
    if (cells.size() != columns)
      return fault(file, number,
                   "expected " + std::to_string(columns) + " cells, found " + std::to_string(cells.size()));
    if (!heading) rows.push_back(std::move(cells));
    heading = false;
  }
  return rows;
}

/// Draws `pairs` pairs, of which those that occur once are all different.
Bigrams drawn(int pairs, const HumanGoals& human, Rng rng) {
  std::vector<std::pair<std::uint64_t, const std::pair<std::string, std::string>*>> ends;
  std::uint64_t total = 0;
  for (const auto& [pair, count] : human.bigrams) {
    total += static_cast<std::uint64_t>(count);
    ends.emplace_back(total, &pair);
  }
  const std::uint64_t all = total + static_cast<std::uint64_t>(human.single_bigrams);
  Bigrams sample;
  for (int i = 0; i < pairs && all > 0; ++i) {
    const std::uint64_t at = rng.below(all);
    if (at >= total) {
      ++sample[{"", std::to_string(at)}];
      continue;
    }
    const auto found = std::upper_bound(ends.begin(), ends.end(), at,
                                        [](std::uint64_t value, const auto& end) { return value < end.first; });
    ++sample[*found->second];
  }
  return sample;
}

double total_of(const Bigrams& counts) {
  double total = 0;
  for (const auto& [pair, count] : counts) total += count;
  return total;
}

double divergence(const Bigrams& left, const Bigrams& right) {
  const double all_left = total_of(left), all_right = total_of(right);
  if (all_left == 0 || all_right == 0) return 1;
  double sum = 0;
  const auto add = [&](double p, double q) {
    const double middle = (p + q) / 2;
    if (p > 0) sum += p * std::log2(p / middle) / 2;
    if (q > 0) sum += q * std::log2(q / middle) / 2;
  };
  for (const auto& [pair, count] : left) {
    const auto other = right.find(pair);
    add(count / all_left, other == right.end() ? 0 : other->second / all_right);
  }
  for (const auto& [pair, count] : right)
    if (!left.contains(pair)) add(0, count / all_right);
  return sum;
}

}  // namespace

bool is_like_human_goals(std::string_view simulator, const Formula& goal) {
  static const std::set<std::string> kOperators{"exists", "count", "and", "at-end"};
  static const std::set<std::string> kPredicates{"on", "inside", "clean", "hot", "cool", "sliced", "slice_of"};
  const FormulaCensus census = census_of(goal);
  const auto within = [](const std::set<std::string>& some, const std::set<std::string>& all) {
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
  };
  return simulator == "ai2thor" && within(census.operators, kOperators) && within(census.predicates, kPredicates) &&
         (census.predicates.contains("on") || census.predicates.contains("inside"));
}

Result<std::vector<CountedText>> counted_texts(const FinishedSet& set) {
  auto reader = DatasetReader::open(set.folder, {.modes = set.modes});
  if (!reader) return reader.error();
  std::vector<CountedText> texts;
  const auto done = for_each_task<CountedText>(
      std::move(*reader), 1,
      [](const FinishedTask& task) -> Result<CountedText> {
        const TaskRecord& record = task.record;
        return CountedText{record.split, record.instruction, record.phrasing > 0, parts_of(record.goal_tree),
                           is_like_human_goals(record.simulator, record.goal_tree)};
      },
      [&](CountedText&& text) -> Result<Done> {
        texts.push_back(std::move(text));
        return Done{};
      });
  if (!done) return done.error();
  return texts;
}

WordFigures word_figures(const std::vector<CountedText>& texts) {
  WordFigures figures;
  std::map<std::string, std::pair<double, int>> lengths;
  std::map<std::string, int> openings;
  int brief = 0, framed = 0, polite = 0, by_author = 0, parts = 0, long_for_parts = 0;
  for (const CountedText& counted : texts) {
    const Words words = words_in(counted.text);
    if (words.empty()) continue;
    ++figures.texts;
    const auto split = recorded_split(counted.split);
    const bool short_split = split == RecordedSplit::Atomic || split == RecordedSplit::Compositional;
    for (const char* group : {"all", short_split ? "atomic and compositional" : "other splits"}) {
      lengths[group].first += static_cast<double>(words.size());
      ++lengths[group].second;
    }
    brief += words.size() <= 10 ? 1 : 0;
    const std::string spaced = " " + join(words, " ") + " ";
    framed += has_one_of(spaced, kFrames) ? 1 : 0;
    polite += has_one_of(spaced, kPolite) ? 1 : 0;
    by_author += counted.by_author ? 1 : 0;
    ++openings[join(Words(words.begin(), words.begin() + std::min<std::ptrdiff_t>(3, std::ssize(words))), " ")];
    parts += counted.parts;
    long_for_parts += std::ssize(words) > 9 * counted.parts ? 1 : 0;
    figures.texts_like_human += counted.like_human ? 1 : 0;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
      ++figures.bigrams[{words[i], words[i + 1]}];
      if (counted.like_human) ++figures.like_human[{words[i], words[i + 1]}];
    }
  }
  if (parts > 0) figures.words_for_each_part = lengths["all"].first / parts;
  figures.over_9_for_each_part = share(long_for_parts, figures.texts);
  for (const auto& [group, sum] : lengths) figures.mean_words[group] = sum.first / sum.second;
  std::vector<int> commonest;
  for (const auto& [opening, count] : openings) commonest.push_back(count);
  std::sort(commonest.rbegin(), commonest.rend());
  commonest.resize(std::min<std::size_t>(10, commonest.size()));
  int open = 0;
  for (const int count : commonest) open += count;
  figures.at_most_10_words = share(brief, figures.texts);
  figures.ten_openings = share(open, figures.texts);
  figures.frames = share(framed, figures.texts);
  figures.polite = share(polite, figures.texts);
  figures.by_author = share(by_author, figures.texts);
  return figures;
}

Result<HumanGoals> read_human_goals(const std::filesystem::path& folder) {
  HumanGoals goals;
  const auto figures = rows_of(folder / "human_goals.csv", 2);
  if (!figures) return figures.error();
  for (const Words& row : *figures) {
    double value = 0;
    const auto [end, wrong] = std::from_chars(row[1].data(), row[1].data() + row[1].size(), value);
    if (wrong != std::errc() || end != row[1].data() + row[1].size())
      return fault(folder / "human_goals.csv", 1, "the figure '" + row[0] + "' is no number");
    goals.figures[row[0]] = value;
  }
  const auto pairs = rows_of(folder / "human_bigrams.csv", 3);
  if (!pairs) return pairs.error();
  for (const Words& row : *pairs) {
    int count = 0;
    const auto [end, wrong] = std::from_chars(row[2].data(), row[2].data() + row[2].size(), count);
    if (wrong != std::errc() || count < 2)
      return fault(folder / "human_bigrams.csv", 1,
                   "the count of '" + row[0] + " " + row[1] + "' is no number from 2 on");
    goals.bigrams[{row[0], row[1]}] = count;
  }
  goals.single_bigrams = static_cast<int>(goals.figures["pairs_that_occur_once"]);
  return goals;
}

double distance_to_human(const Bigrams& ours, const HumanGoals& human, std::uint64_t seed) {
  return divergence(ours, drawn(static_cast<int>(total_of(ours)), human, Rng(seed).fork("sample", 0)));
}

double distance_within_human(int pairs, const HumanGoals& human, std::uint64_t seed) {
  return divergence(drawn(pairs, human, Rng(seed).fork("sample", 0)), drawn(pairs, human, Rng(seed).fork("sample", 1)));
}

std::string word_table(const std::vector<std::pair<std::string, WordFigures>>& sets, const HumanGoals& human) {
  constexpr int kLabel = 40, kCell = 14;
  std::ostringstream out;
  const auto cell = [&](const std::string& text) {
    out << std::string(static_cast<std::size_t>(std::max(1, kCell - static_cast<int>(text.size()))), ' ') << text;
  };
  const auto row = [&](std::string label, const auto& figure, const std::string& of_people) {
    label.resize(kLabel, ' ');
    out << label;
    for (const auto& [name, figures] : sets) cell(figure(figures));
    cell(of_people);
    out << '\n';
  };
  const auto decimal = [](double value, int places) {
    std::ostringstream text;
    text.setf(std::ios::fixed);
    text.precision(places);
    text << value;
    return text.str();
  };
  const auto percent = [&](double value) { return decimal(100 * value, 1) + " %"; };
  const auto of_people = [&](const std::string& name) {
    const auto found = human.figures.find(name);
    return found == human.figures.end() ? 0.0 : found->second;
  };
  out << std::string(kLabel, ' ');
  for (const auto& [name, figures] : sets) cell(name.substr(0, kCell - 1));
  cell("people");
  out << '\n';
  row(
      "texts", [](const WordFigures& f) { return std::to_string(f.texts); }, decimal(of_people("texts"), 0));
  for (const char* group : {"all", "atomic and compositional", "other splits"})
    row(
        "mean words, " + std::string(group),
        [&](const WordFigures& f) { return f.mean_words.contains(group) ? decimal(f.mean_words.at(group), 1) : "-"; },
        std::string_view(group) == "all" ? decimal(of_people("mean_words"), 1) : "");
  row(
      "at most 10 words", [&](const WordFigures& f) { return percent(f.at_most_10_words); },
      percent(of_people("at_most_10_words")));
  row(
      "ten commonest three-word openings", [&](const WordFigures& f) { return percent(f.ten_openings); },
      percent(of_people("ten_openings")));
  row(
      "frames about the request", [&](const WordFigures& f) { return percent(f.frames); },
      percent(of_people("frames")));
  row(
      "polite", [&](const WordFigures& f) { return percent(f.polite); }, percent(of_people("polite")));
  row(
      "in phrasings of template authors", [&](const WordFigures& f) { return percent(f.by_author); }, "");
  row(
      "words for each part of the goal", [&](const WordFigures& f) { return decimal(f.words_for_each_part, 1); }, "");
  row(
      "more than 9 words for each part", [&](const WordFigures& f) { return percent(f.over_9_for_each_part); }, "");
  const int pairs = sets.empty() ? 0 : static_cast<int>(total_of(sets.front().second.bigrams));
  row(
      "divergence of word pairs (bits)",
      [&](const WordFigures& f) { return decimal(distance_to_human(f.bigrams, human), 3); },
      decimal(distance_within_human(pairs, human), 3));
  const int alike = sets.empty() ? 0 : static_cast<int>(total_of(sets.front().second.like_human));
  row(
      "texts of goals of people's kinds", [](const WordFigures& f) { return std::to_string(f.texts_like_human); }, "");
  row(
      "divergence of word pairs, these alone",
      [&](const WordFigures& f) {
        return f.like_human.empty() ? "-" : decimal(distance_to_human(f.like_human, human), 3);
      },
      alike == 0 ? "" : decimal(distance_within_human(alike, human), 3));
  out << "parts of speech: ./check tags FOLDER GOALS.jsonl.gz, with a tagger of npm\n";
  return out.str();
}

}  // namespace unietp
