#include "environment/batch.h"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <memory>
#include <mutex>

#include <nlohmann/json.hpp>

#include "environment/observation_json.h"
#include "python/native/bindings.h"
#include "python/native/catalog.h"
#include "python/native/episode_tasks.h"
#include "python/native/failure.h"
#include "python/native/json_to_python.h"
#include "python/native/observed.h"
#include "python/native/readable.h"
#include "python/native/settings_text.h"

namespace nb = nanobind;
using namespace nb::literals;

namespace unietp::python {
namespace {

using Integers = nb::ndarray<const std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Boxes = nb::ndarray<const double, nb::shape<-1, 4>, nb::c_contig, nb::device::cpu>;
using Seeds = std::vector<std::optional<std::uint64_t>>;

/// Which task each environment's episodes have. Worker threads ask, each for environments of its own.
class Episodes {
 public:
  Episodes(EpisodeTasks tasks, std::size_t count)
      : tasks_(std::move(tasks)), seeds_(count), first_(count), next_(count) {}

  Result<SharedTask> task(std::size_t environment, std::uint64_t episode) {
    next_[environment] = episode + 1;
    return tasks_.task_of_episode(seeds_[environment], episode - first_[environment]);
  }
  /// From the next episode on, counted from 0 again.
  void begin(const Seeds& seeds) {
    seeds_ = seeds;
    first_ = next_;
  }

 private:
  EpisodeTasks tasks_;
  Seeds seeds_;
  std::vector<std::uint64_t> first_, next_;
};

/// Observations of all environments, made without the interpreter's lock.
struct AllObserved {
  ArrayBlock arrays;
  std::vector<Picture> pictures;  // empty when the settings show none
  std::vector<double> rewards;
  std::vector<std::uint8_t> terminated, truncated, success;
};

class SharedBatch {
 public:
  SharedBatch(std::size_t count, int threads, const EpisodeTasks& tasks, const Settings& settings,
              const Encoding& encoding)
      : encoding_(&encoding),
        episodes_(std::make_unique<Episodes>(tasks, count)),
        batch_(value_of(
            EnvironmentBatch::make(count, threads, settings,
                                   [episodes = episodes_.get()](std::size_t environment, std::uint64_t episode) {
                                     return episodes->task(environment, episode);
                                   }))),
        forms_(count, encoding.form()) {}

  AllObserved reset(const std::optional<Seeds>& seeds) {
    if (seeds || fresh_) episodes_->begin(seeds.value_or(Seeds(forms_.size())));
    fresh_ = false;
    const auto observations = value_of(batch_.reset());
    auto all = blank();
    for (std::size_t i = 0; i < observations.size(); ++i) write(observations[i], i, all);
    finish(all);
    return all;
  }

  template <class Answered>
  AllObserved step(const std::vector<Answered>& answer) {
    auto all = blank();
    (void)value_of(batch_.step(std::span<const Answered>(answer), [&](std::size_t i, const StepResult& step) {
      all.rewards[i] = step.reward;
      all.terminated[i] = step.terminated ? 1 : 0;
      all.truncated[i] = step.truncated ? 1 : 0;
      all.success[i] = batch_.at(i).over() && batch_.at(i).privileged().success ? 1 : 0;
      write(step.observation, i, all);
    }));
    finish(all);
    return all;
  }

  Answer answer_of(std::size_t environment, const NumberedAction& numbers) const {
    const auto& own = batch_.at(environment);
    return {{{forms_[environment].command_of(numbers, own.settings().rules, own.observe()), {}}}, ""};
  }
  const Environment& at(std::size_t environment) const {
    if (environment >= batch_.size()) throw PythonError("there is no environment " + std::to_string(environment));
    return batch_.at(environment);
  }
  std::size_t size() const { return batch_.size(); }
  std::vector<Channels> channels() const { return batch_.channels(); }
  const ArrayForm& form(std::size_t environment) const { return forms_.at(environment); }

  /// Calls work(*this) without the interpreter's lock, one thread at a time.
  template <class Work>
  auto alone(Work work) {
    const nb::gil_scoped_release released;
    const std::scoped_lock lock(mutex_);
    return work(*this);
  }

 private:
  AllObserved blank() const {
    const auto count = forms_.size();
    return {{count, encoding_->rows, encoding_->text_bytes},
            {},
            std::vector<double>(count),
            std::vector<std::uint8_t>(count),
            std::vector<std::uint8_t>(count),
            std::vector<std::uint8_t>(count)};
  }
  /// Changes what belongs to environment i alone, so that several threads may write at once.
  void write(const Observation& observation, std::size_t i, AllObserved& all) {
    const bool first = observation.step == 0 && !observation.last;
    first ? forms_[i].begin(observation) : forms_[i].see(observation);
    forms_[i].write(observation, all.arrays.part(i));
  }
  void finish(AllObserved& all) const {
    if (batch_.at(0).observe().has_picture) all.pictures = batch_.pictures();
  }

