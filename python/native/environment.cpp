#include "environment/environment.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <memory>
#include <mutex>

#include <nlohmann/json.hpp>

#include "environment/observation_json.h"
#include "python/native/bindings.h"
#include "python/native/catalog.h"
#include "python/native/failure.h"
#include "python/native/json_to_python.h"
#include "python/native/observed.h"
#include "python/native/readable.h"
#include "python/native/settings_text.h"
#include "scene/scene_json.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace unietp::python {
namespace {

/// An environment, the form of its observations as arrays, and what the last step executed. Python's threads may share
/// one: each call has it alone.
class SharedEnvironment {
 public:
  SharedEnvironment(Environment environment, const Encoding& encoding)
      : environment_(std::move(environment)), encoding_(&encoding), form_(encoding.form()) {
    form_.begin(environment_.observe());
  }

  /// Calls work(*this) without the interpreter's lock.
  template <class Work>
  auto alone(Work work) {
    const nb::gil_scoped_release released;
    const std::scoped_lock lock(mutex_);
    return work(*this);
  }

  Environment environment_;
  const Encoding* encoding_;  // kept alive by the Python object
  ArrayForm form_;
  std::vector<ExecutedAction> executed_;

 private:
  std::mutex mutex_;
};

/// The state of an environment to come back to.
struct SavedState {
  Environment::Snapshot snapshot;
  Settings settings;
  ArrayForm form;
  std::vector<ExecutedAction> executed;
};

/// An observation in all its forms, made without the interpreter's lock but for the readable one.
struct Observed {
  ArrayBlock arrays;
  Observation observation;
  Settings settings;
  std::optional<Picture> picture;
};

Observed observed(SharedEnvironment& self, Observation observation) {
  Observed all{
      {1, self.encoding_->rows, self.encoding_->text_bytes}, std::move(observation), self.environment_.settings(), {}};
  self.form_.see(all.observation);
  self.form_.write(all.observation, all.arrays.part(0));
  if (all.observation.has_picture) all.picture = self.environment_.picture();
  return all;
}

Observed observed_now(SharedEnvironment& self) { return observed(self, self.environment_.observe()); }

nb::tuple handed_over(Observed all) {
  return nb::make_tuple(std::move(all.arrays).to_python(false), readable(all.observation, all.settings),
                        all.picture ? to_python(std::move(*all.picture)) : nb::none());
}

nb::tuple reset(SharedEnvironment& self, const TaskHandle* task) {
  auto all = self.alone([&](SharedEnvironment& own) {
    if (task == nullptr) {
      own.environment_.reset();
    } else {
      (void)value_of(own.environment_.reset(task->task));
    }
    own.executed_.clear();
    own.form_.begin(own.environment_.observe());
    return observed_now(own);
  });
  return handed_over(std::move(all));
}

/// `act` takes the environment and gives its StepResult.
template <class Act>
nb::tuple step(SharedEnvironment& self, const Act& act) {
  double reward = 0;
  bool terminated = false, truncated = false;
  auto all = self.alone([&](SharedEnvironment& own) {
    auto result = act(own);
    reward = result.reward;
    terminated = result.terminated;
    truncated = result.truncated;
    own.executed_ = std::move(result.executed);
    return observed(own, std::move(result.observation));
  });
  return nb::make_tuple(handed_over(std::move(all)), reward, terminated, truncated);
}

nb::tuple step_answer(SharedEnvironment& self, const nb::bytes& answer) {
  const std::string text(answer.c_str(), answer.size());
  return step(self, [&](SharedEnvironment& own) { return own.environment_.step(std::string_view(text)); });
}

nb::tuple step_numbers(SharedEnvironment& self, std::int64_t action, std::int64_t argument,
                       const std::array<double, 4>& box) {
  return step(self, [&](SharedEnvironment& own) {
    const auto& environment = own.environment_;
    return own.environment_.step(
        own.form_.command_of({action, argument, box}, environment.settings().rules, environment.observe()));
  });
}

nb::object scene(SharedEnvironment& self) {
  const auto text = self.alone([](SharedEnvironment& own) { return scene_to_json(own.environment_.scene()); });
  return nb::module_::import_("json").attr("loads")(text);
}

Viewpoint viewpoint_of(const std::string& camera) {
  for (const Viewpoint viewpoint : kViewpoints) {
    if (name_of(viewpoint) == camera) return viewpoint;
  }
  throw PythonError("no camera is named \"" + camera + "\"; accepted are agent, behind and above");
}

nb::dict channels(SharedEnvironment& self, int width, int height, const std::string& camera) {
  std::vector<std::string> ids;
  auto all = self.alone([&](SharedEnvironment& own) {
    const Viewpoint viewpoint = viewpoint_of(camera);
    const Observation& seen = own.environment_.observe();
    const bool own_size = width == 0 && height == 0;
    for (const Node& node : own.environment_.scene().nodes) ids.push_back(node.id);
    if (viewpoint != Viewpoint::Agent) ids.emplace_back("agent");
    return value_of(own.environment_.channels(own_size ? seen.image_width : width,
                                              own_size ? seen.image_height : height, viewpoint));
  });
  return to_python(std::move(all), ids);
}

void define_acting(nb::class_<SharedEnvironment>& environment) {
  environment
      .def(
          "__init__",
          [](SharedEnvironment* self, const TaskHandle& task, const std::string& settings, const Encoding& encoding) {
            const nb::gil_scoped_release released;
            new (self) SharedEnvironment(value_of(Environment::make(task.task, settings_of(settings))), encoding);
          },
          "task"_a, "settings"_a, "encoding"_a, nb::keep_alive<1, 4>(),
          "Starts the first episode. Raises Error for settings that cannot be kept.")
      .def("reset", &reset, "task"_a.none() = nb::none(),
           "Begins this task again, or another. Gives (arrays, readable observation, picture or None).")
      .def("step", &step_answer, "action"_a,
           "Reads what an agent answered and executes it. Gives (as reset, reward, terminated, truncated). Never "
           "raises for "
           "what was answered.")
      .def("step_numbers", &step_numbers, "action"_a, "argument"_a, "box"_a,
           "The same for an action of Gymnasium's action space.")
      .def(
          "observe", [](SharedEnvironment& self) { return handed_over(self.alone(observed_now)); },
          "The present observation, as reset gives it.")
      .def(
          "render",
          [](SharedEnvironment& self, int width, int height, const std::string& camera) {
            return to_python(self.alone([&](SharedEnvironment& own) {
              return value_of(own.environment_.render(width, height, viewpoint_of(camera)));
            }));
          },
          "width"_a, "height"_a, "camera"_a = "agent",
          "What a camera (agent, behind, above) shows: uint8 (height, width, 3). Raises Error for a size or camera.")
      .def(
          "prompt",
          [](SharedEnvironment& self, bool reasoning) {
            return self.alone([&](SharedEnvironment& own) { return own.environment_.prompt(reasoning); });
          },
          "reasoning"_a = false, "The system prompt of the episode.")
      .def(
          "text",
          [](SharedEnvironment& self) {
            return self.alone([](SharedEnvironment& own) { return own.environment_.text(); });
          },
          "The observation in words, as a user's turn of a chat.");
}

void define_privileged(nb::class_<SharedEnvironment>& environment) {
  environment
      .def_prop_ro("task",
                   [](SharedEnvironment& self) {
                     return self.alone([](SharedEnvironment& own) { return TaskHandle{own.environment_.task()}; });
                   })
      .def_prop_ro(
          "complete",
          [](SharedEnvironment& self) {
            return self.alone([](SharedEnvironment& own) { return own.form_.complete(); });
          },
          "Whether `things` has a row for all that the agent was told of.")
      .def(
          "ids",
          [](SharedEnvironment& self) { return self.alone([](SharedEnvironment& own) { return own.form_.ids(); }); },
          "The id in each row of `things` that is in use.")
      .def(
          "privileged",
          [](SharedEnvironment& self) {
            return to_python(
                self.alone([](SharedEnvironment& own) { return privileged_to_json(own.environment_.privileged()); }));
          },
          nb::sig("def privileged(self) -> dict[str, typing.Any]"),
          "success, hopeless, progress, missing, goal, steps, failures, ended_by: not for the agent.")
      .def(
          "executed",
          [](SharedEnvironment& self) {
            return to_python(self.alone([](SharedEnvironment& own) { return executed_to_json(own.executed_); }));
          },
          nb::sig("def executed(self) -> list[dict[str, typing.Any]]"),
          "What the last step's actions came to and changed: not for the agent.")
      .def("scene", &scene, nb::sig("def scene(self) -> dict[str, typing.Any]"),
           "The scene graph with all relations, as in a scene file: not for the agent.")
      .def(
          "expert_steps_left",
          [](SharedEnvironment& self) {
            return self.alone([](SharedEnvironment& own) { return own.environment_.expert_steps_left(); });
          },
          "How many actions of M1 the expert's plan from here has, `stop` included; None when it finds none. Not for "
          "the agent; takes up to some 100 ms.")
      .def("channels", &channels, "width"_a, "height"_a, "camera"_a = "agent",
           nb::sig("def channels(self, width: int, height: int, camera: str = 'agent') -> dict[str, typing.Any]"),
           "Depth, normals, instances and ids of the picture that `render` gives; sizes of 0: those of the "
           "observation's "
           "picture. Not for the agent. Raises Error as it does.")
      .def(
          "snapshot",
          [](SharedEnvironment& self) {
            return self.alone([](SharedEnvironment& own) {
              return SavedState{own.environment_.snapshot(), own.environment_.settings(), own.form_, own.executed_};
            });
          },
          "The present state, to come back to. Immutable.")
      .def(
          "restore",
          [](SharedEnvironment& self, const SavedState& saved) {
            self.alone([&](SharedEnvironment& own) {
              if (own.environment_.settings() != saved.settings)
                throw PythonError("the snapshot is of an environment with other settings");
              own.environment_.restore(saved.snapshot);
              own.form_ = saved.form;
              own.executed_ = saved.executed;
            });
          },
          "snapshot"_a,
          "Goes to a snapshot of this environment or of another with the same settings and encoding. Raises Error for "
          "other settings.");
}

}  // namespace

void define_environment(nb::module_& module) {
  nb::class_<SavedState>(module, "Snapshot", "A state of an environment. Immutable.");
  nb::class_<SharedEnvironment> environment(module, "Environment", "An episode of one task.");
  define_acting(environment);
  define_privileged(environment);
}

}  // namespace unietp::python
