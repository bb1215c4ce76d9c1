#include "validator/home_check.h"

#include <algorithm>
#include <optional>

#include "core/digest.h"
#include "core/files.h"
#include "core/share_work.h"
#include "record/home_cache.h"
#include "record/recorded_words.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

/// What is wrong with a home's file; nullopt when nothing is, or what is wrong is reported where it is read.
std::optional<std::string> home_fault(const std::string& name, const std::string& packed,
                                      const ManifestRecord& manifest, const ValidationOptions& options) {
  const auto unpacked = gunzip(name, packed);
  if (!unpacked) return std::nullopt;
  const std::string& text = *unpacked;
  if (gzip(text) != packed) return "is not packed as this program does: its header or a further part may say anything";
  const auto& given = manifest.run.scenes;
  if (!given.empty()) {
    if (std::find(given.begin(), given.end(), name + " " + sha256(text)) != given.end()) return std::nullopt;
    return "is not one of the homes that the configuration was given";
  }
  const auto known = options.known_homes.find(name);
  if (recorded_homes(manifest.run.homes) == RecordedHomes::Benchmark && known != options.known_homes.end() &&
      known->second == sha256(text))
    return std::nullopt;
  if (!options.make_home) return std::nullopt;
  const auto home = options.make_home(manifest, name);
  if (!home) return "cannot be made again: " + home.error().message;
  if (scene_to_json(*home) == text) return std::nullopt;
  return "differs from the home that the configuration gives under this name";
}

}  // namespace

ProblemList check_homes(const std::filesystem::path& folder, const ManifestRecord& manifest,
                        const std::vector<std::string>& used, const ValidationOptions& options) {
  std::vector<std::optional<std::string>> faults(used.size());
  share_work(options.threads, used.size(), [&](std::size_t i) {
    const auto packed = read_file(folder, home_file(used[i]));
    if (packed) faults[i] = home_fault(used[i], *packed, manifest, options);
  });
  ProblemList problems;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (faults[i]) problems.add(problem_in(ProblemKind::HomeFile, home_file(used[i]), *faults[i]));
  }
  for (const auto& [path, unused] : manifest.files) {
    const bool home = path.starts_with("homes/");
    if (home &&
        std::none_of(used.begin(), used.end(), [&, &path = path](const auto& name) { return path == home_file(name); }))
      problems.add(problem_in(ProblemKind::HomeFile, path, "is the home of no task"));
  }
  return problems;
}

}  // namespace unietp
