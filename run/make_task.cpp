#include "run/make_task.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "annotator/home_facts.h"
#include "core/text.h"
#include "dataset/candidate_number.h"
#include "expert/mode_expert.h"
#include "expert/tempting_plan.h"
#include "generator/fixed_start.h"
#include "generator/place_in_room.h"
#include "generator/propose.h"
#include "generator/weighted_binding.h"
#include "grounding/ground.h"
#include "run/category_weights.h"
#include "run/fit_of_home.h"
#include "run/given_binding.h"
#include "run/new_uses.h"
#include "run/sense_of_binding.h"
#include "templates/purposes.h"

namespace unietp {
namespace {

std::string task_id(const TaskSlot& slot) {
  auto digits = std::to_string(slot.index + 1);
  digits.insert(0, digits.size() < 5 ? 5 - digits.size() : 0, '0');
  return std::string(name_of(slot.simulator)) + "-" + digits;
}

using SenseOf = std::function<TaskSense(const Specification&)>;

/// Of what kind a task is to be.
struct Asked {
  Split split = Split::Atomic;
  std::string_view style;  // of the Linguistic split; "": any that fits
  Grade least = Grade::Usual;
  const Household* household = nullptr;  // of the simulator's homes
  const NounTable* nouns = nullptr;      // as the texts say them
};

/// "A=Mug, B=Bed: mug on bed (rule:…)"
std::string said_of(const Binding& binding, const TaskSense& sense) {
  std::string text = to_text(binding);
  if (!sense.parts.empty()) text += ": " + sense.parts.front().part + " (" + sense.parts.front().sense.why + ")";
  return text;
}

bool another_binding_helps(RejectionReason reason) {
  return reason == RejectionReason::NoReferringConstraint || reason == RejectionReason::NoWording ||
         reason == RejectionReason::Senseless || reason == RejectionReason::LacksFurniture ||
         reason == RejectionReason::LacksRoom;
}

/// What the home would need that no edit of a start gives it.
std::optional<Rejection> lacking(const Specification& specification, const Layout& layout, const Knowledge& knowledge) {
  const Formula* missing = misfit(specification.init, knowledge, layout.offer.now);
  if (missing == nullptr) return std::nullopt;
  return Rejection{lack_of(missing->domain.members.front().category, knowledge),
                   to_text(specification.binding) + " in " + layout.home.scene.id + ": " + to_text(*missing)};
}

/// The specification in the slot's split, or why there is none.
std::variant<Specification, Rejection> specify_once(const Template& source, const Layout& layout,
                                                    const Knowledge& knowledge, const std::optional<Binding>& binding,
                                                    const Asked& asked, const SenseOf& sense_of, const Rng& rng) {
  const Split split = asked.split;
  if (!binding)
    return Rejection{RejectionReason::NoBinding, "no categories that " + layout.home.scene.id +
                                                     " can offer meet the constraints of " + source.name};
  const auto refused = [&](const GateRefusal& refusal) {
    return Rejection{rejection_of(refusal.gate), to_text(*binding) + ": " + refusal.reason};
  };
  auto filled = fill_in(source, knowledge, *binding);
  if (const auto* refusal = std::get_if<GateRefusal>(&filled)) return refused(*refusal);
  const auto* plain = std::get_if<Specification>(&filled);
  if (auto why = lacking(*plain, layout, knowledge)) return *why;
  // Refinement is checked before the gates, which cost more.
  auto specified = std::optional(*plain);  // also one that its template has refined
  if (plain->split != split && split == Split::InstanceGrounding) {
    specified = refine_referring(*plain, knowledge, layout.offer, source.refinement, rng.fork("referring", 0));
    if (!specified) return Rejection{RejectionReason::NoReferringConstraint, to_text(*binding)};
  } else if (plain->split != split && split == Split::Linguistic) {
    specified = refine_linguistic(*plain, knowledge, layout.offer, asked.style, rng.fork("linguistic", 0));
    if (!specified) return Rejection{RejectionReason::NoWording, to_text(*binding)};
  }
  if (asked.household != nullptr)
    specified = with_places_in_rooms(*specified, knowledge, layout.offer,
                                     rooms_for(specified->goal, *asked.household, knowledge), rng.fork("rooms", 0));
  if (auto why = lacking(*specified, layout, knowledge)) return *why;
  if (asked.least > Grade::Senseless) {
    if (asked.household != nullptr && !all_sinks_suit(specified->goal, layout, *asked.household))
      return Rejection{RejectionReason::Senseless, to_text(*binding) + ": a place in another room would do, too"};
    if (asked.household != nullptr && asked.least == Grade::Usual &&
        leaves_open(specified->goal, layout, *asked.household, *asked.nouns))
      return Rejection{RejectionReason::Senseless, to_text(*binding) + ": any of several would do"};
    const TaskSense sense = sense_of(*specified);
    if (sense.grade < asked.least) return Rejection{RejectionReason::Senseless, said_of(*binding, sense)};
  }
  if (const auto refusal = refused_by(*plain, knowledge)) return refused(*refusal);
  return std::move(*specified);
}

/// Most categories cannot be referred to in every home, nor worded in every style: a few further bindings, with the
/// `fixed` categories, are tried before a candidate is rejected.
std::variant<Specification, Rejection> specify(const Template& source, const Layout& layout, const Knowledge& knowledge,
                                               const std::optional<Binding>& planned, const BindingWishes& wishes,
                                               const Asked& asked, const SenseOf& sense_of, const Rng& rng) {
  constexpr std::uint64_t kBindings = 8;  // of the candidates that 32 bindings save, 8 save 98 %
  constexpr std::uint64_t kLooks = 40;    // which of its things a home has several of is quickly seen
  const auto is_lack = [](RejectionReason why) {
    return why == RejectionReason::LacksFurniture || why == RejectionReason::LacksRoom;
  };
  auto specified = specify_once(source, layout, knowledge, planned, asked, sense_of, rng);
  for (std::uint64_t i = 1, costly = 1; i < kLooks && costly < kBindings; ++i) {
    const auto* why = std::get_if<Rejection>(&specified);
    if (why == nullptr || !another_binding_helps(why->reason)) break;
    if (!is_lack(why->reason)) ++costly;
    const auto again = rng.fork("again", i);
    const auto binding = sample_binding(source, knowledge, layout.offer.categories, wishes, again.fork("binding", 0));
    specified = specify_once(source, layout, knowledge, binding, asked, sense_of, again);
  }
  return specified;
}

std::variant<Instruction, Rejection> instruct(const Specification& specification, const Backend& backend,
                                              English english, const WritingOptions& options, const Rng& rng) {
  auto instruction = write_instruction(specification, backend.knowledge, backend.nouns_in(english), options, rng);
  if (!instruction) return Rejection{RejectionReason::NoWords, instruction.error().message};
  if (instruction->style != specification.style)
    return Rejection{RejectionReason::NoWords, "no words in the style " + std::string(name_of(specification.style))};
  return std::move(*instruction);
}

/// Gives the task its demonstrations in all modes.
std::optional<Rejection> show(Task& task, ExecutionTree& executions, const std::vector<Mode>& modes,
                              const Household* usual, StageTimer& timer) {
  std::vector<Action> by_belief;
  if (std::find(modes.begin(), modes.end(), Mode::M2) != modes.end()) {  // where candidates fail most often
    timer.enter(Stage::OtherModes);
    auto done = act_by_belief(Mode::M2, executions, usual);
    if (auto* why = std::get_if<Rejection>(&done)) return std::move(*why);
    by_belief = std::move(std::get<std::vector<Action>>(done));
  }
  timer.enter(Stage::Expert);
  auto shown = demonstrate(executions, {});
  if (auto* why = std::get_if<Rejection>(&shown)) return std::move(*why);
  task.demonstration = std::move(std::get<Demonstration>(shown));

  timer.enter(Stage::Mutations);
  const auto needless = needless_steps(executions, task.demonstration);
  if (!needless.empty()) return Rejection{RejectionReason::MutationSucceeds, join(needless, "; ")};

  if (auto why = add_tempting_plan(task.demonstration, executions)) return why;

  timer.enter(Stage::OtherModes);
  for (const Mode mode : modes) {
    if (mode == Mode::M1) continue;
    auto other = demonstrate_in(mode, executions, task.demonstration, usual,
                                mode == Mode::M2 ? by_belief : std::vector<Action>{});
    if (auto* why = std::get_if<Rejection>(&other)) return std::move(*why);
    const auto missable = needless_steps(executions, std::get<Demonstration>(other));
    if (!missable.empty())
      return Rejection{RejectionReason::MutationSucceeds, std::string(name_of(mode)) + ": " + join(missable, "; ")};
    task.in_other_modes.push_back(std::move(std::get<Demonstration>(other)));
  }
  return std::nullopt;
}

}  // namespace

std::variant<Task, RejectedCandidate> make_task(const RunConfiguration& configuration, const Resources& resources,
                                                LayoutPool& layouts, const TaskSlot& slot, const CandidatePlan& plan,
                                                const Frequencies& counts, StageCosts* costs) {
  const Template& source = resources.templates[plan.source];
  const Backend& backend = resources.backend(slot.simulator);
  const auto rejected = [&](Rejection why) {
    return RejectedCandidate{std::move(why), source.name, slot.simulator, slot.split, slot.index, plan.attempt};
  };
  // One random stream per stage and candidate: a stage that draws more numbers does not change the others.
  const auto item = candidate_number(slot.index, plan.attempt);
  const Rng root(configuration.seed);

  StageTimer timer(costs, Stage::Homes);
  const auto& layout = layouts.layout(slot.simulator, plan.home);
  if (!layout) return rejected({RejectionReason::NoLayout, layout.error().message});

  timer.enter(Stage::Generator);
  const CategoryWeight weight = with_new_uses(weight_in(*layout, source, slot.split, counts, nullptr),
                                              {plan.style, configuration.seed, slot.index / configuration.block},
                                              source, backend.knowledge, counts);
  const SenseOf sense_of = [&](const Specification& one) { return sense_of_task(one, resources); };
  const BindingWishes wishes{configuration.binding, weight,
                             fits_home(configuration, resources, source, *layout, plan.least, plan.style)};
  const Asked asked{slot.split, plan.style ? name_of(*plan.style) : std::string_view(source.refinement), plan.least,
                    resources.recipe(slot.simulator).household.get(), &backend.nouns_in(configuration.english)};
  auto specified =
      specify(source, *layout, backend.knowledge, plan.binding, wishes, asked, sense_of, root.fork("generator", item));
  if (auto* why = std::get_if<Rejection>(&specified)) return rejected(std::move(*why));
  const auto& specification = std::get<Specification>(specified);
  for (const Mode mode : configuration.modes) {
    if (auto why = ruled_out_in(mode, specification.goal)) return rejected(std::move(*why));
  }

  timer.enter(Stage::Grounding);
  GroundingOptions grounding;
  grounding.likely = plan.least == Grade::Usual;
  grounding.natural = configuration.sense > Grade::Senseless;  // also of a goal that is only tolerable
  const PurposeKind* purpose = purpose_kind(source.purpose.name);
  grounding.dangerous = purpose != nullptr && purpose->of_dangers;
  grounding.household = resources.recipe(slot.simulator).household.get();
  grounding.decoys = true;
  const auto& modes = configuration.modes;
  grounding.pictured = std::find(modes.begin(), modes.end(), Mode::M3) != modes.end();
  auto grounded =
      ground(specification, layout->home, backend.knowledge, backend.profile, grounding, root.fork("grounding", item));
  if (auto* why = std::get_if<Rejection>(&grounded)) return rejected(std::move(*why));
  auto& [episode, known] = std::get<Grounded>(grounded);
  Task task{task_id(slot), std::move(episode), {}, {}, {}, {}, {}, {}, configuration.seed, slot.index, plan.attempt};
  task.purpose = purpose_of(source, task.episode.specification.binding, backend.knowledge);
  task.sense = sense_of(task.episode.specification);
  task.episode.start.id = task.id;  // the id under which it is written

  timer.enter(Stage::Annotator);
  const Scene& start = task.episode.start;
  const auto categories = known.places ? categories_in(start, *known.places) : categories_in(start);
  auto instruction =
      instruct(specification, backend, configuration.english,
               {configuration.phrasings, categories, &start, source.instructions, plan.least == Grade::Senseless, true},
               wording_stream(configuration.seed, slot.index, plan.attempt));
  if (auto* why = std::get_if<Rejection>(&instruction)) return rejected(std::move(*why));
  task.instruction = std::move(std::get<Instruction>(instruction));

  timer.enter(Stage::Expert);
  auto executions = ExecutionTree::of(specification.goal, start, backend.knowledge, backend.profile, std::move(known));
  if (!executions) return rejected({RejectionReason::NoPlan, format(executions.error())});
  if (auto why = show(task, *executions, modes, grounding.household, timer)) return rejected(std::move(*why));
  task.traits = traits_of(source, task.episode, task.demonstration);
  const auto uses = uses_of(source, task.episode.specification.binding, task.instruction.style, backend.knowledge);
  task.traits.insert(task.traits.end(), uses.begin(), uses.end());
  return task;
}

}  // namespace unietp
