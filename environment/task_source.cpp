#include "environment/task_source.h"

#include <array>
#include <deque>
#include <map>
#include <mutex>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "core/in_quotes.h"
#include "core/rng.h"
#include "core/text.h"
#include "grounding/home.h"
#include "record/dataset_lines.h"
#include "record/dataset_reader.h"
#include "record/home_cache.h"
#include "record/line_index.h"
#include "scene/start.h"

namespace unietp {
namespace {

/// The last few values that were made, by key. Thread-safe.
template <class Key, class Value>
class RecentValues {
 public:
  explicit RecentValues(std::size_t most) : most_(most) {}

  std::optional<Value> find(const Key& key) const {
    const std::scoped_lock lock(mutex_);
    const auto found = values_.find(key);
    return found == values_.end() ? std::nullopt : std::optional(found->second);
  }
  void keep(const Key& key, const Value& value) {
    if (most_ == 0) return;
    const std::scoped_lock lock(mutex_);
    if (values_.emplace(key, value).second) order_.push_back(key);
    if (order_.size() <= most_) return;
    values_.erase(order_.front());
    order_.pop_front();
  }

 private:
  mutable std::mutex mutex_;
  std::map<Key, Value> values_;
  std::deque<Key> order_;
  std::size_t most_;
};

TaskListing listing_of(const TaskRecord& record) {
  TaskListing listing{
      record.id, record.split, record.template_name, record.simulator, record.layout, record.instruction, {}};
  for (const TaskRecord::Count& count : record.expert) listing.modes.push_back(count.mode);
  return listing;
}

}  // namespace

struct TaskSource::Impl {
  Impl(const std::filesystem::path& folder, AllSimulatorData all, LineIndex lines, const Kept& kept)
      : data(std::move(all)), tasks(std::move(lines)), homes(folder), prepared(kept.homes), ready(kept.tasks) {}

  Result<TaskRecord> record(std::size_t position) const;
  Result<std::shared_ptr<const Home>> home(const std::string& layout, Simulator simulator);
  Result<SharedTask> make(std::size_t position);

