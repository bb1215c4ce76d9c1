#include "run/remake_task.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "annotator/home_facts.h"
#include "core/in_quotes.h"
#include "core/rng.h"
#include "dataset/candidate_number.h"
#include "grounding/given_home.h"
#include "grounding/ground.h"
#include "resources/own_phrasings.h"

namespace unietp {
namespace {

constexpr std::size_t kMostPrepared = 256;  // as many as the reader of a data set keeps

Result<Specification> specification_of(const TaskRecord& task, const Formula& goal,
                                       const std::vector<Formula>& constraints) {
  const auto split = split_named(task.split);
  const auto simulator = simulator_named(task.simulator);
  const auto style = style_named(task.style);
  const auto refinement = referring_named(task.refinement);
  if (split && simulator && style && refinement)
    return Specification{task.template_name, *split, *simulator, task.bindings, goal, constraints, *style, *refinement};
  return Error{Error::Kind::Schema,
               task.id,
               {},
               "has the split " + in_quotes(task.split) + ", simulator " + in_quotes(task.simulator) + ", style " +
                   in_quotes(task.style) + " and refinement " + in_quotes(task.refinement) +
                   ", of which one is unknown"};
}

}  // namespace

Result<Remade> TaskRemaker::make(const RunConfiguration& configuration, const TaskRecord& task, const Formula& goal,
                                 const std::vector<Formula>& constraints, const std::shared_ptr<const Scene>& home) {
  const auto specification = specification_of(task, goal, constraints);
  if (!specification) return specification.error();
  const Backend& backend = resources_.backend(specification->simulator);
  GroundingOptions grounding;
  grounding.household = resources_.recipe(specification->simulator).household.get();
  grounding.decoys = true;
  const auto& modes = configuration.modes;
  grounding.pictured = std::find(modes.begin(), modes.end(), Mode::M3) != modes.end();
  auto grounded =
      ground(*specification, *prepared(home, !configuration.scenes.empty()), backend.knowledge, backend.profile,
             grounding, Rng(task.run).fork("grounding", candidate_number(task.slot, task.attempt)));
  if (const auto* why = std::get_if<Rejection>(&grounded))
    return Error{Error::Kind::Unsatisfiable, task.id, {}, why->detail};
  auto& episode = std::get<Grounded>(grounded).episode;
  auto instruction = write_instruction(*specification, backend.knowledge, backend.nouns_in(configuration.english),
                                       {.phrasings = configuration.phrasings,
                                        .around = categories_in(episode.start),
                                        .home = &episode.start,
                                        .phrasings_of_template = phrasings_of_template(resources_, task.template_name),
                                        .tells_apart = true},
                                       wording_stream(task.run, task.slot, task.attempt));
  if (!instruction) return instruction.error();
  if (!is_known_template(resources_, task.template_name)) instruction->text.clear();
  return Remade{std::move(episode), std::move(*instruction)};
}

std::shared_ptr<const Home> TaskRemaker::prepared(const std::shared_ptr<const Scene>& scene, bool given) {
  {
    const std::scoped_lock lock(mutex_);
    if (const auto found = homes_.find(scene->id); found != homes_.end() && found->second.scene == scene)
      return found->second.home;
  }
  // Perhaps by two threads at once: to the same.
  const Profile& profile = resources_.backend(scene->simulator).profile;
  auto home = std::make_shared<const Home>(given ? prepare_given_home(*scene, profile) : prepare_home(*scene, profile));
  const std::scoped_lock lock(mutex_);
  if (homes_.insert_or_assign(scene->id, Prepared{scene, home}).second) kept_.push_back(scene->id);
  if (kept_.size() > kMostPrepared) {
    homes_.erase(kept_.front());
    kept_.pop_front();
  }
  return home;
}

}  // namespace unietp
