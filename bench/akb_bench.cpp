// Compiling all knowledge must stay below a second, loading all four simulators from the database below 50 ms. Both are
// measured on the committed tables and on invented ones that are larger, and held against reading the same tables from
// their CSV text without a check (`read_text`): what the simplest program that uses them would pay each time.
#include <benchmark/benchmark.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>

#include "akb/csv.h"
#include "akb/knowledge.h"
#include "akb/table_words.h"
#include "akb/tables.h"
#include "core/files.h"
#include "core/rng.h"

namespace {

using namespace unietp;
/// Processor time of this process, seconds: other work on the machine does not count.
double used() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Rows of one simulator's tables.
struct Size {
  std::size_t categories, affordances, placements, effects, aliases, assets;
};
constexpr std::array<Size, 4> kSizes{{{125, 500, 3000, 1000, 800, 1600},
                                      {181, 700, 4500, 500, 1000, 500},
                                      {389, 1500, 9500, 300, 2000, 300},
                                      {1829, 8000, 45000, 9000, 7000, 9500}}};

/// Tables of a size, with names and sources as long as the real ones.
Tables invented(const Size& size, Rng rng) {
  static const std::vector<std::string> kSources{"curated", "derived:kind", "metadata:object_inventory.json.gz",
                                                 "metadata:propagated_annots_params.json.gz", "derived:archetype"};
  Tables tables;
  const auto source = [&] {
    return Source{kSources[rng.below(kSources.size())], 0.1 * static_cast<double>(1 + rng.below(10))};
  };
  const auto name = [&](std::uint64_t i) {
    return (i % 4 == 0 ? "wooden_thing_for_" : "thing_") + std::to_string(10000 + i);
  };
  const auto any = [&] { return name(rng.below(size.categories)); };
  const auto one_of = [&](const std::vector<std::string>& names) { return names[rng.below(names.size())]; };
  for (std::size_t i = 0; i < size.categories; ++i) {
    Category c;
    c.name = name(i);
    c.display = "wooden thing number " + std::to_string(i);
    c.plural = c.display + "s";
    c.synset = "wooden_thing.n.01";
    c.movable = i % 3 != 0;
    c.size = {0.1 + rng.unit(), 0.1 + rng.unit(), 0.1 + rng.unit()};
    c.mass = 0.1 + rng.unit();
    c.rooms = {"kitchen", "living_room"};
    c.colors = {"red", "green", "blue"};
    c.materials = {"wood"};
    c.source = source(), c.size_source = source(), c.mass_source = source();
    tables.categories.push_back(std::move(c));
  }
  for (std::size_t i = 0; i < size.affordances; ++i)
    tables.affordances.push_back({any(), one_of(affordance_names()), source()});
  for (std::size_t i = 0; i < size.placements; ++i) {
    tables.placements.push_back({any(), *placement_relation_named(one_of(relation_names())), any(),
                                 1e-4 * static_cast<double>(1 + rng.below(9999)), static_cast<int>(1 + rng.below(12)),
                                 source()});
  }
  for (std::size_t i = 0; i < size.effects; ++i) {
    const auto treatment = *treatment_named(one_of(effect_names()));
    tables.effects.push_back({any(),
                              treatment,
                              any(),
                              treatment == Treatment::Slices ? any() : "",
                              4,
                              {EffectNeed::Closed, EffectNeed::PowerOn},
                              source()});
  }
  for (std::size_t i = 0; i < size.aliases; ++i)
    tables.aliases.push_back(
        {any(), "something to use " + std::to_string(i), *alias_kind_named(one_of(alias_kinds())), source()});
  for (std::size_t i = 0; i < size.assets; ++i)
    tables.assets.push_back({"wooden_thing-" + std::to_string(1000000 + i), any(), {0.1, 0.2, 0.3}, source()});
  sort_tables(tables);
  const auto one_a_key = [](auto& rows, const auto& same) {
    rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
  };
  one_a_key(tables.affordances,
            [](const auto& a, const auto& b) { return a.category == b.category && a.affordance == b.affordance; });
  one_a_key(tables.placements, [](const auto& a, const auto& b) {
    return a.object == b.object && a.relation == b.relation && a.receptacle == b.receptacle;
  });
  one_a_key(tables.effects, [](const auto& a, const auto& b) {
    return a.tool == b.tool && a.treatment == b.treatment && a.target == b.target && a.gives == b.gives;
  });
  return tables;
}

/// A folder of tables, and the database that they compile to.
struct Book {
  std::filesystem::path tables, database;
};
enum class Which : std::int64_t { Committed, Invented };

const Book& book(Which which) {
  static const auto folder = std::filesystem::temp_directory_path() / "unietp_akb_bench";
  static const Book kCommitted{std::filesystem::path(UNIETP_SOURCE_DIR) / "data" / "akb", folder / "committed.sqlite"};
  static const Book kInvented = [] {
    const Book made{folder / "invented", folder / "invented.sqlite"};
    for (std::size_t i = 0; i < kSizes.size(); ++i) {
      const auto written =
          write_tables(made.tables / std::string(name_of(kSimulators[i])), invented(kSizes[i], Rng(i)));
      if (!written) throw std::runtime_error(format(written.error()));
    }
    return made;
  }();
  return which == Which::Committed ? kCommitted : kInvented;
}

const Book& compiled(Which which) {
  const Book& made = book(which);
  const auto errors = compile_knowledge(made.tables, made.database);
  if (!errors.empty()) throw std::runtime_error(format(errors.front()));
  return made;
}

/// The baseline: every cell of every table as text. Gives the number of rows.
std::size_t read_text(const Book& made) {
  std::size_t rows = 0;
  for (const auto simulator : kSimulators) {
    for (const auto& table : table_names()) {
      const auto text = read_file(made.tables / std::string(name_of(simulator)) / (table + ".csv"));
      if (!text) throw std::runtime_error(format(text.error()));
      const auto file = read_csv(table, *text);
      benchmark::DoNotOptimize(file);
      rows += file.rows.size();
    }
  }
  return rows;
}

/// Runs `work` in turn with the baseline and says how many times the baseline's time it takes.
template <class Work>
void against_text(benchmark::State& state, const Book& made, const Work& work) {
  double own = 0, text = 0;
  std::size_t rows = 0;
  for (auto _ : state) {
    const double start = used();
    work();
    const double took = used() - start;
    state.SetIterationTime(took);
    own += took;
    const double again = used();
    rows = read_text(made);
    text += used() - again;
  }
  state.counters["rows"] = static_cast<double>(rows);
  state.counters["times_text"] = own / text;
}

void compile_all(benchmark::State& state) {
  const Book& made = book(static_cast<Which>(state.range(0)));
  against_text(state, made, [&] {
    const auto errors = compile_knowledge(made.tables, made.database);
    if (!errors.empty()) state.SkipWithError(format(errors.front()).c_str());
  });
}
BENCHMARK(compile_all)->ArgName("invented")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseManualTime();

void load_all(benchmark::State& state) {
  const Book& made = compiled(static_cast<Which>(state.range(0)));
  against_text(state, made, [&] {
    for (const auto simulator : kSimulators) {
      auto knowledge = load_knowledge(made.database, simulator);
      if (!knowledge) state.SkipWithError(format(knowledge.error()).c_str());
      benchmark::DoNotOptimize(knowledge);
    }
  });
}
BENCHMARK(load_all)->ArgName("invented")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseManualTime();

void load_one(benchmark::State& state) {
  const Book& made = compiled(Which::Invented);
  for (auto _ : state) {
    auto knowledge = load_knowledge(made.database, kSimulators[static_cast<std::size_t>(state.range(0))]);
    if (!knowledge) state.SkipWithError(format(knowledge.error()).c_str());
    benchmark::DoNotOptimize(knowledge);
  }
}
BENCHMARK(load_one)->ArgName("simulator")->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

void digest(benchmark::State& state) {
  const Book& made = book(static_cast<Which>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(digest_of_tables(made.tables));
}
BENCHMARK(digest)->ArgName("invented")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void queries(benchmark::State& state) {
  const Book& made = compiled(static_cast<Which>(state.range(0)));
  const auto knowledge = load_knowledge(made.database, Simulator::Behavior);
  if (!knowledge) return state.SkipWithError(format(knowledge.error()).c_str());
  const auto& categories = knowledge->categories();
  const auto& placements = knowledge->placements();
  std::int64_t asked = 0;
  for (auto _ : state) {
    for (std::size_t i = 0; i < categories.size(); ++i) {
      const auto& name = categories[i].name;
      const auto& row = placements[i * 7919 % placements.size()];
      benchmark::DoNotOptimize(knowledge->find(name));
      benchmark::DoNotOptimize(knowledge->has(name, "pickupable"));
      benchmark::DoNotOptimize(knowledge->placement(row.object, row.relation, row.receptacle));
      benchmark::DoNotOptimize(knowledge->placements_at(name, Predicate::On));
    }
    asked += static_cast<std::int64_t>(4 * categories.size());
  }
  state.SetItemsProcessed(asked);
}
BENCHMARK(queries)->ArgName("invented")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
