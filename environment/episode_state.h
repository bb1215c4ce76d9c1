#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "environment/acting_simulator.h"
#include "environment/answer.h"
#include "environment/observation.h"
#include "environment/settings.h"
#include "environment/step_result.h"
#include "environment/task.h"
#include "simulation/mode_episode.h"
#include "simulation/rays.h"

namespace unietp {

/// Why an episode ended.
enum class EpisodeEnd : std::uint8_t { None, Stop, Failures, Steps, Answers };
std::string_view name_of(EpisodeEnd end);  // "", "stop", "failures", "steps", "answers"

/// All that an environment has of one episode.
struct EpisodeState {
  /// At the start. Errors: as World::create.
  static Result<std::unique_ptr<EpisodeState>> begin(const SharedTask& task, const Settings& settings,
                                                     SharedSimulator simulator);
  /// A copy that shares nothing that changes.
  std::unique_ptr<EpisodeState> apart() const;

  /// How boxes of answers are to be read.
  AnswerFrame frame() const { return {settings.box_form, profile->image_width, profile->image_height}; }
  EpisodeEnd end() const;
  /// The scene graph that the goal is judged on.
  const Scene& judged_scene() const { return simulator ? theirs : episode.world().scene(); }
  /// What the simulator makes of an action, with its state kept up; nullopt when it does not answer.
  std::optional<SimulatorAnswer> ask(const Action& action, const Delta& ours);
  /// Reads the goal at the next moment: what changed, and where comparisons are to be made, the scene as it is then.
  void read(const Delta& changes, const Scene* scene);
  /// Reads it at all moments that the last step of our physics led through.
  void read_own();
  /// Reads it at all moments of the simulator's last answer.
  void read_theirs(const SimulatorAnswer& answer);
  /// Makes the observation of the present state; `results`: what was executed since the one before.
  void observe(std::vector<ActionReport> results);

  SharedTask task;
  Settings settings;
  std::shared_ptr<const Profile> profile;  // with the image size of the settings
  ModeEpisode episode;
  FactReader reader;
  Facts facts;
  Monitor monitor;
  std::optional<std::vector<Action>> done;  // that succeeded; nullopt: more than are kept
  int answered = 0;                         // actions taken, invalid ones included
  Observation observation;
  mutable Rays rays;               // scratch space
  SharedSimulator simulator = {};  // in which the episode is acted out, too; null: our physics alone
  Scene theirs = {};               // its state, in our scene graph
  std::string broken = {};         // why it no longer answers
};

/// The actions of one answer, one after the other.
class StepInProgress {
 public:
  explicit StepInProgress(EpisodeState& state);

  /// Whether another action of the answer is to be executed.
  bool goes_on() const;
  void act(const AnsweredAction& action);
  /// An answer that is no action.
  void refuse(std::string_view expected);
  StepResult finish() &&;

 private:
  Command command_of(const AnsweredAction& action);
  void note(Command command, Outcome outcome, Delta changes, int steps_before);

  EpisodeState& state_;
  StepResult result_;
  std::vector<ActionReport> reports_;
  double progress_before_ = 0;
  bool was_over_ = false, failed_ = false;
};

}  // namespace unietp
