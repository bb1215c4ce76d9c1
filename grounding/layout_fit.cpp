#include "grounding/layout_fit.h"

#include <algorithm>
#include <cmath>

#include "akb/csv.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

Result<FitInput> input_of(const std::filesystem::path& upstream, const std::filesystem::path& curated,
                          const Knowledge& knowledge) {
  auto homes = upstream_homes(upstream, curated, knowledge);
  if (!homes) return homes.error();
  FitInput input{&knowledge, std::move(*homes), {}};
  input.statistics = statistics_of(input.homes.homes, input.homes.source);
  // A scene of iTHOR is a single room: how many rooms of which type make a home, whole houses say.
  const SceneStatistics whole = statistics_of(input.homes.whole, input.homes.room_source);
  double objects = 0;
  for (const auto& [type, number] : whole.rooms_of_type) {
    const auto each = input.statistics.objects_in.find(type);
    if (each != input.statistics.objects_in.end()) objects += number * each->second;
  }
  input.statistics.rooms_of_type = whole.rooms_of_type;
  input.statistics.rooms_per_home = whole.rooms_per_home;
  input.statistics.objects_per_home = objects;
  return input;
}

}  // namespace

std::string rounded_text(double value, double per_unit) { return number_text(std::round(value * per_unit) / per_unit); }

Result<std::vector<FittedFile>> fit_layouts(const std::filesystem::path& upstream, const std::filesystem::path& curated,
                                            std::span<const Knowledge> knowledge) {
  std::vector<FitInput> inputs;
  for (const Knowledge& one : knowledge) {
    auto input = input_of(upstream, curated, one);
    if (!input) return input.error();
    inputs.push_back(std::move(*input));
  }
  std::vector<FittedFile> files;
  for (const FitInput& own : inputs) {
    const std::string name(name_of(own.knowledge->simulator()));
    auto furniture = fit_furniture(own, curated);
    if (!furniture) return furniture.error();
    auto rooms = fit_rooms(own, curated);
    if (!rooms) return rooms.error();
    files.push_back({name + ".csv", std::move(*furniture)});
    files.push_back({name + "_rooms.csv", std::move(*rooms)});
    files.push_back({name + "_objects.csv", fit_objects(own, inputs)});
    files.push_back({name + "_receptacles.csv", fit_receptacles(own, inputs)});
    if (!own.homes.homes.empty()) {
      files.push_back({"reference_" + name + ".json", statistics_to_json(own.statistics)});
    }
  }
  return files;
}

Result<Done> fit_layouts_into(const std::filesystem::path& folder, const std::filesystem::path& upstream,
                              const std::filesystem::path& curated, std::span<const Knowledge> knowledge) {
  const auto files = fit_layouts(upstream, curated, knowledge);
  if (!files) return files.error();
  for (const FittedFile& file : *files) {
    if (auto written = write_file(folder / file.name, file.text); !written) return written;
  }
  return Done{};
}

}  // namespace unietp
