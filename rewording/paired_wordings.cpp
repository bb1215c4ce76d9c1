#include "rewording/paired_wordings.h"

#include <array>

#include <nlohmann/json.hpp>

#include "annotator/home_facts.h"
#include "core/files.h"
#include "core/text.h"
#include "dataset/candidate_number.h"
#include "dataset/instruction_json.h"
#include "record/task_record.h"
#include "rewording/referring_goal.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::array kComplex{Style::NestedSyntax, Style::Condition, Style::RelativeClause, Style::InvertedOrder,
                              Style::Background};

class PairWriter {
 public:
  PairWriter(const TaskLine& task, Scene start, const DemonstrationRecord& demonstration, const Backend& backend,
             Phrasings phrasings, std::optional<std::uint64_t> seed)
      : task_(task),
        start_(std::move(start)),
        backend_(backend),
        writing_{phrasings, categories_in(start_)},
        rng_(wording_stream(seed.value_or(task.seed), task.slot, task.attempt).fork("pair", 0)) {
    std::vector<Delta> changes;
    for (const StepRecord& step : demonstration.steps) changes.push_back(step.changes);
    trace_ = to_logic(start_, changes, reads_comparisons(task.specification.goal));
  }

  Result<Json> pair() const {
    Json json{{"format", "unietp-wordings/1"}, {"task", task_.id}, {"pair", task_.id}};
    const auto direct = worded(task_.specification.goal, Style::Direct);
    if (!direct) return direct.error();
    json["direct"] = instruction_to_json(*direct);
    if (const auto goal = referring_goal(task_.specification.goal, start_, trace_, rng_.fork("referring", 0))) {
      if (const auto referring = worded(*goal, Style::Direct)) {
        json["referring"] = instruction_to_json(*referring);
        json["referring"]["goal"] = to_text(*goal);
      }
    }
    for (const Style style : kComplex) {
      const auto complex = worded(task_.specification.goal, style);
      if (!complex || complex->style != style) continue;
      json["complex"] = instruction_to_json(*complex);
      break;
    }
    return json;
  }

 private:
  Result<Instruction> worded(const Formula& goal, Style style) const {
    Specification specification = task_.specification;
    specification.goal = goal;
    specification.style = style;
    return write_instruction(specification, backend_.knowledge, backend_.nouns, writing_, rng_.fork(name_of(style), 0));
  }

  const TaskLine& task_;
  Scene start_;
  const Backend& backend_;
  WritingOptions writing_;
  Rng rng_;
  Trace trace_;
};

}  // namespace

Result<std::string> paired_wordings(const fs::path& folder, const std::vector<TaskLine>& lines,
                                    const Resources& resources, Phrasings phrasings,
                                    std::optional<std::uint64_t> seed) {
  const auto file = folder / "demonstrations" / "M1.jsonl";
  const auto text = read_file(file);
  if (!text) return text.error();
  const auto demonstrations = split(*text, '\n');
  HomeShelf homes(folder);
  std::string all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i >= demonstrations.size())
      return Error{Error::Kind::Schema, file.string(), {}, "has no demonstration of " + lines[i].id};
    const auto demonstration = read_demonstration(file.string(), static_cast<int>(i) + 1, demonstrations[i]);
    if (!demonstration) return demonstration.error();
    auto start = read_start(homes, lines[i]);
    if (!start) return start.error();
    const Backend& backend = resources.backend(lines[i].specification.simulator);
    const auto pair = PairWriter(lines[i], std::move(*start), *demonstration, backend, phrasings, seed).pair();
    if (!pair) return pair.error();
    all += pair->dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  }
  return all;
}

}  // namespace unietp
