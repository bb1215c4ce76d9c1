#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "annotator/instruction.h"
#include "core/result.h"
#include "generator/specification.h"
#include "scene/action.h"
#include "scene/simulator.h"
#include "sense/evidence.h"
#include "templates/template.h"

namespace unietp {

/// Where the homes of a run come from if none are given: generated in the requested size, the benchmark's own, or the
/// training pool, which has no home in common with the benchmark.
enum class HomeSource { Drawn, Benchmark, Training };
inline constexpr std::array kHomeSources{HomeSource::Drawn, HomeSource::Benchmark, HomeSource::Training};
std::string_view name_of(HomeSource source);  // "benchmark"

/// In the order of the enumeration.
inline constexpr std::array kPhrasings{Phrasings::Everyday, Phrasings::All, Phrasings::Training, Phrasings::Benchmark};
std::string_view name_of(Phrasings phrasings);  // "training"
/// nullopt for another word.
std::optional<Phrasings> phrasings_named(std::string_view name);

/// In the order of the enumeration.
inline constexpr std::array kEnglishes{English::Us, English::Gb};
std::string_view name_of(English english);  // "us"

/// The least sense that tasks are to make, in the words of `--sense`: "usual", "tolerable", "any" for Senseless.
std::string_view name_of_least(Grade grade);

/// Number of tasks per split and per simulator. Both empty (equal shares), or both with the same sum, the run's count.
struct Quotas {
  std::vector<std::pair<Split, int>> splits;
  std::vector<std::pair<Simulator, int>> simulators;
  bool empty() const { return splits.empty() && simulators.empty(); }
  bool operator==(const Quotas&) const = default;
};

/// The settings that determine a data set, together with the program's version and the knowledge digest. Threads and
/// folders do not change the result and are not part of it.
struct RunConfiguration {
  int count = 40;
  std::uint64_t seed = 1;
  std::vector<Simulator> simulators{kSimulators.begin(), kSimulators.end()};
  std::vector<Split> splits;           // empty: every split that some template can fill
  Quotas quotas;                       // in place of equal shares
  std::vector<std::string> templates;  // names; empty: all that the library has
  std::vector<std::string> without;    // names of templates that are left out
  bool extended = false;               // the library holds the extended templates too
  std::vector<std::string> own;        // the user's own templates in it, "<name> <sha256>"
  Binding binding;                     // placeholders that are not drawn, of the one template named
  std::vector<Mode> modes{Mode::M1};   // that each task is demonstrated in, in order; M1 is always among them
  int attempts = 60;                   // candidates tried for one task before it is given up
  int block = 256;                     // tasks planned together (blocks.h), > 0
  HomeSource homes = HomeSource::Drawn;
  int rooms = 6;                    // of a drawn home
  int objects = 60;                 // movable ones asked for in a drawn home
  std::vector<std::string> scenes;  // given homes, "<id> <sha256>"; empty: homes are drawn
  bool native = false;              // only tasks that their simulators can express, in scenes of their own
  Phrasings phrasings = Phrasings::Everyday;
  English english = English::Us;
  Grade sense = Grade::Usual;  // at least; where a template has nothing so good, its tasks are the best that it has
  bool operator==(const RunConfiguration&) const = default;
};

/// All five splits in the order of the enum.
const std::vector<Split>& all_splits();

/// Names separated by commas; sorted as the enum and without repeats.
/// Errors: Usage naming `option`, the unknown name, the nearest known one and all that are accepted.
Result<std::vector<Simulator>> parse_simulators(std::string_view option, std::string_view text);
Result<std::vector<Split>> parse_splits(std::string_view option, std::string_view text);

/// Errors: Usage naming `option` and what is accepted.
Result<Grade> parse_sense(std::string_view option, std::string_view text);

/// As above.
Result<std::vector<Mode>> parse_modes(std::string_view option, std::string_view text);
/// As above, of modes to make demonstrations in: M1 comes with the others, since their plans begin with it.
Result<std::vector<Mode>> parse_modes_to_make(std::string_view option, std::string_view text);

}  // namespace unietp
