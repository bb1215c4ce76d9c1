#include "pipeline/make_task.h"

#include <chrono>

#include "core/text.h"
#include "grounding/ground.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

using Clock = std::chrono::steady_clock;

/// Adds the time since it was made, or since the last `enter`, to a stage's cost.
class StageTimer {
 public:
  StageTimer(StageCosts* costs, Stage stage) : costs_(costs), stage_(stage), start_(Clock::now()) {}
  ~StageTimer() { book(); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;
  void enter(Stage stage) {
    book();
    stage_ = stage;
  }

 private:
  void book() {
    const auto now = Clock::now();
    if (costs_ != nullptr)
      costs_->seconds[static_cast<std::size_t>(stage_)] += std::chrono::duration<double>(now - start_).count();
    start_ = now;
  }
  StageCosts* costs_;
  Stage stage_;
  Clock::time_point start_;
};

std::string task_id(const TaskSlot& slot) {
  auto digits = std::to_string(slot.index + 1);
  digits.insert(0, digits.size() < 5 ? 5 - digits.size() : 0, '0');
  return std::string(name_of(slot.simulator)) + "-" + digits;
}

std::string binding_text(const Binding& binding) {
  std::vector<std::string> parts;
  for (const auto& [placeholder, category] : binding) parts.push_back(placeholder + "=" + category);
  return join(parts, ", ");
}

/// The specification in the slot's split, or why there is none.
std::variant<Specification, Rejection> specify(const Template& source, const Layout& layout, const Knowledge& knowledge,
                                               Split split, const Rng& rng) {
  const auto binding = sample_binding(source, knowledge, layout.offered, rng.fork("binding", 0));
  if (!binding)
    return Rejection{"generator", "no-binding",
                     "no categories that " + layout.scene.id + " can offer meet the constraints of " + source.name};
  auto plain = instantiate(source, knowledge, *binding);
  if (!plain) return Rejection{"generator", "unsatisfiable", binding_text(*binding) + ": " + plain.error().message};
  if (split == Split::InstanceGrounding) {
    auto refined = refine_referring(*plain, knowledge, rng.fork("referring", 0));
    if (!refined) return Rejection{"generator", "no-referring-constraint", binding_text(*binding)};
    return *refined;
  }
  if (split == Split::Linguistic) {
    auto refined = refine_linguistic(*plain, knowledge, rng.fork("linguistic", 0));
    if (!refined) return Rejection{"generator", "no-wording", binding_text(*binding)};
    return *refined;
  }
  return *plain;
}

std::variant<Instruction, Rejection> instruct(const Specification& specification, const Knowledge& knowledge,
                                              const Rng& rng) {
  auto instruction = write_instruction(specification, knowledge, rng);
  if (!instruction) return Rejection{"annotator", "no-words", instruction.error().message};
  if (instruction->style != specification.style)
    return Rejection{"annotator", "no-words", "no words in the style " + specification.style};
  const auto problems = check_instruction(instruction->text, specification, knowledge);
  if (!problems.empty())
    return Rejection{"annotator", "check-failed", "\"" + instruction->text + "\": " + join(problems, "; ")};
  return std::move(*instruction);
}

}  // namespace

std::string_view name_of(Stage stage) {
  static constexpr std::array<std::string_view, kStageCount> kNames{"layout",    "generator", "grounding", "expert",
                                                                    "mutations", "annotator", "writer"};
  return kNames[static_cast<std::size_t>(stage)];
}

std::variant<Task, RejectedCandidate> make_task(const RunConfiguration& configuration, const Resources& resources,
                                                LayoutPool& layouts, const TaskSlot& slot, int attempt,
                                                StageCosts* costs) {
  const Template& source = resources.templates[slot.template_for(attempt)];
  const Backend& backend = resources.backend(slot.simulator);
  const auto rejected = [&](Rejection why) {
    return RejectedCandidate{std::move(why), source.name, slot.simulator, slot.split, slot.index, attempt};
  };
  // One stream a stage and candidate: a stage that draws more moves nothing in the others.
  const auto item = static_cast<std::uint64_t>(slot.index) * 1024 + static_cast<std::uint64_t>(attempt);
  const Rng root(configuration.seed);

  StageTimer timer(costs, Stage::Layout);
  const auto& layout = layouts.layout(slot.simulator, (slot.number + attempt) % layouts.size(slot.simulator));
  if (!layout) return rejected({"grounding", "no-layout", layout.error().message});

  timer.enter(Stage::Generator);
  auto specified = specify(source, *layout, backend.knowledge, slot.split, root.fork("generator", item));
  if (auto* why = std::get_if<Rejection>(&specified)) return rejected(std::move(*why));
  const auto& specification = std::get<Specification>(specified);

  timer.enter(Stage::Grounding);
  auto grounded =
      ground(specification, layout->scene, backend.knowledge, backend.profile, {}, root.fork("grounding", item));
  if (auto* why = std::get_if<Rejection>(&grounded)) return rejected(std::move(*why));
  Task task{task_id(slot), std::move(std::get<Episode>(grounded)), {}, {}, configuration.seed, slot.index, attempt};

  // What is demonstrated is what a reader of the file will rebuild: the start goes through its own text form.
  task.episode.layout = layout->scene.id;
  task.episode.start.id = task.id;
  auto written = scene_from_json(task.id, scene_to_json(task.episode.start));
  if (!written) return rejected({"grounding", "not-writable", format(written.error())});
  task.episode.start = std::move(*written);

  timer.enter(Stage::Expert);
  const Scene& start = task.episode.start;
  auto shown = demonstrate(specification.goal, start, backend.knowledge, backend.profile, {});
  if (auto* why = std::get_if<Rejection>(&shown)) return rejected(std::move(*why));
  task.demonstration = std::move(std::get<Demonstration>(shown));

  timer.enter(Stage::Mutations);
  const auto needless =
      needless_steps(specification.goal, start, task.demonstration, backend.knowledge, backend.profile);
  if (!needless.empty()) return rejected({"expert", "mutation-succeeds", join(needless, "; ")});

  timer.enter(Stage::Annotator);
  auto instruction = instruct(specification, backend.knowledge, root.fork("annotator", item));
  if (auto* why = std::get_if<Rejection>(&instruction)) return rejected(std::move(*why));
  task.instruction = std::move(std::get<Instruction>(instruction));
  return task;
}

}  // namespace unietp
