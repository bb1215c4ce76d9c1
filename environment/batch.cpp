#include "environment/batch.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/limits.h"
#include "core/share_work.h"

namespace unietp {

struct EnvironmentBatch::Impl {
  /// An environment and the number of its episode.
  struct Member {
    std::optional<Environment> environment;
    std::uint64_t episode = 0;
    std::optional<Error> error;
  };

  /// Calls `work` for each member on the threads. Errors: that of the first member that has one.
  template <class Work>
  Result<Done> each(const Work& work) {
    threads.share(members.size(), [&](std::size_t i) {
      members[i].error.reset();
      work(i, members[i]);
    });
    for (const Member& member : members) {
      if (member.error) return *member.error;
    }
    return Done{};
  }

  void begin(std::size_t i, Member& member) {
    auto task = task_of(i, member.episode);
    if (!task) {
      member.error = task.error();
      return;
    }
    if (member.environment) {
      if (auto begun = member.environment->reset(*task); !begun) member.error = begun.error();
      return;
    }
    auto made = Environment::make(*task, settings);
    if (made) {
      member.environment.emplace(std::move(*made));
    } else {
      member.error = made.error();
    }
  }

  template <class Answered>
  Result<Done> step(std::span<const Answered> answers, const TakeStep& take) {
    if (answers.size() != members.size())
      return Error{Error::Kind::Usage,
                   "batch",
                   {},
                   "expected " + std::to_string(members.size()) + " answers, not " + std::to_string(answers.size())};
    return each([&](std::size_t i, Member& member) {
      if (!member.environment->over()) return take(i, member.environment->step(answers[i]));
      ++member.episode;
      begin(i, member);
      if (member.error) return;
      StepResult first;
      first.observation = member.environment->observe();
      take(i, std::move(first));
    });
  }

  template <class Answered>
  Result<std::vector<StepResult>> results(std::span<const Answered> answers) {
    std::vector<StepResult> results(members.size());
    const auto done = step(answers, [&](std::size_t i, StepResult result) { results[i] = std::move(result); });
    if (!done) return done.error();
    return results;
  }

  explicit Impl(int thread_count) : threads(thread_count) {}

  ThreadTeam threads;
  Settings settings;
  TaskOfEpisode task_of;
  std::vector<Member> members;
};

EnvironmentBatch::EnvironmentBatch(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
EnvironmentBatch::EnvironmentBatch(EnvironmentBatch&&) noexcept = default;
EnvironmentBatch& EnvironmentBatch::operator=(EnvironmentBatch&&) noexcept = default;
EnvironmentBatch::~EnvironmentBatch() = default;

Result<EnvironmentBatch> EnvironmentBatch::make(std::size_t count, int threads, const Settings& settings,
                                                TaskOfEpisode task_of) {
  if (count < 1 || count > limits::kEnvironments)
    return Error{
        Error::Kind::Usage, "batch", {}, "expected 1 to " + std::to_string(limits::kEnvironments) + " environments"};
  auto impl = std::make_unique<Impl>(
      static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(std::max(1, threads)), count)));
  impl->settings = settings;
  impl->task_of = std::move(task_of);
  impl->members.resize(count);
  const auto begun = impl->each([&](std::size_t i, Impl::Member& member) { impl->begin(i, member); });
  if (!begun) return begun.error();
  return EnvironmentBatch(std::move(impl));
}

std::size_t EnvironmentBatch::size() const { return impl_->members.size(); }
const Environment& EnvironmentBatch::at(std::size_t environment) const {
  return *impl_->members[environment].environment;
}
Environment& EnvironmentBatch::at(std::size_t environment) { return *impl_->members[environment].environment; }

Result<std::vector<Observation>> EnvironmentBatch::reset() {
  const auto begun = impl_->each([&](std::size_t i, Impl::Member& member) {
    ++member.episode;
    impl_->begin(i, member);
  });
  if (!begun) return begun.error();
  std::vector<Observation> observations;
  for (const auto& member : impl_->members) observations.push_back(member.environment->observe());
  return observations;
}

Result<std::vector<StepResult>> EnvironmentBatch::step(std::span<const std::string> answers) {
  return impl_->results(answers);
}
Result<std::vector<StepResult>> EnvironmentBatch::step(std::span<const Answer> answers) {
  return impl_->results(answers);
}
Result<Done> EnvironmentBatch::step(std::span<const std::string> answers, const TakeStep& take) {
  return impl_->step(answers, take);
}
Result<Done> EnvironmentBatch::step(std::span<const Answer> answers, const TakeStep& take) {
  return impl_->step(answers, take);
}

std::vector<Picture> EnvironmentBatch::pictures() const {
  std::vector<Picture> pictures(size());
  impl_->threads.share(size(), [&](std::size_t i) { pictures[i] = at(i).picture(); });
  return pictures;
}

std::vector<Channels> EnvironmentBatch::channels() const {
  std::vector<Channels> channels(size());
  impl_->threads.share(size(), [&](std::size_t i) {
    const Observation& seen = at(i).observe();
    channels[i] = at(i).channels(seen.image_width, seen.image_height).value();
  });
  return channels;
}

}  // namespace unietp
