#include <array>
#include <map>

#include "authoring/coverage.h"
#include "authoring/expert_success.h"
#include "core/text.h"

namespace unietp {
namespace {

std::string row_of(const std::vector<std::string>& fields) { return "| " + join(fields, " | ") + " |\n"; }

std::string head_of(std::vector<std::string> first, std::vector<std::string> last) {
  for (const auto simulator : kSimulators) first.emplace_back(name_of(simulator));
  first.insert(first.end(), last.begin(), last.end());
  std::string rule = "|";
  for (std::size_t i = 0; i < first.size(); ++i) rule += "---|";
  return row_of(first) + rule + "\n";
}

std::string table_of(const std::vector<CoverageRow>& rows) {
  std::string text = head_of({"template", "class"}, {"predicates of the goal"});
  for (const auto& row : rows) {
    std::vector<std::string> fields{row.name, std::string(name_of(row.split))};
    for (const auto& cell : row.cells) fields.push_back(to_text(cell));
    fields.push_back(join(row.predicates, " "));
    text += row_of(fields);
  }
  return text;
}

std::string reasons_of(const std::vector<CoverageRow>& rows) {
  std::string text;
  for (const auto& [row, simulator] : empty_cells(rows)) {
    text += "- `" + rows[row].name + "` on " + std::string(name_of(kSimulators[simulator])) + ":";
    for (const auto& why : rows[row].cells[simulator].reasons)
      text +=
          " " + why.stage + " " + why.reason + " (" + std::to_string(why.count) + "), such as: " + why.example + ";";
    text.back() = '.';
    text += "\n";
  }
  return text;
}

std::string predicates_of(const std::vector<CoverageRow>& rows) {
  std::string text = head_of({"predicate"}, {});
  for (const auto& use : predicate_uses(rows)) {
    std::vector<std::string> fields{"`" + use.predicate + "`"};
    for (const int count : use.templates) fields.push_back(count == 0 ? "" : std::to_string(count));
    text += row_of(fields);
  }
  return text;
}

/// What passed no gate, by reason: gates on symbols (generator) and on geometry (grounding).
std::string gates_of(const std::vector<CoverageRow>& rows) {
  std::map<std::pair<std::string, std::string>, std::array<int, kSimulators.size()>> refused;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < kSimulators.size(); ++i) {
      for (const auto& why : row.cells[i].reasons) {
        if (why.stage == "generator" || why.stage == "grounding") refused[{why.stage, why.reason}][i] += why.count;
      }
    }
  }
  std::string text = head_of({"stage", "gate"}, {});
  for (const auto& [gate, counts] : refused) {
    std::vector<std::string> fields{gate.first, "`" + gate.second + "`"};
    for (const int count : counts) fields.push_back(count == 0 ? "" : std::to_string(count));
    text += row_of(fields);
  }
  return text;
}

}  // namespace

std::string coverage_page(const std::vector<CoverageRow>& rows, const std::vector<Mode>& modes, int tries,
                          std::uint64_t seed) {
  const auto claimed = claimed_cells(rows).size(), empty = empty_cells(rows).size();
  std::vector<std::string> shown_in;
  for (const Mode mode : modes) shown_in.emplace_back(name_of(mode));
  std::string text = "# What the templates cover\n\n";
  if (tries == 0) {
    text += "Made by `unietp template coverage --markdown`: which templates claim which simulators.\n\n";
  } else {
    text += "Made by `unietp template coverage --tries " + std::to_string(tries) + " --seed " + std::to_string(seed) +
            " --modes " + join(shown_in, ",") +
            " --markdown`: of so many\ncandidates of each template on each simulator that it claims, how many became "
            "proven tasks. The same command gives the same page. " +
            std::to_string(claimed - empty) + " of " + std::to_string(claimed) + " cells have at least one.\n\n";
  }
  text += table_of(rows);
  if (tries > 0 && empty > 0) text += "\n## Cells without a task\n\n" + reasons_of(rows);
  if (tries > 0) {
    text +=
        "\n## The expert\n\nOf the candidates that passed the geometric gates (the start was built, rests and meets "
        "its "
        "constraints), those that\nthe expert showed: its plan was executed, makes the goal true, and no step of it "
        "can be "
        "left out.\n\n" +
        expert_success_tables(rows) +
        "\n## The gates\n\nHow many candidates each gate refused, by simulator; [the gates](gate.md) says what each "
        "asks.\n\n" +
        gates_of(rows);
  }
  return text + "\n## Predicates\n\nHow many templates use each predicate in their goal, by simulator.\n\n" +
         predicates_of(rows);
}

}  // namespace unietp
