#include "validator/prove.h"

#include <algorithm>
#include <set>

#include "core/text.h"
#include "logic/constraints.h"
#include "logic/evaluate.h"
#include "record/recorded_words.h"
#include "record/text_writer.h"
#include "scene/start.h"
#include "simulation/known_start.h"
#include "simulation/relations.h"
#include "validator/conjuncts.h"
#include "validator/must_fail.h"
#include "validator/prove_start.h"
#include "validator/referents.h"
#include "validator/replay.h"
#include "validator/search_check.h"
#include "validator/start_check.h"
#include "validator/text_record.h"
#include "validator/trace_maker.h"

namespace unietp {
namespace {

bool speaks_of_comparisons(const std::string& text) {
  return text.find("(nearest ") != std::string::npos || text.find("(size ") != std::string::npos;
}

/// One task's proof under way.
class TaskProver {
 public:
  TaskProver(const TaskReading& reading, const TaskLines& lines, const ProofTools& tools)
      : reading_(reading), lines_(lines), task_(*reading.record), tools_(tools) {}

  TaskProof prove() {
    read_goal();
    if (read_scene()) prove_scene();
    for (Problem& problem : proof_.problems) problem.task = reading_.name;
    return std::move(proof_);
  }

  TaskFacts facts() {
    if (read_scene()) proof_.facts = facts_of(task_, *home_, start_, read_demonstrations(), *backend_->knowledge);
    return std::move(proof_.facts);
  }

 private:
  void found(ProblemKind kind, const std::string& where, std::string message) {
    proof_.problems.push_back(problem_in(kind, where, std::move(message)));
  }
  void found(ProblemKind kind, const Error& error) { proof_.problems.push_back({kind, "", error}); }
  void found(std::vector<Problem> problems) { append(proof_.problems, std::move(problems)); }

  void read_goal() {
    auto goal = parse_formula(reading_.where, task_.goal_text, FormulaUse::Goal);
    if (!goal) {
      found(ProblemKind::GoalText, reading_.where,
            "its goal is invalid, at column " + std::to_string(goal.error().pos.column) +
                " of the text: " + goal.error().message);
    } else {
      if (*goal != task_.goal_tree)
        found(ProblemKind::GoalTree, reading_.where,
              "the text and tree of its goal are different formulas: " + task_.goal_text + " and " +
                  to_text(task_.goal_tree));
      goal_ = std::move(*goal);
    }
    for (const auto& text : task_.start_constraints) {
      auto formula = parse_formula(reading_.where, text, FormulaUse::State);
      if (formula) constraints_.push_back(std::move(*formula));
      if (!formula)
        found(ProblemKind::StartConstraint, reading_.where,
              "start constraint " + text + ": " + formula.error().message);
    }
  }

  bool read_scene() {
    const auto simulator = simulator_named(task_.simulator);
    if (!simulator)
      found(ProblemKind::SceneName, reading_.where,
            "unknown simulator \"" + task_.simulator + "\"; accepted are ai2thor, virtualhome, habitat, behavior");
    const auto home = tools_.reader.homes().home(task_.layout);
    auto start = home ? start_in(reading_.where, **home, task_.changes, task_.scene) : Result<Scene>(home.error());
    if (!start) {
      found(ProblemKind::Unreadable, start.error());
      return false;
    }
    home_ = *home;
    start_ = std::move(*start);
    if (simulator)
      found(check_start(task_, *home_, start_, *tools_.backends[static_cast<std::size_t>(*simulator)].knowledge,
                        reading_.where));
    if (simulator && start_.simulator != *simulator)
      found(ProblemKind::SceneName, home_file(task_.layout),
            "has the simulator " + std::string(name_of(start_.simulator)) + ", but the task has " + task_.simulator);
    if (!simulator) return false;
    backend_ = &tools_.backends[static_cast<std::size_t>(*simulator)];
    return true;
  }

