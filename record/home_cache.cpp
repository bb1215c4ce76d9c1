#include "record/home_cache.h"

#include "core/files.h"
#include "scene/json_parse.h"
#include "scene/scene_json.h"
#include "scene/start.h"

namespace unietp {
namespace {

constexpr std::size_t kMostHomes = 256;  // some 200 kB each

Result<std::shared_ptr<const Scene>> read_home(const std::filesystem::path& folder, const std::string& layout) {
  const auto file = home_file(layout);
  const auto text = read_maybe_gzip(folder, file);
  if (!text) {
    Error error = text.error();
    error.where = file;
    return error;
  }
  auto scene = scene_from_json(file, *text);
  if (!scene) return scene.error();
  if (scene->id != layout)
    return Error{Error::Kind::Schema, file, {}, "is called " + in_quotes(scene->id) + ", not " + in_quotes(layout)};
  return std::make_shared<const Scene>(std::move(*scene));
}

}  // namespace

std::string home_file(const std::string& layout) { return "homes/" + layout + ".scene.json.gz"; }

Result<std::shared_ptr<const Scene>> HomeCache::home(const std::string& layout) {
  {
    const std::scoped_lock lock(mutex_);
    if (const auto found = homes_.find(layout); found != homes_.end()) return found->second;
  }
  auto home = read_home(folder_, layout);  // perhaps by two threads at once: to the same
  const std::scoped_lock lock(mutex_);
  if (homes_.emplace(layout, home).second) kept_.push_back(layout);
  if (kept_.size() > kMostHomes) {
    homes_.erase(kept_.front());
    kept_.pop_front();
  }
  return home;
}

Result<Scene> HomeCache::start(const std::string& where, const std::string& layout, const Delta& changes,
                               const std::string& id) {
  const auto found = home(layout);
  if (!found) return found.error();
  return start_in(where, **found, changes, id);
}

}  // namespace unietp
