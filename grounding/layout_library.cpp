#include "grounding/layout_library.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <set>

#include "akb/knowledge.h"
#include "akb/row_reader.h"
#include "core/files.h"

namespace unietp {
namespace {

const std::vector<std::string> kColumns{"id", "simulator", "seed", "rooms", "objects"};
constexpr int kTries = 8;  // streams tried for one home before its error is given

std::optional<std::uint64_t> whole(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || failed != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::uint64_t whole_in(RowReader& reader, std::string_view column, std::uint64_t low, std::uint64_t high) {
  const auto value = whole(reader.text(column));
  if (value && *value >= low && *value <= high) return *value;
  reader.fail(column, "expected a whole number from " + std::to_string(low) + " to " + std::to_string(high) +
                          ", got '" + reader.text(column) + "'");
  return low;
}

Result<Scene> first_of(const LayoutRecipe& recipe, const Knowledge& knowledge, const Profile& profile,
                       const LayoutOptions& options, const std::string& id, const Rng& stream) {
  Error last;
  for (std::uint64_t attempt = 0; attempt < kTries; ++attempt) {
    auto home = generate_layout(recipe, knowledge, profile, options, id, stream.fork("attempt", attempt));
    if (home) return home;
    last = home.error();
  }
  return last;
}

}  // namespace

BenchmarkTable read_benchmark(std::string_view where, std::string_view text) {
  BenchmarkTable table;
  std::vector<std::string> simulators;
  for (const Simulator simulator : kSimulators) simulators.emplace_back(name_of(simulator));
  RowReader reader(std::string(where), text, kColumns, table.errors);
  std::set<std::string> ids;
  std::set<std::pair<std::string, std::uint64_t>> seeds;
  for (const CsvRow& row : reader.rows()) {
    reader.at(row);
    BenchmarkLayout layout;
    layout.id = reader.required("id");
    const std::string simulator = reader.one_of("simulator", simulators, "simulator");
    layout.seed = whole_in(reader, "seed", 0, UINT64_MAX);
    layout.rooms = static_cast<int>(whole_in(reader, "rooms", 4, 12));
    layout.objects = static_cast<int>(whole_in(reader, "objects", 50, 600));
    if (!reader.sound()) continue;
    layout.simulator = *simulator_named(simulator);
    if (!ids.insert(layout.id).second) reader.fail("id", "'" + layout.id + "' is duplicated; expected a new id");
    if (!seeds.insert({simulator, layout.seed}).second) {
      reader.fail("seed", "is duplicated for " + simulator + "; expected a different seed for each layout");
    }
    if (reader.sound()) table.layouts.push_back(std::move(layout));
  }
  return table;
}

Result<std::vector<BenchmarkLayout>> benchmark_layouts(const std::filesystem::path& folder) {
  const auto text = read_file(folder / "benchmark.csv");
  if (!text) return text.error();
  BenchmarkTable table = read_benchmark("benchmark.csv", *text);
  if (!table.errors.empty()) return table.errors.front();
  return std::move(table.layouts);
}

Result<Scene> benchmark_layout(const BenchmarkLayout& layout, const LayoutRecipe& recipe, const Knowledge& knowledge,
                               const Profile& profile) {
  LayoutOptions options;
  options.rooms = layout.rooms;
  options.objects = layout.objects;
  const Rng stream = Rng(layout.seed).fork("benchmark-layout", static_cast<std::uint64_t>(layout.simulator));
  return first_of(recipe, knowledge, profile, options, layout.id, stream);
}

Result<Scene> training_layout(const LayoutRecipe& recipe, const Knowledge& knowledge, const Profile& profile,
                              std::uint64_t n, std::uint64_t seed) {
  const Simulator simulator = knowledge.simulator();
  const Rng stream = Rng(seed).fork("training-layout", static_cast<std::uint64_t>(simulator)).fork("home", n);
  Rng draw = stream.fork("size", 0);
  LayoutOptions options;
  const HomeScale& scale = recipe.scale;
  const int sizes = scale.most_rooms - scale.fewest_rooms + 1;
  options.rooms = scale.fewest_rooms + static_cast<int>(draw.below(static_cast<std::uint64_t>(sizes)));
  options.objects = static_cast<int>(std::lround(scale.objects_a_room * options.rooms));
  const std::string id =
      std::string(name_of(simulator)) + "-training-" + std::to_string(seed) + "-" + std::to_string(n);
  return first_of(recipe, knowledge, profile, options, id, stream);
}

}  // namespace unietp
