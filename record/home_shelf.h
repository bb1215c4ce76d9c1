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

/// The homes of a data set's folder: each is read when it is first asked for, and then shared by all tasks in it. Only
/// so many are kept, so that memory does not grow with the data set. Safe from several threads.
class HomeShelf {
 public:
  explicit HomeShelf(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Errors: Io, Parse, Schema, the file named; Schema also when it is the home of another name.
  Result<std::shared_ptr<const Scene>> home(const std::string& layout);
  /// The start called `id` that `changes` make of the home; `where` they were read. Errors: also those of start_in.
  Result<Scene> start(const std::string& where, const std::string& layout, const Delta& changes, const std::string& id);

 private:
  std::filesystem::path folder_;
  std::mutex mutex_;
  std::map<std::string, Result<std::shared_ptr<const Scene>>> homes_;
  std::deque<std::string> kept_;  // in the order in which they were read
};

}  // namespace unietp
