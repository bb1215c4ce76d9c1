#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "core/result.h"
#include "scene/scene.h"
#include "scene/trace.h"

namespace unietp {

/// "homes/<layout>.scene.json.gz"
std::string home_file(const std::string& layout);

/// The homes of a data set's folder. Each is read at its first use and shared by its tasks; a bounded number of them is
/// kept in memory. Thread-safe.
class HomeCache {
 public:
  explicit HomeCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The home with this name. Errors: Io, Parse, Schema, with the file; Schema also when the file has a different name
  /// in it.
  Result<std::shared_ptr<const Scene>> home(const std::string& layout);
  /// The start scene `id`: the home with `changes`, which were read from `where`. Errors: also those of start_in.
  Result<Scene> start(const std::string& where, const std::string& layout, const Delta& changes, const std::string& id);

 private:
  std::filesystem::path folder_;
  std::mutex mutex_;
  std::map<std::string, Result<std::shared_ptr<const Scene>>> homes_;
  std::deque<std::string> kept_;  // in the order in which they were read
};

}  // namespace unietp
