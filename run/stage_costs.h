#pragma once

#include <array>
#include <chrono>
#include <string_view>

namespace unietp {

/// What a run spends its time on. Homes: once per home; Planning: once per round of candidates; Dataset: once at the
/// end; the others: once per candidate.
enum class Stage {
  Homes,
  Planning,
  Generator,
  Grounding,
  Expert,
  Mutations,
  Annotator,
  OtherModes,
  Writing,
  Ledger,
  Dataset
};
/// Number of stages.
inline constexpr std::size_t kStageCount = static_cast<std::size_t>(Stage::Dataset) + 1;
/// "other_modes"; as in the ledger and in benchmarks.
std::string_view name_of(Stage stage);

/// Wall-clock seconds spent by stage, summed over threads. For benchmarks and progress only; never reaches an
/// output.
struct StageCosts {
  std::array<double, kStageCount> seconds{};
  /// Sums stage by stage.
  void add(const StageCosts& other);
};

/// Adds the time since it was made, or since the last `enter`, to a stage's cost until it is stopped. `costs` may be
/// null.
class StageTimer {
 public:
  StageTimer(StageCosts* costs, Stage stage) : costs_(costs), stage_(stage), start_(Clock::now()) {}
  ~StageTimer() { stop(); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;
  /// From now on time counts for this stage.
  void enter(Stage stage) {
    add_elapsed();
    stage_ = stage;
  }
  /// Time no longer counts; the destructor does the same.
  void stop() {
    add_elapsed();
    costs_ = nullptr;
  }

 private:
  using Clock = std::chrono::steady_clock;
  void add_elapsed();
  StageCosts* costs_;
  Stage stage_;
  Clock::time_point start_;
};

}  // namespace unietp