  void prove_scene() {
    const auto shown = read_demonstrations();
    const auto in_m1 = shown.find(Mode::M1);
    proof_.facts = facts_of(task_, *home_, start_, shown, *backend_->knowledge);
    auto physics = physics_of(start_);
    LinkTable links(start_, physics);
    found(prove_start(start_, physics, links, tools_.rest, reading_.where));
    prove_instruction();
    KnownStart known{.physics = std::move(physics)};
    if (start_.agent.held.empty()) known.links = std::move(links);  // what is held has others once it is in the hand
    const auto world = World::create(start_, *backend_->knowledge, *backend_->profile, std::move(known));
    if (!world) return found(ProblemKind::Unbuildable, reading_.where, "cannot be rebuilt: " + world.error().message);
    const bool compares =
        (goal_ && reads_comparisons(*goal_)) ||
        std::any_of(task_.start_constraints.begin(), task_.start_constraints.end(), speaks_of_comparisons);
    const TraceMaker traces(start_, compares, goal_ && reads_later_comparisons(*goal_));
    if (goal_ && tools_.manifest != nullptr && tools_.options.check_template) {
      auto problems = tools_.options.check_template(task_, *goal_, *tools_.manifest);
      for (Problem& problem : problems) problem.error.where = reading_.where;
      found(std::move(problems));
    }
    if (goal_)
      found(prove_goal_at_start(task_, *goal_, constraints_, start_, traces.at_start(), *backend_->knowledge,
                                reading_.where));
    if (goal_) prove_referents(traces.at_start());
    for (const auto& [mode, demonstration] : shown) prove_demonstration(*world, mode, demonstration, traces);
    if (in_m1 != shown.end() && goal_) add_tempting(*world, shown, in_m1->second.tempting, traces);
    proof_.counts.tempting += some_breaks_it_ ? 1 : 0;
    if (reading_.wordings) prove_wordings(*reading_.wordings, traces, in_m1 == shown.end() ? nullptr : &in_m1->second);
    if (in_m1 != shown.end() && proof_.problems.empty()) prove_forms(in_m1->second);  // which read what is proven
    prove_former_text();
    if (proof_.problems.empty()) compare_with_remade();
    if (proof_.problems.empty() && in_m1 != shown.end()) compare_with_remade_wordings(in_m1->second);
  }

  /// Each test of a phrase that tells apart tells from something. Where goals are to be what people would say, what is
  /// called the nearest is so on foot, too.
  void prove_referents(const Trace& at_start) {
    const bool tells_apart =
        recorded_split(task_.split) == RecordedSplit::InstanceGrounding || !task_.refinement.empty();
    const bool natural = tools_.manifest != nullptr && least_grade(tools_.manifest->run.sense) == RecordedGrade::Usual;
    for (const Referents& one : referents_of(*goal_, start_, at_start, *backend_->profile)) {
      const auto wrong = [&](ProblemKind kind, std::string message) {
        found(kind, reading_.where, one.phrase + " " + std::move(message));
      };
      for (const std::string& test : tells_apart ? one.idle : std::vector<std::string>())
        wrong(ProblemKind::NoDistractor, "would mean the same at the start without " + test);
      if (!natural) continue;
      for (const std::string& id : one.beyond_wall)
        wrong(ProblemKind::NotNearest, "means " + id + ", of which it is not so on foot within the room");
      for (const std::string& id : one.rivals)
        wrong(ProblemKind::NotNearest, "does not mean " + id + ", which is the nearest on foot");
    }
  }

  /// A start that is as sound as the one that the run made, or a text that says the same, but another one.
  void compare_with_remade() {
    if (tools_.manifest == nullptr || !tools_.options.remake_task || !goal_) return;
    const auto made = tools_.options.remake_task(task_, *goal_, constraints_, home_, *tools_.manifest);
    if (!made)
      return found(ProblemKind::Edits, reading_.where, "its start cannot be made again: " + made.error().message);
    if (made->changes != task_.changes)
      found(ProblemKind::Edits, reading_.where, "its start is not the one that goal, home and seed give");
    if (made->edits != task_.edits)
      found(ProblemKind::Edits, reading_.where, "the edits of its start differ from those that lead to it");
    if (text_writer_of(task_.writer) != TextWriter::Grammar || made->instruction.empty()) return;
    if (made->instruction != task_.instruction)
      found(ProblemKind::TextRecord, reading_.where,
            "its instruction is not the one that the grammar writes with the seed that the manifest names");
    if (made->phrasing != task_.phrasing)
      found(ProblemKind::TextRecord, reading_.where,
            "its instruction is recorded as phrasing " + std::to_string(task_.phrasing) + " of its template, but is " +
                std::to_string(made->phrasing) + " (0: none)");
  }

