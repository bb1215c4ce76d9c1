#include "sense/evidence.h"

#include <cmath>

#include "akb/row_reader.h"
#include "core/text.h"
#include "sense/word_kinds.h"

namespace unietp {
namespace {

constexpr std::array<std::string_view, 3> kGradeNames{"senseless", "tolerable", "usual"};
constexpr std::string_view kMaterial = "material:", kWords = "words:";

std::string kind_in(RowReader& row, std::string_view column, const Kinds& kinds) {
  auto kind = row.required(column);
  if (kinds.find(kind) == nullptr) row.fail(column, "'" + kind + "' is not a kind of kinds.csv");
  return kind;
}

double rounded(double weight) { return std::round(weight * 1000) / 1000; }

}  // namespace

std::string_view name_of(Grade grade) { return kGradeNames[static_cast<std::size_t>(grade)]; }

std::optional<Grade> grade_named(std::string_view name) {
  for (const auto grade : kGrades) {
    if (name == name_of(grade)) return grade;
  }
  return std::nullopt;
}

std::string family_of(std::string_view role) {
  if (const auto then = role.find('>'); then != std::string_view::npos) return std::string(role.substr(0, then + 1));
  const auto mark = role.find(':');
  if (mark == std::string_view::npos) return "do";
  const auto word = role.substr(0, mark);
  return word == "on" || word == "in" ? "place" : std::string(word);
}

std::vector<Evidence> read_evidence(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors) {
  std::vector<Evidence> all;
  each_row(path, {"thing", "role", "weight", "example", "source"}, errors, [&](RowReader& row) {
    all.push_back({kind_in(row, "thing", kinds), row.required("role"), row.number("weight", 0, 1e9, false),
                   row.text("example"), row.required("source")});
  });
  return all;
}

std::string csv_of(const std::vector<Evidence>& evidence) {
  std::string text = csv_line({"thing", "role", "weight", "example", "source"});
  for (const auto& row : evidence)
    text += csv_line({row.thing, row.role, number_text(rounded(row.weight)), row.example, row.source});
  return text;
}

Judgments read_judgments(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors) {
  Judgments all;
  const std::vector<std::string> grades(kGradeNames.begin(), kGradeNames.end());
  each_row(path, {"thing", "role", "grade", "source"}, errors, [&](RowReader& row) {
    auto thing = kind_in(row, "thing", kinds);
    auto role = row.required("role");
    const auto grade = row.value_of("grade", grades, "grade", grade_named);
    if (!all.emplace(std::pair(thing, role), grade).second) row.fail("role", "'" + role + "' of it stands twice");
  });
  return all;
}

std::vector<SenseRule> read_sense_rules(const std::filesystem::path& path, const Kinds& kinds,
                                        std::vector<Error>& errors) {
  std::vector<SenseRule> all;
  each_row(path, {"name", "form", "thing", "except", "other", "reason", "source"}, errors, [&](RowReader& row) {
    const auto name = row.required("name"), form = row.one_of("form", {"role", "together", "stored"}, "form");
    SenseRule rule{name,
                   form == "together",
                   row.required("thing"),
                   row.list("except"),
                   row.required("other"),
                   row.required("reason")};
    rule.stored = form == "stored";
    (void)row.required("source");
    if (rule.thing.starts_with(kWords)) {
      for (const auto& word : split(rule.thing.substr(kWords.size()), '|')) {
        if (word != normal_word(word)) row.fail("thing", "'" + word + "' is no name; expected one such as 'paper_bag'");
        rule.words.insert(word);
      }
    } else if (!rule.thing.starts_with(kMaterial)) {
      kind_in(row, "thing", kinds);
    }
    if (rule.together || rule.stored) kind_in(row, "other", kinds);
    for (const auto& kind : rule.except) {
      if (kinds.find(kind) == nullptr) row.fail("except", "'" + kind + "' is not a kind of kinds.csv");
    }
    all.push_back(std::move(rule));
  });
  return all;
}

}  // namespace unietp