  const Encoding* encoding_;  // kept alive by the Python object
  std::unique_ptr<Episodes> episodes_;
  EnvironmentBatch batch_;
  std::vector<ArrayForm> forms_;
  bool fresh_ = true;
  std::mutex mutex_;
};

nb::tuple handed_over(AllObserved all) {
  nb::list pictures;
  for (auto& picture : all.pictures) pictures.append(to_python(std::move(picture)));
  return nb::make_tuple(std::move(all.arrays).to_python(true), pictures, array_of(std::move(all.rewards)),
                        array_of(std::move(all.terminated)), array_of(std::move(all.truncated)),
                        array_of(std::move(all.success)));
}

nb::tuple batch_step(SharedBatch& self, const std::vector<nb::bytes>& answer) {
  std::vector<std::string> texts;
  for (const auto& one : answer) texts.emplace_back(one.c_str(), one.size());
  return handed_over(self.alone([&](SharedBatch& own) { return own.step(texts); }));
}

nb::tuple batch_numbers(SharedBatch& self, const Integers& actions, const Integers& arguments, const Boxes& boxes) {
  if (actions.shape(0) != self.size() || arguments.shape(0) != self.size() || boxes.shape(0) != self.size()) {
    throw PythonError("expected one action for each of " + std::to_string(self.size()) + " environments");
  }
  return handed_over(self.alone([&](SharedBatch& own) {
    std::vector<Answer> answers;
    for (std::size_t i = 0; i < own.size(); ++i) {
      const double* box = boxes.data() + i * 4;
      answers.push_back(own.answer_of(i, {actions.data()[i], arguments.data()[i], {box[0], box[1], box[2], box[3]}}));
    }
    return own.step(answers);
  }));
}

}  // namespace

void define_batch(nb::module_& module) {
  nb::class_<SharedBatch>(module, "Batch", "Environments that are stepped together on several threads.")
      .def(
          "__init__",
          [](SharedBatch* self, std::size_t count, int threads, const EpisodeTasks& tasks, const std::string& settings,
             const Encoding& encoding) {
            const nb::gil_scoped_release released;
            new (self) SharedBatch(count, threads, tasks, settings_of(settings), encoding);
          },
          "count"_a, "threads"_a, "tasks"_a, "settings"_a, "encoding"_a, nb::keep_alive<1, 6>(),
          "Raises Error for a task that cannot be prepared.")
      .def("__len__", &SharedBatch::size)
      .def(
          "reset",
          [](SharedBatch& self, const std::optional<Seeds>& seeds) {
            if (seeds && seeds->size() != self.size()) throw PythonError("expected one seed for each environment");
            return handed_over(self.alone([&](SharedBatch& own) { return own.reset(seeds); }));
          },
          "seeds"_a.none() = nb::none(),
          "Begins the next episode of each. Gives (arrays, pictures, rewards, terminated, truncated, success).")
      .def("step", &batch_step, "action"_a, "One answer for each environment. Gives what reset gives.")
      .def("step_numbers", &batch_numbers, "actions"_a, "arguments"_a, "boxes"_a,
           "The same for actions of Gymnasium's action space.")
      .def(
          "channels",
          [](SharedBatch& self) {
            nb::list all;
            for (Channels& one : self.alone([](SharedBatch& own) { return own.channels(); }))
              all.append(to_python(std::move(one), {}));
            return all;
          },
          nb::sig("def channels(self) -> list[dict[str, typing.Any]]"),
          "Of the picture of each; `ids` of the objects are left out.")
      .def(
          "observe",
          [](SharedBatch& self, std::size_t environment) {
            const auto [observation, settings] = self.alone([&](SharedBatch& own) {
              return std::pair(own.at(environment).observe(), own.at(environment).settings());
            });
            return readable(observation, settings);
          },
          nb::sig("def observe(self, environment: int) -> dict[str, typing.Any]"), "environment"_a,
          "The readable observation of one environment.")
      .def(
          "text",
          [](SharedBatch& self, std::size_t environment) {
            return self.alone([&](SharedBatch& own) { return own.at(environment).text(); });
          },
          "environment"_a, "The observation of one environment in words.")
      .def(
          "prompt",
          [](SharedBatch& self, std::size_t environment) {
            return self.alone([&](SharedBatch& own) { return own.at(environment).prompt(); });
          },
          "environment"_a, "The system prompt of one environment.")
      .def(
          "ids",
          [](SharedBatch& self, std::size_t environment) {
            return self.alone([&](SharedBatch& own) { return own.at(environment), own.form(environment).ids(); });
          },
          "environment"_a, "The id in each row of `things` that is in use.")
      .def(
          "task_id",
          [](SharedBatch& self, std::size_t environment) {
            return self.alone([&](SharedBatch& own) { return own.at(environment).task()->text.id; });
          },
          "environment"_a);
}

}  // namespace unietp::python