  /// Paired wordings that say the same, but are not those that `annotate` wrote.
  void compare_with_remade_wordings(const DemonstrationRecord& shown) {
    if (!reading_.wordings || tools_.manifest == nullptr || !tools_.options.remake_wordings) return;
    const auto& writing = tools_.manifest->writing;
    if (!writing || !writing->pairs) return;  // which the manifest's check tells
    const auto made = tools_.options.remake_wordings(task_, start_, shown, *tools_.manifest);
    if (!made)
      return found(ProblemKind::Wordings, kWordingsFile, "its wordings cannot be made again: " + made.error().message);
    if (*made && **made != *reading_.wordings)
      found(ProblemKind::Wordings, kWordingsFile,
            "its wordings are not those that the grammar writes with the seed that the manifest names");
  }

  /// The text that a person replaced meant the goal, too; it is the grammar's or a model's.
  void prove_former_text() {
    const auto former = tools_.former.find(task_.id);
    if (former == tools_.former.end() || !goal_ || !tools_.options.check_text || tools_.options.accept_unchecked)
      return;
    if (!problems_of(former->second, "grammar", task_.style, nullptr, *goal_).empty() &&
        !problems_of(former->second, "llm:model", task_.style, nullptr, *goal_).empty())
      found(ProblemKind::Reviews, reading_.where,
            "its text before the edit, \"" + former->second + "\", does not say its goal");
  }

  void prove_forms(const DemonstrationRecord& shown) {
    if (!tools_.options.forms_of) return;
    const auto forms = tools_.options.forms_of({task_, {{Mode::M1, shown}}, std::nullopt, start_});
    if (forms != task_.forms)
      found(ProblemKind::Forms, reading_.where,
            "has the forms \"" + join(task_.forms, " ") + "\", expected \"" + join(forms, " ") + "\"");
  }

  std::string where_shown(Mode mode) const {
    return tools_.reader.lines().shown_at(mode, lines_.shown_in(mode).line->number);
  }

  std::map<Mode, DemonstrationRecord> read_demonstrations() {
    std::map<Mode, DemonstrationRecord> shown;
    for (const Mode mode : kModes) read_demonstration(mode, shown);
    return shown;
  }

  void read_demonstration(Mode mode, std::map<Mode, DemonstrationRecord>& shown) {
    if (!lines_.shown_in(mode).line) return;
    auto read = tools_.reader.demonstration(lines_, mode);
    if (!read) return found(ProblemKind::Unreadable, read.error());
    if (const auto error = tools_.reader.misplaced(lines_, mode, *read, task_))
      found(ProblemKind::StrayDemonstration, *error);
    if (counts_steps(task_, mode)) shown.emplace(mode, std::move(*read));
  }

  void prove_demonstration(const World& world, Mode mode, const DemonstrationRecord& demonstration,
                           const TraceMaker& traces) {
    found(check_step_count(task_, mode, demonstration, reading_.where));
    auto done = replay(world, mode, demonstration, where_shown(mode));
    ++proof_.counts.demonstrations;
    proof_.counts.steps += static_cast<int>(demonstration.steps.size());
    found(std::move(done.problems));
    if (!goal_) return;
    const auto trace = traces.of(done.changes);
    if (mode == Mode::M1) {
      for (const auto& domain : empty_domains(*goal_, trace))
        found(ProblemKind::EmptyDomain, reading_.where,
              "its goal has a 'forall' or 'count' over " + domain + ", but the scene has none");
    }
    if (!holds(*goal_, trace))
      found(ProblemKind::GoalNotReached, where_shown(mode), "its replay does not reach the goal " + task_.goal_text);
    const StepMarks marks = marks_of(*goal_, world, mode, traces, done.plan);
    found(check_marks(demonstration, marks, where_shown(mode)));
    found(check_shortest(*goal_, world, traces, task_, mode, demonstration, where_shown(mode)));
    found(check_tempting(*goal_, world, traces, mode, demonstration, trace, where_shown(mode)));
    auto altered = must_fail(*goal_, world, mode, traces, done.plan, marks, where_shown(mode));
    proof_.counts.altered_plans += static_cast<int>(altered.plans.size());
    found(std::move(altered.problems));
    if (mode == Mode::M1 && !hasty_readings(*goal_).empty()) {
      ++proof_.counts.constrained;
      some_breaks_it_ = std::any_of(altered.plans.begin(), altered.plans.end(),
                                    [](const AlteredPlan& plan) { return plan.breaks_constraint; });
    }
    if (!tools_.options.take_plan) return;
    for (AlteredPlan& plan : altered.plans) proof_.plans.push_back({mode, std::move(plan)});
  }

