#include "rewording/check_template.h"

#include <algorithm>
#include <optional>

#include "core/text.h"
#include "dataset/task_purpose.h"
#include "generator/place_in_room.h"
#include "generator/propose.h"
#include "logic/constraints.h"
#include "scene/json_parse.h"

namespace unietp {
namespace {

/// The refinement that the tests of a goal's references have the form of, but for the two that take several.
Referring form_of(const Formula& test) {
  using P = Predicate;
  if (test.op == Formula::Op::And) return Referring::ByTwo;
  const Formula& literal = test.op == Formula::Op::Exists ? test.children.front() : test;
  const Formula& fact = literal.op == Formula::Op::Not ? literal.children.front() : literal;
  if (fact.op != Formula::Op::Atom) return Referring::ByRelation;
  switch (fact.predicate) {
    case P::InRoom:
      return Referring::ByRoom;
    case P::Nearest:
      return Referring::ByNearness;
    case P::Size:
      return Referring::BySize;
    case P::Color:
    case P::Material:
      return Referring::ByAttribute;
    default:
      return fact.terms.size() > 1 && fact.terms[1].kind != Term::Kind::Symbol ? Referring::ByRelation
                                                                               : Referring::ByState;
  }
}

void collect_tests(const Formula& formula, std::vector<const Formula*>& tests) {
  if (!formula.domain.where.empty()) tests.push_back(&formula.domain.where.front());
  for (const Formula& child : formula.children) collect_tests(child, tests);
}

std::vector<const Formula*> tests_of(const Formula& goal) {
  std::vector<const Formula*> tests;
  collect_tests(goal, tests);
  return tests;
}

/// The tests of a goal that another goal lacks.
std::vector<const Formula*> added_tests(const Formula& goal, const Formula& plain) {
  auto tests = tests_of(goal);
  for (const Formula* own : tests_of(plain)) {
    const auto same = std::find_if(tests.begin(), tests.end(), [&](const Formula* test) { return *test == *own; });
    if (same != tests.end()) tests.erase(same);
  }
  return tests;
}

/// What is wrong with the name of a refinement that the generator added, as these tests; "" when nothing is.
std::string refinement_fault(Referring refinement, const std::vector<const Formula*>& tests) {
  if (tests.empty()) return "names a refinement, but its goal refers to objects only by category";
  const Referring form = tests.size() > 1 ? Referring::EachItsOwn : form_of(*tests.front());
  return form == refinement ? ""
                            : "has a goal that refers by another property than " + std::string(name_of(refinement));
}

class TaskAgainstTemplate {
 public:
  TaskAgainstTemplate(const TaskRecord& task, const Formula& goal, const Template& source, const Resources& resources)
      : task_(task), goal_(goal), source_(source), resources_(resources) {}

  std::vector<Problem> problems() {
    const auto simulator = simulator_named(task_.simulator);
    const auto refinement = referring_named(task_.refinement);
    const auto split = split_named(task_.split);
    if (!simulator) return {};  // a problem of its own
    if (!refinement) found("has the unknown refinement " + in_quotes(task_.refinement));
    if (!split) found("has the unknown split " + in_quotes(task_.split));
    if (!refinement || !split) return std::move(problems_);
    compare_purpose(*simulator);
    if (*refinement == Referring::EachItsOwn) {  // its binding is of one category, which the template need not allow
      if (auto fault = refinement_fault(*refinement, tests_of(goal_)); !fault.empty()) found(std::move(fault));
      if (*split != Split::InstanceGrounding) found("has the split " + task_.split + ", unlike its refinement");
      (void)bindings_in_order();
      return std::move(problems_);
    }
    const auto filled = fill_in(source_, resources_.backend(*simulator).knowledge, task_.bindings);
    if (const auto* refusal = std::get_if<GateRefusal>(&filled)) {
      found("its binding does not fit its template: " + refusal->reason);
    } else if (bindings_in_order()) {
      const auto& knowledge = resources_.backend(*simulator).knowledge;
      const auto plain = with_rooms_of_goal(std::get<Specification>(filled), *refinement, knowledge);
      plain.split == *split ? compare(plain) : compare_refined(plain, *split, *refinement);
    }
    return std::move(problems_);
  }

 private:
  void found(std::string message) { problems_.push_back(problem_in(ProblemKind::OfTemplate, "", std::move(message))); }

