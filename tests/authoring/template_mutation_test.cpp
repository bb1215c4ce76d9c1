#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "authoring/lint_template.h"
#include "core/sexpr.h"
#include "core/text.h"
#include "mutations.h"
#include "templates/sections.h"
#include "templates/template_files.h"
#include "templates/template_text.h"

namespace unietp {
namespace {

constexpr int kMutants = 10000;
constexpr int kDeepEvery = 25;  // of the accepted, how many are also looked at on all simulators

const std::vector<TemplateFile>& library_files() {
  static const auto kFiles =
      template_files(std::filesystem::path(UNIETP_SOURCE_DIR) / "templates" / "library", "library").files;
  return kFiles;
}

const std::vector<Backend>& backends() {
  static const auto kReading =
      load_backends({UNIETP_SOURCE_DIR, std::filesystem::path(::testing::TempDir()) / "unietp-resources-cache"});
  return kReading.backends;
}

std::string bare(const Sexpr& expression) {
  if (expression.is_atom()) return expression.text;
  if (!expression.is_list()) return quoted_string(expression.text);
  std::string text = "(";
  for (const auto& child : expression.children) text += (text.size() == 1 ? "" : " ") + bare(child);
  return text + ")";
}

/// `(count > (?x - A) f (number …))` with its first `number` written out.
Sexpr long_form(Sexpr expression) {
  for (auto& child : expression.children) child = long_form(std::move(child));
  auto& parts = expression.children;
  if (!expression.is_form("count") || parts.size() != 5 || !parts[2].is_list()) return expression;
  Sexpr word;
  word.text = "number";
  Sexpr number;
  number.kind = Sexpr::Kind::List;
  number.children = {std::move(word), std::move(parts[2]), std::move(parts[3])};
  parts = {std::move(parts[0]), std::move(parts[1]), std::move(number), std::move(parts[4])};
  return expression;
}

/// Every word and bracket of a file, free of layout, comments and the order of its sections, and with what may be left
/// out: two files of one such text say the same, and none says more than the other.
std::string words_of_file(std::string_view text) {
  const auto read = read_sexpr("", text);
  if (!read) return "unreadable";
  const auto file = long_form(*read);
  std::vector<std::string> sections;
  for (const auto& section : template_sections()) {
    std::string words =
        section.type == SectionType::Simulators ? "(simulators ai2thor virtualhome habitat behavior)" : "";
    for (std::size_t i = 2; i < file.children.size(); ++i) {
      if (file.children[i].is_form(section.name)) words = bare(file.children[i]);
    }
    if (words == "(constraints)" || words == "(init)") words.clear();  // nothing is said by an empty one
    sections.push_back(std::move(words));
  }
  return file.children[1].text + join(sections, "\n");
}

struct Tally {
  int accepted = 0, same = 0, refused = 0;
};

/// What is wrong with how the reader took a mutant; "" when nothing is.
std::string silent_change(const TemplateFile& original, const std::string& mutant, Tally& tally) {
  const auto before = parse_template(original.path, original.text).templates.at(0);
  const auto reading = parse_template(original.path, mutant);
  if (reading.templates.empty() == reading.errors.empty()) return "neither accepted nor refused";
  for (const auto& error : reading.errors) {
    if (error.pos.line < 1 || error.pos.column < 1 || error.message.empty()) return "an error without a place";
  }
  if (reading.templates.empty()) {
    ++tally.refused;
    return "";
  }
  ++tally.accepted;
  const auto& after = reading.templates.front();
  const auto printed = to_text(after);
  const auto again = parse_template(original.path, printed);
  if (again.templates.empty()) return "what it was read as is refused: " + format(again.errors.front());
  if (!same_content(again.templates.front(), after)) return "what it was read as is read as something else";
  if (words_of_file(mutant) != words_of_file(printed)) return "words of the file do not reach what it was read as";
  const bool same = same_content(before, after);
  if (same != (printed == to_text(before))) return "the printed text hides a difference";
  if (same != (words_of_file(mutant) == words_of_file(original.text))) return "a change of words changes nothing";
  tally.same += same ? 1 : 0;
  return "";
}

TEST(TemplateMutations, NoneOfTenThousandIsAcceptedWithAMeaningThatChangedSilently) {
  ASSERT_GE(library_files().size(), 50U);
  std::set<std::string> all;
  for (const auto& file : library_files()) {
    const auto words = testing_support::words_in(file.text);
    ASSERT_FALSE(words.empty()) << file.path;
    all.insert(words.begin(), words.end());
  }
  const std::vector<std::string> words(all.begin(), all.end());
  ASSERT_EQ(backends().size(), 4U);
  Tally tally;
  for (int i = 0; i < kMutants; ++i) {
    Rng rng = Rng(7).fork("mutant", static_cast<std::uint64_t>(i));
    const auto& original = rng.pick(library_files());
    const auto mutant = testing_support::mutated(original.text, words, rng);
    const int accepted = tally.accepted;
    const auto wrong = silent_change(original, mutant, tally);
    ASSERT_EQ(wrong, "") << "mutant " << i << "\n" << mutant;
    if (tally.accepted == accepted || tally.accepted % kDeepEvery != 0) continue;
    const auto linted = lint_template(original.path, mutant, backends());
    for (const auto& problem : linted.problems) {
      EXPECT_FALSE(problem_text(problem, mutant, true).empty()) << "mutant " << i;
    }
  }
  // Both ways are taken often enough to mean something.
  EXPECT_GT(tally.refused, kMutants / 2);
  EXPECT_GT(tally.accepted - tally.same, kMutants / 50);
  EXPECT_GT(tally.same, kMutants / 100);
  std::printf("%d refused, %d accepted, %d of them equal to the original\n", tally.refused, tally.accepted, tally.same);
}

TEST(TemplateText, EveryTemplateOfTheLibraryIsReadBackFromIt) {
  for (const auto& file : library_files()) {
    Tally tally;
    EXPECT_EQ(silent_change(file, file.text, tally), "") << file.path;
    EXPECT_EQ(tally.same, 1) << file.path;
  }
}

}  // namespace
}  // namespace unietp