  /// The plan that forgets a constraint, as an altered plan of the modes that tell of what is there by ids.
  void add_tempting(const World& world, const std::map<Mode, DemonstrationRecord>& shown,
                    const std::vector<Command>& tempting, const TraceMaker& traces) {
    for (const Mode mode : {Mode::M1, Mode::M2}) {
      if (tempting.empty() || !shown.contains(mode)) continue;
      auto run = run_tempting(*goal_, world, mode, traces, tempting);
      if (!run) continue;
      some_breaks_it_ = some_breaks_it_ || (mode == Mode::M1 && run->breaks_constraint);
      ++proof_.counts.altered_plans;
      if (run->reaches_goal)
        found(ProblemKind::TemptingPlan, where_shown(mode), "the goal is also reached by its tempting plan");
      if (tools_.options.take_plan) proof_.plans.push_back({mode, std::move(*run)});
    }
  }

  void prove_instruction() {
    if (trim(task_.instruction).empty()) return found(ProblemKind::NoText, reading_.where, "has no instruction");
    const bool by_model = tools_.manifest != nullptr && tools_.manifest->writing &&
                          text_writer_of(tools_.manifest->writing->writer) != TextWriter::Grammar;
    if (tools_.manifest != nullptr)
      prove_origin({task_.writer, task_.checks, task_.fallback}, by_model, reading_.where);
    if (text_writer_of(task_.writer) == TextWriter::UncheckedPerson) take_unchecked();
    if (goal_) prove_text(task_.instruction, task_.writer, task_.style, &task_.phenomena, *goal_, reading_.where);
  }

  /// A text that somebody vouches for, which anybody may claim.
  void take_unchecked() {
    ++proof_.counts.unchecked;
    if (!tools_.options.accept_unchecked)
      found(ProblemKind::TextUnchecked, reading_.where,
            "its instruction \"" + task_.instruction + "\" is by " + task_.writer +
                ": it failed the checks, so that nothing proves its meaning");
  }

  void prove_origin(const TextOrigin& origin, bool by_model, const std::string& where) {
    if (auto fault = origin_fault(origin, by_model); !fault.empty())
      found(ProblemKind::TextRecord, where, "its instruction " + std::move(fault));
  }

  void prove_text(const std::string& text, const std::string& writer, const std::string& style,
                  const std::vector<std::string>* phenomena, const Formula& goal, const std::string& where) {
    for (const Node& node : start_.nodes) {
      if (text.find(node.id) != std::string::npos)
        found(ProblemKind::TextForm, where, "its instruction contains the object id " + node.id);
    }
    if (!tools_.options.check_text) return;
    ++proof_.counts.texts;
    auto problems = problems_of(text, writer, style, phenomena, goal);
    for (Problem& problem : problems) problem.error.where = where;
    found(std::move(problems));
  }

  /// What the reader of texts finds wrong, without a place.
  std::vector<Problem> problems_of(const std::string& text, const std::string& writer, const std::string& style,
                                   const std::vector<std::string>* phenomena, const Formula& goal) const {
    std::set<std::string> around;
    for (const Node& node : start_.nodes) around.insert(node.category);
    for (const Room& room : start_.rooms) around.insert(room.type);
    return tools_.options.check_text({text,
                                      writer,
                                      style,
                                      task_.template_name,
                                      start_.simulator,
                                      goal,
                                      constraints_,
                                      {around.begin(), around.end()},
                                      &start_,
                                      phenomena,
                                      tools_.manifest == nullptr ? "us" : tools_.manifest->english,
                                      tools_.manifest == nullptr ? "everyday" : tools_.manifest->phrasings});
  }