  AllSimulatorData data;
  LineIndex tasks;
  std::vector<Mode> modes;
  std::array<std::optional<LineIndex>, kModes.size()> shown;
  HomeCache homes;
  std::vector<TaskListing> listing;
  std::unordered_map<std::string, std::size_t> by_id;  // never iterated
  RecentValues<std::string, std::shared_ptr<const Home>> prepared;
  RecentValues<std::size_t, SharedTask> ready;
};

Result<TaskRecord> TaskSource::Impl::record(std::size_t position) const {
  const auto line = tasks.line(position);
  if (!line) return line.error();
  auto record = read_task(tasks.name(), line->number, line->text);
  if (record && record->id != listing[position].id)
    return Error{Error::Kind::Io, tasks.name(), {}, "has changed since it was opened"};
  return record;
}

Result<std::shared_ptr<const Home>> TaskSource::Impl::home(const std::string& layout, Simulator simulator) {
  if (auto found = prepared.find(layout)) return *found;
  const auto scene = homes.home(layout);
  if (!scene) return scene.error();
  if ((*scene)->simulator != simulator)
    return Error{
        Error::Kind::Schema,
        home_file(layout),
        {},
        "is a home of " + std::string(name_of((*scene)->simulator)) + ", not of " + std::string(name_of(simulator))};
  const Profile& profile = *data[static_cast<std::size_t>(simulator)].profile;
  auto home = std::make_shared<const Home>(prepare_home(**scene, profile));
  prepared.keep(layout, home);
  return home;
}

Result<SharedTask> TaskSource::Impl::make(std::size_t position) {
  auto record = this->record(position);
  if (!record) return record.error();
  const std::string where = tasks.name() + ":" + std::to_string(position + 1);
  const auto simulator = simulator_named(record->simulator);
  if (!simulator) return Error{Error::Kind::Schema, where, {}, "has the unknown simulator " + record->simulator};
  const auto home = this->home(record->layout, *simulator);
  if (!home) return home.error();
  auto start = start_in(where, (*home)->scene, record->changes, record->scene);
  if (!start) return start.error();
  if (auto fine = check_combinations(where, record->goal_tree, *start); !fine) return fine.error();
  TaskText text{record->id,     record->instruction, record->split, record->template_name,
                record->layout, record->goal_text,   record->expert};
  return prepare_task(std::move(text), std::move(*start), data[static_cast<std::size_t>(*simulator)], **home);
}

Result<TaskSource> TaskSource::open(const std::filesystem::path& folder, const AllSimulatorData& data, Kept kept) {
  std::vector<TaskListing> listing;
  std::unordered_map<std::string, std::size_t> by_id;
  const std::string shown = (folder / kTasksFile).string();
  auto tasks = LineIndex::open(folder, kTasksFile, FileNames::WithFolder, [&](const FileLine& line) -> Result<Done> {
    const auto record = read_task(shown, line.number, line.text);
    if (!record) return record.error();
    if (!by_id.emplace(record->id, listing.size()).second)
      return Error{Error::Kind::Schema,
                   shown + ":" + std::to_string(line.number),
                   {},
                   "a task before it has the id " + record->id + " too"};
    listing.push_back(listing_of(*record));
    return Done{};
  });
  if (!tasks) return tasks.error();
  TaskSource source;
  source.impl_ = std::make_shared<Impl>(folder, data, std::move(*tasks), kept);
  source.impl_->modes = shown_modes(folder);
  for (const Mode mode : source.impl_->modes) {
    auto lines = LineIndex::open(folder, demonstrations_file(mode), FileNames::WithFolder);
    if (!lines) return lines.error();
    source.impl_->shown[static_cast<std::size_t>(mode)].emplace(std::move(*lines));
  }
  source.impl_->listing = std::move(listing);
  source.impl_->by_id = std::move(by_id);
  return source;
}

std::size_t TaskSource::size() const { return impl_->listing.size(); }
const std::vector<TaskListing>& TaskSource::listing() const { return impl_->listing; }
const std::vector<Mode>& TaskSource::modes() const { return impl_->modes; }

std::optional<std::size_t> TaskSource::find(std::string_view id) const {
  const auto found = impl_->by_id.find(std::string(id));
  return found == impl_->by_id.end() ? std::nullopt : std::optional(found->second);
}

Result<SharedTask> TaskSource::task(std::size_t position) const {
  if (position >= size())
    return Error{Error::Kind::Usage,
                 impl_->tasks.name(),
                 {},
                 "the data set has " + std::to_string(size()) + " tasks, counted from 0; there is none at " +
                     std::to_string(position)};
  if (auto found = impl_->ready.find(position)) return *found;
  auto made = impl_->make(position);
  if (made) impl_->ready.keep(position, *made);
  return made;
}

Result<SharedTask> TaskSource::task(std::string_view id) const {
  if (const auto position = find(id)) return task(*position);
  std::vector<std::string> ids;
  for (const TaskListing& one : listing()) ids.push_back(one.id);
  const std::string near = nearest_name(id, ids);
  return Error{Error::Kind::Usage,
               impl_->tasks.name(),
               {},
               "the data set has no task " + in_quotes(id) + (near.empty() ? "" : ", did you mean " + near + "?")};
}

template <class Record>
Result<Record> TaskSource::shown(std::size_t position, Mode mode,
                                 Result<Record> (*read)(std::string_view where, int line,
                                                        std::string_view text)) const {
  if (position >= size())
    return Error{
        Error::Kind::Usage, impl_->tasks.name(), {}, "the data set has no task at " + std::to_string(position)};
  const auto& lines = impl_->shown[static_cast<std::size_t>(mode)];
  const std::string& id = listing()[position].id;
  if (!lines || position >= lines->size())
    return Error{Error::Kind::Usage,
                 impl_->tasks.name(),
                 {},
                 "the data set has no demonstration of " + id + " in " + std::string(name_of(mode))};
  const auto line = lines->line(position);
  if (!line) return line.error();
  auto shown = read(lines->name(), line->number, line->text);
  if (shown && shown->task != id)
    return Error{Error::Kind::Schema,
                 lines->name() + ":" + std::to_string(line->number),
                 {},
                 "expected the demonstration of " + id + ", not of " + shown->task};
  return shown;
}

Result<DemonstrationRecord> TaskSource::demonstration(std::size_t position, Mode mode) const {
  return shown(position, mode, &read_demonstration);
}

Result<std::vector<Command>> TaskSource::demonstrated_plan(std::size_t position, Mode mode) const {
  auto plan = shown(position, mode, &read_demonstrated_plan);
  if (!plan) return plan.error();
  return std::move(plan->commands);
}

std::vector<std::size_t> TaskSource::order(std::uint64_t seed) const {
  std::vector<std::size_t> positions(size());
  std::iota(positions.begin(), positions.end(), std::size_t{0});
  Rng(seed).fork("order of tasks", 0).shuffle(positions);
  return positions;
}

}  // namespace unietp
