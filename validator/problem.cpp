#include "validator/problem.h"

#include <array>
#include <iterator>

namespace unietp {
namespace {

using Kind = ProblemKind;

constexpr std::array kProblems{
    ProblemInfo{Kind::Manifest, "manifest", "manifest.json is missing or cannot be read"},
    ProblemInfo{Kind::OtherKnowledge, "other-knowledge",
                "the data set was made with different tables, profiles or templates"},
    ProblemInfo{Kind::OtherVersion, "other-version", "the data set was made by another version of the program"},
    ProblemInfo{Kind::MissingFile, "missing-file", "a file listed in the manifest is missing"},
    ProblemInfo{Kind::UnlistedFile, "unlisted-file", "a file is not listed in the manifest"},
    ProblemInfo{Kind::ChangedFile, "changed-file", "the length or SHA-256 of a file differs from the manifest"},
    ProblemInfo{Kind::Counts, "counts", "the counts in the manifest differ from the files"},
    ProblemInfo{Kind::Quota, "quota", "the tasks do not match the recorded configuration"},
    ProblemInfo{Kind::Balance, "balance", "the balance figures in the manifest differ from those of the tasks"},
    ProblemInfo{Kind::Rejections, "rejections",
                "a candidate is listed twice, missing or out of order, or is not one of its slot"},
    ProblemInfo{Kind::Database, "database", "dataset.sqlite disagrees with the other files"},
    ProblemInfo{Kind::Card, "card", "a line of README.md differs from the one that the manifest gives"},
    ProblemInfo{Kind::Sources, "sources", "the sources in the manifest differ from those of the knowledge tables"},
    ProblemInfo{Kind::Benchmark, "benchmark", "the manifest names a frozen benchmark with other tasks or homes"},
    ProblemInfo{Kind::Reviews, "reviews", "a line of reviews.jsonl disagrees with the tasks and rejections"},
    ProblemInfo{Kind::HomeFile, "home", "a home is of no task, or differs from the one that the configuration gives"},
    ProblemInfo{Kind::RepeatedTask, "repeated-task", "two tasks have the same id"},
    ProblemInfo{Kind::RepeatedStart, "repeated-start", "two tasks have the same template, binding, goal and start"},
    ProblemInfo{Kind::RepeatedText, "repeated-text", "two tasks of one home have the same instruction"},
    ProblemInfo{Kind::SharedLayout, "shared-layout",
                "a home, by its rooms and furniture, is also in the other data set"},
    ProblemInfo{Kind::SharedSeed, "shared-seed", "both data sets have the same seed"},
    ProblemInfo{Kind::SimilarHome, "similar-home", "a home is a copy of one in the other data set, with few changes"},
    ProblemInfo{Kind::SimilarTask, "similar-task",
                "goal, instruction and home are all much like those of one task of the other data set"},
    ProblemInfo{Kind::Unreadable, "unreadable", "a line or a scene does not match its schema"},
    ProblemInfo{Kind::TaskName, "task-name", "a task's id, scene or place in the file is not that of its slot"},
    ProblemInfo{Kind::MissingDemonstration, "missing-demonstration",
                "a task has no demonstration in a mode that it or the configuration requires"},
    ProblemInfo{Kind::StrayDemonstration, "stray-demonstration",
                "a demonstration has no task, is in a mode that its task does not list, or is a duplicate"},
    ProblemInfo{Kind::StepCount, "step-count", "a task's numbers of steps or failures differ from its demonstration"},
    ProblemInfo{Kind::SceneName, "scene-name", "a home and its task have different simulators"},
    ProblemInfo{Kind::Unbuildable, "unbuildable", "physics cannot rebuild the scene"},
    ProblemInfo{Kind::Relations, "relations", "the relations of the scene differ from those in physics"},
    ProblemInfo{Kind::Unrest, "unrest", "an object is not at rest at the start"},
    ProblemInfo{Kind::StartConstraint, "start-constraint", "a recorded start constraint does not hold"},
    ProblemInfo{Kind::Edits, "edits", "a start, or the edits that name what was changed, is not what the run made"},
    ProblemInfo{Kind::Forms, "forms", "a task's forms are not those of its simulator that express it"},
    ProblemInfo{Kind::GoalText, "goal-text", "the goal's text is not a valid goal"},
    ProblemInfo{Kind::GoalTree, "goal-tree", "the goal's tree and text are different formulas"},
    ProblemInfo{Kind::Sense, "sense", "a recorded grade, or a reason for it, is not the one that the goal has"},
    ProblemInfo{Kind::BoundCategory, "binding",
                "a category is not in the knowledge base, or the goal uses one that is not bound"},
    ProblemInfo{Kind::OfTemplate, "template", "a task is not one of its template with its binding"},
    ProblemInfo{Kind::GoalAtStart, "goal-at-start", "the goal already holds at the start"},
    ProblemInfo{Kind::PartAtStart, "part-at-start", "a part of the goal already holds at the start"},
    ProblemInfo{Kind::EmptyDomain, "empty-domain", "a 'forall' or 'count' of the goal has an empty domain"},
    ProblemInfo{Kind::NoReferent, "no-referent", "a referring phrase matches no object"},
    ProblemInfo{Kind::NoDistractor, "no-distractor", "something that a referring phrase says excludes no object"},
    ProblemInfo{Kind::NotNearest, "not-nearest", "what a referring phrase calls the nearest is not so on foot"},
    ProblemInfo{Kind::Outcome, "outcome", "the result of a step differs in the replay"},
    ProblemInfo{Kind::View, "view", "the view before a step differs in the replay"},
    ProblemInfo{Kind::Changes, "changes", "the changes made by a step differ in the replay"},
    ProblemInfo{Kind::AfterEnd, "after-end", "a demonstration continues after the end of the episode"},
    ProblemInfo{Kind::NoStop, "no-stop", "a demonstration does not end with stop"},
    ProblemInfo{Kind::GoalNotReached, "goal-not-reached", "the replay of a demonstration does not reach the goal"},
    ProblemInfo{Kind::NeedlessStep, "needless-step", "the goal is also reached without one of the steps"},
    ProblemInfo{Kind::LeftInHand, "left-in-hand", "the goal is also reached if an object is not put down"},
    ProblemInfo{Kind::AnyOrder, "any-order", "the goal requires an order, but every other order also reaches it"},
    ProblemInfo{Kind::DistractorServes, "distractor-serves",
                "the goal is also reached with an object that its referring phrase excludes"},
    ProblemInfo{Kind::SearchMark, "search-mark",
                "a step is marked as search and needed for the goal itself, or the reverse"},
    ProblemInfo{
        Kind::TidyingMark, "tidying-mark",
        "a step is marked as tidying and does not only close what was opened or turn off what was turned on before, or "
        "the reverse"},
    ProblemInfo{Kind::ShortestPlan, "shortest-plan",
                "the shortest plan beside a demonstration is not one, or its length is not that of the task's line"},
    ProblemInfo{
        Kind::TemptingPlan, "tempting-plan",
        "the plan beside a demonstration that breaks only the goal's constraints is missing, or does not do that"},
    ProblemInfo{Kind::NoText, "no-text", "a task has no instruction"},
    ProblemInfo{Kind::TextForm, "text-form",
                "an instruction contains ids, coordinates, template names or markup, or is not English"},
    ProblemInfo{Kind::TextMeaning, "text-meaning",
                "an instruction does not state the goal, or asks for something else"},
    ProblemInfo{Kind::TextStyle, "text-style",
                "an instruction does not have the recorded style, or not just the recorded phenomena"},
    ProblemInfo{Kind::TextPhrasing, "text-phrasing", "an instruction's sentence pattern is not in the recorded set"},
    ProblemInfo{Kind::TextRecord, "text-record",
                "the checks or the writer of an instruction are not as its writer records them"},
    ProblemInfo{
        Kind::TextUnchecked, "text-unchecked",
        "an instruction by a person was accepted although it failed the checks, so that nothing proves its meaning"},
    ProblemInfo{Kind::Wordings, "wordings", "paired wordings do not match their task"},
};
static_assert(kProblems.size() == kProblemKinds);

}  // namespace

std::span<const ProblemInfo> all_problems() { return kProblems; }

std::string_view name_of(ProblemKind kind) { return kProblems[static_cast<std::size_t>(kind)].name; }

Problem problem_in(ProblemKind kind, std::string where, std::string message) {
  return {kind, "", {Error::Kind::Schema, std::move(where), {}, std::move(message)}};
}

void append(std::vector<Problem>& to, std::vector<Problem> from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

}  // namespace unietp
