#include "validator/problem.h"

#include <array>
#include <iterator>

namespace unietp {
namespace {

using Kind = ProblemKind;

constexpr std::array kProblems{
    ProblemInfo{Kind::Manifest, "manifest", "manifest.json is missing or does not read"},
    ProblemInfo{Kind::OtherKnowledge, "other-knowledge",
                "made with other tables, profiles or templates than those in use"},
    ProblemInfo{Kind::MissingFile, "missing-file", "a file that the manifest lists is not there"},
    ProblemInfo{Kind::UnlistedFile, "unlisted-file", "a file is there that the manifest does not list"},
    ProblemInfo{Kind::ChangedFile, "changed-file", "length or SHA-256 of a file are not those that the manifest has"},
    ProblemInfo{Kind::Counts, "counts", "the manifest's counts are not those of the files"},
    ProblemInfo{Kind::Quota, "quota", "the tasks are not those that the recorded configuration asks for"},
    ProblemInfo{Kind::Balance, "balance", "the manifest's measured spread is not that of the tasks"},
    ProblemInfo{Kind::Rejections, "rejections", "a rejected candidate is also a task, or stands there twice"},
    ProblemInfo{Kind::Database, "database", "dataset.sqlite says something else than the other files"},
    ProblemInfo{Kind::RepeatedTask, "repeated-task", "two tasks have one id"},
    ProblemInfo{Kind::RepeatedStart, "repeated-start", "two tasks have template, binding, goal and start in common"},
    ProblemInfo{Kind::RepeatedText, "repeated-text", "two tasks of one home have the same words"},
    ProblemInfo{Kind::SharedLayout, "shared-layout",
                "a home, by name or by its rooms and furniture, is also in the other data set"},
    ProblemInfo{Kind::SharedSeed, "shared-seed", "the run's seed is also that of the other data set"},
    ProblemInfo{Kind::SharedText, "shared-text",
                "an instruction, but for case and punctuation, is also in the other data set"},
    ProblemInfo{Kind::Unreadable, "unreadable", "a line or a scene does not follow its schema"},
    ProblemInfo{Kind::MissingDemonstration, "missing-demonstration",
                "a task has no demonstration in a mode that it or the configuration names"},
    ProblemInfo{Kind::StrayDemonstration, "stray-demonstration",
                "a demonstration is of no task, of a mode that its task does not name, or there twice"},
    ProblemInfo{Kind::StepCount, "step-count", "a task counts other steps or failures than its demonstration has"},
    ProblemInfo{Kind::SceneName, "scene-name", "a home is of another simulator than its task"},
    ProblemInfo{Kind::Unbuildable, "unbuildable", "physics cannot rebuild the scene"},
    ProblemInfo{Kind::Relations, "relations", "the scene's relations are not those that physics shows"},
    ProblemInfo{Kind::Unrest, "unrest", "something is not at rest at the start"},
    ProblemInfo{Kind::StartConstraint, "start-constraint", "a recorded start constraint does not hold"},
    ProblemInfo{Kind::GoalText, "goal-text", "the goal's text is no goal"},
    ProblemInfo{Kind::GoalTree, "goal-tree", "the goal's tree is another formula than its text"},
    ProblemInfo{Kind::Binding, "binding",
                "a category is unknown to the knowledge base, or the goal speaks of one that is not bound"},
    ProblemInfo{Kind::GoalAtStart, "goal-at-start", "the goal holds before anything is done"},
    ProblemInfo{Kind::PartAtStart, "part-at-start", "a part of the goal holds before anything is done"},
    ProblemInfo{Kind::EmptyDomain, "empty-domain", "the goal speaks of all or a number of what is not there"},
    ProblemInfo{Kind::NoReferent, "no-referent", "nothing is what a referring phrase describes"},
    ProblemInfo{Kind::NoDistractor, "no-distractor", "a referring phrase excludes nothing"},
    ProblemInfo{Kind::Outcome, "outcome", "the replay of a step has another outcome than recorded"},
    ProblemInfo{Kind::View, "view", "the camera shows something else before a step than recorded"},
    ProblemInfo{Kind::Changes, "changes", "the replay of a step changes something else than recorded"},
    ProblemInfo{Kind::AfterEnd, "after-end", "a demonstration goes on when the episode is over"},
    ProblemInfo{Kind::NoStop, "no-stop", "a demonstration does not end with stop"},
    ProblemInfo{Kind::GoalNotReached, "goal-not-reached", "the replay of a demonstration does not reach the goal"},
    ProblemInfo{Kind::NeedlessStep, "needless-step", "without a step the goal is reached as well"},
    ProblemInfo{Kind::LeftInHand, "left-in-hand", "the goal is reached as well when something is not put down"},
    ProblemInfo{Kind::AnyOrder, "any-order", "the goal asks for an order, and every other order reaches it as well"},
    ProblemInfo{Kind::DistractorServes, "distractor-serves",
                "the goal is reached as well with something that its referring phrase excludes"},
    ProblemInfo{Kind::NoText, "no-text", "a task has no instruction"},
    ProblemInfo{Kind::TextForm, "text-form",
                "an instruction has ids, coordinates, template names, markup, or is no plain English"},
    ProblemInfo{Kind::TextMeaning, "text-meaning",
                "an instruction does not say the goal, or asks for something else too"},
    ProblemInfo{Kind::TextStyle, "text-style", "an instruction lacks the style that is recorded"},
    ProblemInfo{Kind::TextPhrasing, "text-phrasing",
                "an instruction's turn of phrase is not of the set that is recorded"},
    ProblemInfo{Kind::Wordings, "wordings", "paired wordings that do not belong to their task"},
};
static_assert(kProblems.size() == static_cast<std::size_t>(Kind::Wordings) + 1);

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