  /// The rooms by which the goal tells places apart are no refinement of it.
  Specification with_rooms_of_goal(Specification plain, Referring refinement, const Knowledge& knowledge) const {
    for (const PlaceInRoom& place : places_in_rooms(goal_, refinement, plain.goal, knowledge))
      if (auto named = with_place_in_room(plain, place)) plain = *std::move(named);
    return plain;
  }

  bool bindings_in_order() {
    std::vector<std::string> wanted, there;
    for (const auto& parameter : source_.parameters) wanted.push_back(parameter.name);
    for (const auto& [placeholder, unused] : task_.bindings) there.push_back(placeholder);
    if (wanted != there) found("binds " + join(there, ", ") + ", but its template has " + join(wanted, ", "));
    return wanted == there;
  }

  void compare(const Specification& plain) {
    if (to_text(goal_) != to_text(plain.goal)) found("its template gives another goal: " + to_text(plain.goal));
    std::vector<std::string> constraints;
    for (const Formula& start : plain.init) constraints.push_back(to_text(start));
    if (constraints != task_.start_constraints)
      found("its template gives other start constraints: " + join(constraints, ", "));
    compare_names(plain.style, plain.refinement);
  }

  void compare_purpose(Simulator simulator) {
    const auto purpose = purpose_of(source_, task_.bindings, resources_.backend(simulator).knowledge);
    if (purpose == TaskPurpose{task_.purpose, task_.because}) return;
    found("its template gives the purpose " + in_quotes(purpose.name) +
          (purpose.because.empty() ? "" : " because " + join(purpose.because, ", ")));
  }

  void compare_names(Style style, Referring refinement) {
    if (task_.style != name_of(style)) found("its template gives the style " + std::string(name_of(style)));
    if (task_.refinement != name_of(refinement))
      found("its template gives the refinement " + in_quotes(name_of(refinement)));
  }

  void compare_refined(const Specification& plain, Split split, Referring refinement) {
    if (split == Split::Linguistic) {
      const auto style = style_named(task_.style);
      if (!style || *style == Style::Direct) found("is refined by its style, but has the style " + task_.style);
      if (style) compare_reworded(plain, *style, refinement);
    } else if (split == Split::InstanceGrounding && plain.refinement == Referring::None) {
      if (auto fault = refinement_fault(refinement, added_tests(goal_, plain.goal)); !fault.empty())
        found(std::move(fault));
      if (to_text(without_references(goal_)) != to_text(without_references(plain.goal)))
        found("its template gives another goal: " + to_text(plain.goal));
      compare_names(plain.style, refinement);
    } else {
      found("has the split " + task_.split + ", which its template does not give");
    }
  }

  /// A goal that accepts more than its template's, or is about one object of several, is read back from its text.
  void compare_reworded(const Specification& plain, Style style, Referring refinement) {
    compare_names(style, refinement);
    if (style == Style::Exception || names_by_phrase(style)) return;
    if (to_text(without_references(goal_)) != to_text(without_references(plain.goal)))
      found("its template gives another goal: " + to_text(plain.goal));
    if (refinement == plain.refinement && to_text(goal_) != to_text(plain.goal))
      found("its template gives another goal: " + to_text(plain.goal));
    if (refinement == plain.refinement) return;
    if (auto fault = refinement_fault(refinement, added_tests(goal_, plain.goal)); !fault.empty())
      found(std::move(fault));
  }

  const TaskRecord& task_;
  const Formula& goal_;
  const Template& source_;
  const Resources& resources_;
  std::vector<Problem> problems_;
};

}  // namespace

std::vector<Problem> check_template(const TaskRecord& task, const Formula& goal, const ManifestRecord& manifest,
                                    const Resources& resources) {
  const auto& all = resources.templates;
  const auto source =
      std::find_if(all.begin(), all.end(), [&](const Template& one) { return one.name == task.template_name; });
  if (source != all.end()) return TaskAgainstTemplate(task, goal, *source, resources).problems();
  const auto& own = manifest.run.own;
  const bool of_user = std::any_of(own.begin(), own.end(), [&](const std::string& entry) {
    return entry.substr(0, entry.find(' ')) == task.template_name;
  });
  if (of_user) return {};
  return {problem_in(ProblemKind::OfTemplate, "",
                     "has the template " + in_quotes(task.template_name) + ", which is not in the library")};
}

}  // namespace unietp
