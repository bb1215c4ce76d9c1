#include "validator/field_rules.h"

#include <algorithm>
#include <array>

namespace unietp {
namespace {

using Rule = FieldRule;

constexpr std::array<std::string_view, 6> kRuleNames{"fixed", "recomputed", "compared", "physical", "setting", "free"};

constexpr std::string_view kReplayed = "equals what the replay gives";
constexpr std::string_view kStart = "made again from goal, start constraints, home and seed; physics accepts it";
constexpr std::string_view kDelta = "in a step: equals what the replay gives; in a start: made again";
constexpr std::string_view kCounted = "counted again";
constexpr std::string_view kShortest = "done by one who is told everything: reaches the goal, and needs each step";
constexpr std::string_view kTempting = "done in the start: reaches the goal but for its constraints, needs each step";
constexpr std::string_view kLedger = "equals the row of the table rejection";
constexpr std::string_view kSettled = "physics rebuilds the scene: same relations, everything at rest";
constexpr std::string_view kReadBack = "read back: means the goal, has the style, is of the set of phrasings";
constexpr std::string_view kPerson = "a person's judgment";
constexpr std::string_view kFormat = "the name of the format";
constexpr std::string_view kGraded = "graded again from the goal and the tables of sense";
constexpr std::string_view kPurpose = "from template and bindings";
constexpr std::string_view kPlanned = "how the tasks were planned; homes, ids, candidates and counts must fit it";

constexpr std::array kFieldRules{
    FieldInfo{"task", "format", Rule::Fixed, kFormat},
    FieldInfo{"task", "id", Rule::Recomputed, "from simulator and slot"},
    FieldInfo{"task", "template", Rule::Compared, "the template gives goal and start constraints; counts and database"},
    FieldInfo{"task", "split", Rule::Compared, "that of the template or of the refinement; counts and database"},
    FieldInfo{"task", "simulator", Rule::Compared, "that of the home; counts and database"},
    FieldInfo{"task", "scene", Rule::Recomputed, "the task's id"},
    FieldInfo{"task", "layout", Rule::Compared, "a home of that name; database"},
    FieldInfo{"task", "bindings", Rule::Compared, "the template gives the goal with them; database"},
    FieldInfo{"task", "refinement", Rule::Compared, "the form of the goal's referring phrase"},
    FieldInfo{"task", "phenomena", Rule::Recomputed, "from the text; that of the style among them"},
    FieldInfo{"task", "goal.text", Rule::Recomputed,
              "from template and bindings, but for a refinement and rooms of places; equals the tree"},
    FieldInfo{"task", "goal.tree.*", Rule::Recomputed, "from the text"},
    FieldInfo{"task", "start.constraints", Rule::Recomputed,
              "from template and bindings, but for a refinement and rooms of places; hold"},
    FieldInfo{"task", "start.edits", Rule::Recomputed, kStart},
    FieldInfo{"task", "start.changes", Rule::Recomputed, kStart},
    FieldInfo{"task", "instruction.text", Rule::Recomputed, kReadBack},
    FieldInfo{"task", "instruction.writer", Rule::Compared, "its checks; counts and database"},
    FieldInfo{"task", "instruction.style", Rule::Compared,
              "that of the template or of the refinement; the text has it"},
    FieldInfo{"task", "instruction.checks", Rule::Recomputed, "from the writer"},
    FieldInfo{"task", "instruction.why", Rule::Free,
              "there exactly where the grammar stands in for a model; its words"},
    FieldInfo{"task", "instruction.phrasing", Rule::Compared, "its template has it; the text has its words, in order"},
    FieldInfo{"task", "purpose.name", Rule::Recomputed, kPurpose},
    FieldInfo{"task", "purpose.because", Rule::Recomputed, kPurpose},
    FieldInfo{"task", "sense.grade", Rule::Recomputed, kGraded},
    FieldInfo{"task", "sense.parts[].part", Rule::Recomputed, kGraded},
    FieldInfo{"task", "sense.parts[].grade", Rule::Recomputed, kGraded},
    FieldInfo{"task", "sense.parts[].why", Rule::Recomputed, kGraded},
    FieldInfo{"task", "expert.M1.steps", Rule::Recomputed, kCounted},
    FieldInfo{"task", "expert.M1.failures", Rule::Recomputed, kCounted},
    FieldInfo{"task", "expert.M2.steps", Rule::Recomputed, kCounted},
    FieldInfo{"task", "expert.M2.failures", Rule::Recomputed, kCounted},
    FieldInfo{"task", "expert.M2.shortest_steps", Rule::Recomputed, kCounted},
    FieldInfo{"task", "expert.M3.steps", Rule::Recomputed, kCounted},
    FieldInfo{"task", "expert.M3.failures", Rule::Recomputed, kCounted},
    FieldInfo{"task", "expert.M3.shortest_steps", Rule::Recomputed, kCounted},
    FieldInfo{"task", "seed.run", Rule::Recomputed, "the seed of the configuration"},
    FieldInfo{"task", "seed.slot", Rule::Recomputed, "the number in the id"},
    FieldInfo{"task", "seed.attempt", Rule::Recomputed, "the number of rejections of the slot"},
    FieldInfo{"delta", "nodes[]", Rule::Recomputed, kDelta},
    FieldInfo{"delta", "removed", Rule::Recomputed, kDelta},
    FieldInfo{"delta", "edges_added[]", Rule::Recomputed, kDelta},
    FieldInfo{"delta", "edges_removed[]", Rule::Recomputed, kDelta},
    FieldInfo{"delta", "agent", Rule::Recomputed, kDelta},
    FieldInfo{"scene", "format", Rule::Fixed, kFormat},
    FieldInfo{"scene", "id", Rule::Recomputed, "the name of the file"},
    FieldInfo{"scene", "simulator", Rule::Compared, "that of its tasks"},
    FieldInfo{"scene", "wall_height", Rule::Physical, kSettled},
    FieldInfo{"scene", "wall_thickness", Rule::Physical, kSettled},
    FieldInfo{"scene", "rooms[].id", Rule::Compared, "openings and relations name it"},
    FieldInfo{"scene", "rooms[].type", Rule::Compared, "goals, instructions and traits name it"},
    FieldInfo{"scene", "rooms[].polygon[]", Rule::Physical, kSettled},
    FieldInfo{"scene", "openings[].id", Rule::Physical, kSettled},
    FieldInfo{"scene", "openings[].room_a", Rule::Physical, "lies on that side"},
    FieldInfo{"scene", "openings[].room_b", Rule::Physical, "lies on that side"},
    FieldInfo{"scene", "openings[].from", Rule::Physical, "lies in the wall between its rooms"},
    FieldInfo{"scene", "openings[].to", Rule::Physical, "lies in the wall between its rooms"},
    FieldInfo{"scene", "openings[].height", Rule::Physical, "is not above the wall"},
    FieldInfo{"scene", "agent.position", Rule::Physical, "what the camera sees from it"},
    FieldInfo{"scene", "agent.yaw_rad", Rule::Physical, "what the camera sees from it"},
    FieldInfo{"scene", "agent.pitch_rad", Rule::Physical, "what the camera sees from it"},
    FieldInfo{"scene", "agent.held", Rule::Physical, "relations and actions"},
    FieldInfo{"scene", "nodes[].id", Rule::Compared, "relations, edits and demonstrations name it"},
    FieldInfo{"scene", "nodes[].category", Rule::Physical, "known, with this archetype"},
    FieldInfo{"scene", "nodes[].movable", Rule::Physical, "that of the category"},
    FieldInfo{"scene", "nodes[].archetype", Rule::Physical, "that of the category"},
    FieldInfo{"scene", "nodes[].openable", Rule::Physical, "that of the category"},
    FieldInfo{"scene", "nodes[].size", Rule::Physical, kSettled},
    FieldInfo{"scene", "nodes[].mass", Rule::Physical, "that of the category"},
    FieldInfo{"scene", "nodes[].position", Rule::Physical, kSettled},
    FieldInfo{"scene", "nodes[].rotation", Rule::Physical, kSettled},
    FieldInfo{"scene", "nodes[].opening", Rule::Physical, "agrees with its states"},
    FieldInfo{"scene", "nodes[].boards[].centre", Rule::Physical, kSettled},
    FieldInfo{"scene", "nodes[].boards[].size", Rule::Physical, kSettled},
    FieldInfo{"scene", "nodes[].boards[].joint", Rule::Physical, kSettled},
    FieldInfo{"scene", "nodes[].states[]", Rule::Physical, "those that the category can have"},
    FieldInfo{"scene", "nodes[].colour", Rule::Physical, "one that the category can have"},
    FieldInfo{"scene", "nodes[].material", Rule::Physical, "one that the category can have"},
    FieldInfo{"scene", "nodes[].asset", Rule::Physical, "only of imported homes"},
    FieldInfo{"scene", "nodes[].slice_of", Rule::Physical, "only of slices"},
    FieldInfo{"scene", "nodes[].whole_category", Rule::Physical, "only of slices"},
    FieldInfo{"scene", "edges[].relation", Rule::Recomputed, "by physics"},
    FieldInfo{"scene", "edges[].from", Rule::Recomputed, "by physics"},
    FieldInfo{"scene", "edges[].to", Rule::Recomputed, "by physics"},
    FieldInfo{"demonstration", "format", Rule::Fixed, kFormat},
    FieldInfo{"demonstration", "task", Rule::Recomputed, "the task in the same line of tasks.jsonl"},
    FieldInfo{"demonstration", "mode", Rule::Recomputed, "from the name of the file"},
    FieldInfo{"demonstration", "steps[].action", Rule::Compared,
              "replayed: reaches the goal, no step is needless; database"},
    FieldInfo{"demonstration", "steps[].args[]", Rule::Compared,
              "replayed: reaches the goal, no step is needless; database"},
    FieldInfo{"demonstration", "steps[].success", Rule::Recomputed, kReplayed},
    FieldInfo{"demonstration", "steps[].failure", Rule::Recomputed, kReplayed},
    FieldInfo{"demonstration", "steps[].feedback", Rule::Recomputed, kReplayed},
    FieldInfo{"demonstration", "steps[].search", Rule::Recomputed, "whether one who is told everything needs the step"},
    FieldInfo{"demonstration", "steps[].visible[].id", Rule::Recomputed, kReplayed},
    FieldInfo{"demonstration", "steps[].visible[].box", Rule::Recomputed, kReplayed},
    FieldInfo{"demonstration", "steps[].changes", Rule::Recomputed, kReplayed},
    FieldInfo{"demonstration", "shortest[].action", Rule::Compared, kShortest},
    FieldInfo{"demonstration", "shortest[].args", Rule::Compared, kShortest},
    FieldInfo{"demonstration", "tempting[].action", Rule::Compared, kTempting},
    FieldInfo{"demonstration", "tempting[].args", Rule::Compared, kTempting},
    FieldInfo{"rejection", "format", Rule::Fixed, kFormat},
    FieldInfo{"rejection", "slot", Rule::Recomputed, "from the order of the candidates"},
    FieldInfo{"rejection", "attempt", Rule::Recomputed, "from the order of the candidates"},
    FieldInfo{"rejection", "template", Rule::Compared, kLedger},
    FieldInfo{"rejection", "simulator", Rule::Compared, "that of the slot's task; database"},
    FieldInfo{"rejection", "split", Rule::Compared, "that of the slot's task; database"},
    FieldInfo{"rejection", "stage", Rule::Compared, "counts of the manifest and card; database"},
    FieldInfo{"rejection", "reason", Rule::Compared, "counts of the manifest and card; database"},
    FieldInfo{"rejection", "detail", Rule::Compared, "free text, but it equals the row of the table rejection"},
    FieldInfo{"wordings", "format", Rule::Fixed, kFormat},
    FieldInfo{"wordings", "task", Rule::Recomputed, "the task in the same line of tasks.jsonl"},
    FieldInfo{"wordings", "pair", Rule::Recomputed, "the task's id"},
    FieldInfo{"wordings", "direct.text", Rule::Recomputed, kReadBack},
    FieldInfo{"wordings", "direct.writer", Rule::Fixed, "the grammar"},
    FieldInfo{"wordings", "direct.style", Rule::Fixed, "direct"},
    FieldInfo{"wordings", "direct.checks", Rule::Recomputed, "from the writer"},
    FieldInfo{"wordings", "direct.why", Rule::Fixed, "never there"},
    FieldInfo{"wordings", "referring.text", Rule::Recomputed, kReadBack},
    FieldInfo{"wordings", "referring.writer", Rule::Fixed, "the grammar"},
    FieldInfo{"wordings", "referring.style", Rule::Fixed, "direct"},
    FieldInfo{"wordings", "referring.checks", Rule::Recomputed, "from the writer"},
    FieldInfo{"wordings", "referring.why", Rule::Fixed, "never there"},
    FieldInfo{"wordings", "referring.goal", Rule::Compared,
              "the task's goal with a referring phrase; the demonstration "
              "reaches it, and the text says it"},
    FieldInfo{"wordings", "complex.text", Rule::Recomputed, kReadBack},
    FieldInfo{"wordings", "complex.writer", Rule::Fixed, "the grammar"},
    FieldInfo{"wordings", "complex.style", Rule::Compared, "a complex one that the text has"},
    FieldInfo{"wordings", "complex.checks", Rule::Recomputed, "from the writer"},
    FieldInfo{"wordings", "complex.why", Rule::Fixed, "never there"},
    FieldInfo{"wordings", "contrast.text", Rule::Recomputed,
              "read back: means its goal; one word of direct.text differs"},
    FieldInfo{"wordings", "contrast.writer", Rule::Fixed, "the grammar"},
    FieldInfo{"wordings", "contrast.style", Rule::Fixed, "direct"},
    FieldInfo{"wordings", "contrast.checks", Rule::Recomputed, "from the writer"},
    FieldInfo{"wordings", "contrast.why", Rule::Fixed, "never there"},
    FieldInfo{"wordings", "contrast.goal", Rule::Recomputed, "from the text; the direct text does not mean it"},
    FieldInfo{"review-mark", "format", Rule::Fixed, kFormat},
    FieldInfo{"review-mark", "task", Rule::Compared, "a task or a rejection of a review; in order, each once"},
    FieldInfo{"review-mark", "verdict", Rule::Free, "agrees with tasks and rejections; else a person's judgment"},
    FieldInfo{"review-mark", "before", Rule::Free, "there exactly for an edit; a text that is gone"},
    FieldInfo{"review-mark", "comment", Rule::Free, kPerson},
    FieldInfo{"manifest", "format", Rule::Fixed, kFormat},
    FieldInfo{"manifest", "program.name", Rule::Fixed, "unietp"},
    FieldInfo{"manifest", "program.version", Rule::Compared, "that of the card"},
    FieldInfo{"manifest", "benchmark", Rule::Recomputed,
              "from the digests of tasks and homes, and data/benchmarks.csv"},
    FieldInfo{"manifest", "knowledge_digest", Rule::Recomputed, "from the tables, profiles, recipes and templates"},
    FieldInfo{"manifest", "seed", Rule::Recomputed, "that of the configuration"},
    FieldInfo{"manifest", "configuration", Rule::Setting, "see run"},
    FieldInfo{"manifest", "counts.tasks", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "counts.candidates", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "counts.by_split", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "counts.by_simulator", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "counts.balance[].dimension", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "counts.balance[].values", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "counts.balance[].effective", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "counts.balance[].variation", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "counts.by_template[].template", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "counts.by_template[].tasks", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "counts.by_sense", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "counts.not_usual[].template", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "counts.not_usual[].tasks", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "counts.rejections", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "files[].path", Rule::Recomputed, "the files of the folder, in order"},
    FieldInfo{"manifest", "files[].bytes", Rule::Recomputed, "from the file"},
    FieldInfo{"manifest", "files[].sha256", Rule::Recomputed, "from the file"},
    FieldInfo{"manifest", "instructions.writer", Rule::Setting,
              "a model, where some text is by one or stands in for it"},
    FieldInfo{"manifest", "instructions.seed", Rule::Setting, "of the wording, which may be any that says the goal"},
    FieldInfo{"manifest", "instructions.phrasings", Rule::Compared, "texts by the grammar are of this set"},
    FieldInfo{"manifest", "instructions.english", Rule::Compared, "texts are read with its names first"},
    FieldInfo{"manifest", "instructions.counts[].writer", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "instructions.counts[].tasks", Rule::Recomputed, kCounted},
    FieldInfo{"manifest", "sources[].source", Rule::Recomputed, "from the knowledge tables"},
    FieldInfo{"manifest", "sources[].origin", Rule::Recomputed, "from the table of licenses"},
    FieldInfo{"manifest", "sources[].licence", Rule::Recomputed, "from the table of licenses"},
    FieldInfo{"run", "format", Rule::Fixed, kFormat},
    FieldInfo{"run", "seed", Rule::Compared, "that of every task; card"},
    FieldInfo{"run", "quotas.splits", Rule::Compared, kCounted},
    FieldInfo{"run", "quotas.simulators", Rule::Compared, kCounted},
    FieldInfo{"run", "without", Rule::Setting, "templates that no task has"},
    FieldInfo{"run", "modes", Rule::Recomputed, "those of every task; card"},
    FieldInfo{"run", "sense", Rule::Setting, "tasks make at least so much, but for templates that cannot"},
    FieldInfo{"run", "english", Rule::Setting, "of the instructions, unless they were rewritten"},
    FieldInfo{"run", "phrasings", Rule::Setting, "of the instructions, unless they were rewritten"},
    FieldInfo{"run", "block", Rule::Setting, kPlanned},
    FieldInfo{"run", "homes", Rule::Setting, kPlanned},
    FieldInfo{"run", "count", Rule::Recomputed, kCounted},
    FieldInfo{"run", "simulators", Rule::Compared, "those of the tasks; card"},
    FieldInfo{"run", "splits", Rule::Setting, kPlanned},
    FieldInfo{"run", "templates", Rule::Setting, kPlanned},
    FieldInfo{"run", "extended", Rule::Setting, "the tasks replay with the agents of this library"},
    FieldInfo{"run", "native", Rule::Setting, kPlanned},
    FieldInfo{"run", "own", Rule::Setting, kPlanned},
    FieldInfo{"run", "binding", Rule::Compared, "every task has it"},
    FieldInfo{"run", "attempts", Rule::Setting, kPlanned},
    FieldInfo{"run", "rooms", Rule::Setting, kPlanned},
    FieldInfo{"run", "objects", Rule::Setting, kPlanned},
    FieldInfo{"run", "scenes", Rule::Setting, kPlanned},
};

bool covers(std::string_view rule, std::string_view field) {
  if (!rule.ends_with(".*")) return rule == field;
  rule.remove_suffix(2);
  return field.starts_with(rule) && (field.size() == rule.size() || field[rule.size()] == '.');
}

}  // namespace

std::string_view name_of(FieldRule rule) { return kRuleNames[static_cast<std::size_t>(rule)]; }

std::span<const FieldInfo> field_rules() { return kFieldRules; }

const FieldInfo* rule_of(std::string_view schema, std::string_view field) {
  const auto found = std::find_if(kFieldRules.begin(), kFieldRules.end(), [&](const FieldInfo& one) {
    return one.schema == schema && covers(one.field, field);
  });
  return found == kFieldRules.end() ? nullptr : &*found;
}

}  // namespace unietp