  /// Direct and complex words are of the task's goal; those that refer have a goal that the demonstration reaches too.
  void prove_wordings(const WordingsRecord& record, const TraceMaker& traces, const DemonstrationRecord* shown) {
    const std::string where = kWordingsFile;
    if (record.pair != record.task) found(ProblemKind::Wordings, where, "has the pair id " + record.pair);
    prove_others(record, where);
    for (const auto& [kind, wording] : record.wordings) {
      const std::string name(name_of(kind));
      prove_origin({wording.writer, wording.checks, wording.fallback}, false, where);
      if (text_writer_of(wording.writer) != TextWriter::Grammar ||
          (wording.style == kDirectStyle) == (kind == WordingKind::Complex))
        found(ProblemKind::Wordings, where,
              "has a " + name + " wording by " + wording.writer + " in the style " + wording.style);
      if (wording.goal.empty()) {
        if (goal_) prove_text(wording.text, wording.writer, wording.style, nullptr, *goal_, where);
        continue;
      }
      const auto goal = parse_formula(where, wording.goal, FormulaUse::Goal);
      if (!goal) {
        found(ProblemKind::Wordings, where, "the goal of its " + name + " wording is invalid: " + goal.error().message);
        continue;
      }
      prove_text(wording.text, wording.writer, wording.style, nullptr, *goal, where);
      if (holds(*goal, traces.at_start()))
        found(ProblemKind::Wordings, where, "the goal of its " + name + " wording already holds at the start");
      if (kind == WordingKind::Contrast) {
        prove_contrast(record.wordings.at(WordingKind::Direct).text, wording, *goal, where);
        continue;
      }
      if (to_text(*goal) != wording.goal || (goal_ && without_references(*goal) != without_references(*goal_)))
        found(ProblemKind::Wordings, where,
              "the goal of its " + name + " wording is not the task's with a referring phrase");
      if (shown == nullptr) continue;
      if (!holds(*goal, traces.of(changes_by_moment(*shown))))
        found(ProblemKind::Wordings, where, "its demonstration does not reach the goal of its " + name + " wording");
    }
  }

  /// Further wordings mean the task's goal, and no two texts of it are alike.
  void prove_others(const WordingsRecord& record, const std::string& where) {
    std::set<std::string> texts;
    for (const auto& [kind, wording] : record.wordings)
      if (wording.goal.empty()) texts.insert(wording.text);
    for (const WordingRecord& wording : record.others) {
      prove_origin({wording.writer, wording.checks, wording.fallback}, false, where);
      if (text_writer_of(wording.writer) != TextWriter::Grammar)
        found(ProblemKind::Wordings, where, "has a further wording by " + wording.writer);
      if (!texts.insert(wording.text).second)
        found(ProblemKind::Wordings, where, "has the wording \"" + wording.text + "\" twice");
      if (goal_) prove_text(wording.text, wording.writer, wording.style, nullptr, *goal_, where);
    }
  }

  /// A contrast differs from the direct wording in one word, and neither means the other's goal.
  void prove_contrast(const std::string& direct, const WordingRecord& contrast, const Formula& goal,
                      const std::string& where) {
    const auto words = split(direct, ' '), others = split(contrast.text, ' ');
    int changed = words.size() == others.size() ? 0 : 2;
    for (std::size_t i = 0; changed < 2 && i < words.size(); ++i) changed += words[i] == others[i] ? 0 : 1;
    if (changed != 1)
      found(ProblemKind::Wordings, where, "its contrast does not differ from the direct wording in one word");
    if (to_text(goal) != contrast.goal)
      found(ProblemKind::Wordings, where, "the goal of its contrast is not written as it is read");
    if (!tools_.options.check_text || !goal_) return;
    if (problems_of(direct, contrast.writer, contrast.style, nullptr, goal).empty() ||
        problems_of(contrast.text, contrast.writer, contrast.style, nullptr, *goal_).empty())
      found(ProblemKind::Wordings, where, "its contrast means the same as the direct wording");
  }

  const TaskReading& reading_;
  const TaskLines& lines_;
  const TaskRecord& task_;
  const ProofTools& tools_;
  std::shared_ptr<const Scene> home_;
  Scene start_;
  std::optional<Formula> goal_;
  std::vector<Formula> constraints_;
  const ValidationBackend* backend_ = nullptr;
  bool some_breaks_it_ = false;  // a plan in M1 breaks a constraint of the goal
  TaskProof proof_;
};

}  // namespace

TaskProof prove_task(const TaskReading& task, const TaskLines& lines, const ProofTools& tools) {
  return TaskProver(task, lines, tools).prove();
}

TaskFacts read_task_facts(const TaskReading& task, const TaskLines& lines, const ProofTools& tools) {
  return TaskProver(task, lines, tools).facts();
}

}  // namespace unietp
