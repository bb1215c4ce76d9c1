#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "environment/acting_simulator.h"
#include "environment/answer.h"
#include "environment/observation.h"
#include "environment/settings.h"
#include "environment/step_result.h"
#include "environment/task.h"
#include "scene/scene.h"
#include "simulation/picture.h"
#include "simulation/viewpoint.h"

namespace unietp {

struct EpisodeState;

/// An episode of one task that an agent acts in. A value: `clone` is an independent copy that may go to another thread;
/// one environment belongs to one thread at a time. After each step it forgets what it no longer needs, so that memory
/// does not grow with the episode. Nothing that an agent says is an exception or an Error: what cannot be read or is
/// not allowed is a failed step with a reason.
/// Deterministic: equal tasks, settings and actions give equal results, bit for bit, on every x86-64 processor.
class Environment {
 public:
  /// Starts the first episode. Errors: those of check(settings); Schema when the start cannot be built.
  /// With a simulator, actions have to succeed there too and the goal is judged on its state (acting_simulator.h); such
  /// an environment is not copied. What the simulator fails to do is no error here: see `broken`.
  static Result<Environment> make(const SharedTask& task, const Settings& settings,
                                  SharedSimulator simulator = nullptr);
  Environment(Environment&&) noexcept;
  Environment& operator=(Environment&&) noexcept;
  ~Environment();

  const SharedTask& task() const;  // never null
  const Settings& settings() const;

  /// Begins the task again from its start, in a new world.
  const Observation& reset();
  /// Begins another task. Errors: as `make`; the environment then stays as it was.
  Result<Done> reset(const SharedTask& task);

  /// What the agent may know now.
  const Observation& observe() const;
  /// Reads what an agent answered and executes its actions, one after the other, until the episode is over; `on_fail`
  /// says whether a list goes on after a failure. After the end nothing happens and the reward is 0.
  StepResult step(std::string_view text);
  /// The same for actions that are commands already; boxes in pixels.
  StepResult step(const Command& command);
  StepResult step(const std::vector<Command>& commands);
  StepResult step(const Answer& answer);
  /// Whether the episode has ended.
  bool over() const;
  /// Why the simulator no longer answers, after which nothing is executed; "" when it does, or there is none.
  const std::string& broken() const;

  /// What the head camera shows: rows from the top, three bytes a pixel, observe().image_width × image_height.
  Picture picture() const;
  /// The same in another size, at the same field of view from top to bottom, or the home from another viewpoint, which
  /// shows the agent too. Errors: Usage for a size out of range.
  Result<Picture> render(int width, int height, Viewpoint viewpoint = Viewpoint::Agent) const;
  /// Depth, surface normals and objects of that picture. Of `node`, positions in scene().nodes; their number stands for
  /// the agent's body. Objects are privileged, and so is all from another viewpoint than the agent's. Errors: as
  /// render.
  Result<Channels> channels(int width, int height, Viewpoint viewpoint = Viewpoint::Agent) const;

  /// The system prompt of this episode (agent_text.h).
  std::string prompt(bool reasoning = false) const;
  /// observe() in words (agent_text.h).
  std::string text() const;

  /// A copy of its own, on whatever thread.
  Environment clone() const;
  /// The present state, to come back to. Immutable: several environments, also on several threads, may restore it.
  class Snapshot {
   public:
    bool operator==(const Snapshot& other) const = default;  // the same snapshot

   private:
    friend class Environment;
    std::shared_ptr<const EpisodeState> state_;
  };
  Snapshot snapshot() const;
  /// Goes to a snapshot of this or another environment; its task and settings come with it.
  void restore(const Snapshot& snapshot);

  // Privileged.
  PrivilegedState privileged() const;
  /// privileged().progress alone, at a fraction of the cost.
  double progress() const;
  /// The scene graph with all relations; the simulator's where there is one.
  const Scene& scene() const;
  /// Whether there is an object of this id in the home now, seen or not.
  bool has_object(std::string_view id) const;
  /// How many actions of M1 the expert would still take from here, `stop` included: the length of one plan of its,
  /// which need not be the shortest. nullopt when it finds none, or after more successful actions than it can retrace
  /// (1,000). Takes as long as planning does: milliseconds to seconds.
  std::optional<int> expert_steps_left() const;
  /// What is in the picture, whatever the settings tell the agent. Sorted by id.
  const std::vector<VisibleObject>& pictured() const;
  /// Whether `pictured` contains the object, without computing the whole view.
  bool pictures(std::string_view id) const;

 private:
  explicit Environment(std::unique_ptr<EpisodeState> state);
  std::unique_ptr<EpisodeState> state_;
};

}  // namespace unietp
