#include "run/make_home.h"

#include <charconv>
#include <string>

#include "grounding/layout.h"

namespace unietp {
namespace {

constexpr std::uint64_t kTriesPerLayout = 8;

std::string layout_id(Simulator simulator, int index) {
  auto digits = std::to_string(index + 1);
  digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
  return std::string(name_of(simulator)) + "-home-" + digits;
}

Error no_home_of_the_run(std::string_view name) {
  return {Error::Kind::Usage, std::string(name), {}, "is not the name of a home that the configuration gives"};
}

Result<Scene> draw_home(const RunConfiguration& configuration, const Resources& resources, Simulator simulator,
                        int number) {
  const auto& backend = resources.backend(simulator);
  LayoutOptions options;
  options.rooms = configuration.rooms;
  options.movable_objects = configuration.objects;
  const Rng stream = Rng(configuration.seed).fork("layout", static_cast<std::uint64_t>(simulator));
  Error last;
  for (std::uint64_t attempt = 0; attempt < kTriesPerLayout; ++attempt) {
    auto scene = generate_layout(resources.recipe(simulator), backend.knowledge, backend.profile, options,
                                 layout_id(simulator, number),
                                 stream.fork("home", static_cast<std::uint64_t>(number) * kTriesPerLayout + attempt));
    if (scene) return scene;
    last = scene.error();
  }
  return last;
}

Result<Scene> benchmark_home(const Resources& resources, Simulator simulator, int number) {
  int passed = 0;
  for (const BenchmarkLayout& layout : resources.benchmark) {
    if (layout.simulator != simulator || passed++ != number) continue;
    const auto& backend = resources.backend(simulator);
    return benchmark_layout(layout, resources.recipe(simulator), backend.knowledge, backend.profile);
  }
  return Error{Error::Kind::Usage,
               "benchmark.csv",
               {},
               "has no home number " + std::to_string(number + 1) + " of " + std::string(name_of(simulator))};
}

}  // namespace

Result<Scene> make_home(const RunConfiguration& configuration, const Resources& resources, Simulator simulator,
                        int number) {
  const auto& backend = resources.backend(simulator);
  switch (configuration.homes) {
    case HomeSource::Drawn:
      return draw_home(configuration, resources, simulator, number);
    case HomeSource::Benchmark:
      return benchmark_home(resources, simulator, number);
    case HomeSource::Training:
      return training_layout(resources.recipe(simulator), backend.knowledge, backend.profile,
                             static_cast<std::uint64_t>(number), configuration.seed);
  }
  return draw_home(configuration, resources, simulator, number);
}

Result<std::pair<Simulator, int>> home_number(const RunConfiguration& configuration, const Resources& resources,
                                              std::string_view name) {
  for (const Simulator simulator : kSimulators) {
    if (configuration.homes == HomeSource::Benchmark) {
      int number = 0;
      for (const BenchmarkLayout& layout : resources.benchmark) {
        if (layout.simulator != simulator) continue;
        if (layout.id == name) return std::pair(simulator, number);
        ++number;
      }
      continue;
    }
    const std::string prefix(std::string(name_of(simulator)) + "-");
    if (!name.starts_with(prefix)) continue;
    const std::string_view digits = name.substr(name.find_last_of('-') + 1);
    int number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size()) break;
    if (configuration.homes == HomeSource::Drawn) --number;  // they are counted from 1
    if (number < 0) break;
    return std::pair(simulator, number);
  }
  return no_home_of_the_run(name);
}

Result<Scene> make_home(const RunConfiguration& configuration, const Resources& resources, std::string_view name) {
  const auto number = home_number(configuration, resources, name);
  if (!number) return number.error();
  auto home = make_home(configuration, resources, number->first, number->second);
  if (!home || home->id == name) return home;
  return no_home_of_the_run(name);
}

}  // namespace unietp
