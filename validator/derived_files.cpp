#include "validator/derived_files.h"

#include <algorithm>
#include <cctype>

#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

constexpr const char* kCardFile = "README.md";

bool is_prose(std::string_view line) {
  return !line.empty() && (std::isalpha(static_cast<unsigned char>(line.front())) != 0 || line.front() == '`');
}

/// Lines with facts, each with its number.
struct FactLine {
  int line = 0;
  std::string facts;
};

std::vector<FactLine> facts_of_card(const std::string& card) {
  std::vector<FactLine> all;
  int number = 0;
  bool metadata = false;
  for (const auto& line : split(card, '\n')) {
    ++number;
    if (line == "---") metadata = number == 1;
    auto facts = metadata ? line : facts_of_line(line);
    if (!facts.empty()) all.push_back({number, std::move(facts)});
  }
  return all;
}

std::vector<Problem> compare_cards(const std::string& there, const std::string& wanted) {
  std::vector<Problem> problems;
  const auto found = [&](int line, std::string message) {
    problems.push_back({ProblemKind::Card, "", {Error::Kind::Schema, kCardFile, {line, 1}, std::move(message)}});
  };
  const auto own = facts_of_card(there), expected = facts_of_card(wanted);
  for (std::size_t i = 0; i < std::min(own.size(), expected.size()); ++i) {
    if (own[i].facts != expected[i].facts) {
      found(own[i].line, "says \"" + own[i].facts + "\", expected \"" + expected[i].facts + "\"");
      return problems;  // those behind it may be shifted
    }
  }
  if (own.size() > expected.size())
    found(own[expected.size()].line, "says \"" + own[expected.size()].facts + "\", expected nothing");
  if (own.size() < expected.size()) found(0, "lacks \"" + expected[own.size()].facts + "\"");
  return problems;
}

std::string source_text(const RecordedSource& source) {
  return source.source + " from " + source.origin + ", " + source.license;
}

std::vector<Problem> compare_sources(const std::vector<RecordedSource>& there,
                                     const std::vector<RecordedSource>& wanted) {
  std::vector<Problem> problems;
  for (std::size_t i = 0; i < std::max(there.size(), wanted.size()); ++i) {
    const std::string own = i < there.size() ? source_text(there[i]) : "nothing";
    const std::string expected = i < wanted.size() ? source_text(wanted[i]) : "nothing";
    if (own == expected) continue;
    problems.push_back(problem_in(ProblemKind::Sources, kManifest,
                                  "has " + own + " as source " + std::to_string(i + 1) + ", expected " + expected));
    break;
  }
  return problems;
}

/// A set that was made before its tasks were frozen has no name, which is no fault.
std::vector<Problem> compare_benchmarks(const std::string& there, const std::string& wanted) {
  if (there.empty() || there == wanted) return {};
  const std::string is = wanted.empty() ? "no frozen benchmark" : "\"" + wanted + "\"";
  return {problem_in(ProblemKind::Benchmark, kManifest,
                     "names the benchmark \"" + there + "\", but by the digest of its tasks and homes it is " + is)};
}

}  // namespace

std::string facts_of_line(std::string_view line) {
  if (!is_prose(line)) return std::string(trim(line));
  std::vector<std::string> facts;
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t begin = i;
    if (line[i] == '`') {
      const auto end = line.find('`', i + 1);
      i = end == std::string_view::npos ? line.size() : end + 1;
      facts.emplace_back(line.substr(begin, i - begin));
    } else if (std::isalnum(static_cast<unsigned char>(line[i])) != 0) {
      while (i < line.size() && std::isalnum(static_cast<unsigned char>(line[i])) != 0) ++i;
      const auto word = line.substr(begin, i - begin);
      if (std::any_of(word.begin(), word.end(), [](unsigned char c) { return std::isdigit(c) != 0; }))
        facts.emplace_back(word);
    } else {
      ++i;
    }
  }
  return join(facts, " ");
}

std::vector<Problem> check_derived_files(const std::filesystem::path& folder, const ManifestRecord& manifest,
                                         const DeriveFiles& derive) {
  if (!derive) return {};
  const auto wanted = derive(manifest);
  if (!wanted) return {{ProblemKind::Manifest, "", wanted.error()}};
  auto problems = compare_sources(manifest.sources, wanted->sources);
  append(problems, compare_benchmarks(manifest.benchmark, wanted->benchmark));
  std::error_code code;
  if (!std::filesystem::exists(folder / kCardFile, code)) return problems;  // the file check reports it
  const auto card = read_file(folder, kCardFile);
  if (!card) {
    problems.push_back({ProblemKind::Unreadable, "", card.error()});
    return problems;
  }
  append(problems, compare_cards(*card, wanted->card));
  return problems;
}

}  // namespace unietp
