#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "dataset/balance.h"
#include "run/category_weights.h"
#include "run/layout_pool.h"
#include "run/slots.h"

namespace unietp {

/// Template, home and binding of a candidate, chosen before the expensive stages run.
struct CandidatePlan {
  int slot = 0, attempt = 0;
  std::size_t source = 0;           // position in Resources::templates
  int home = 0;                     // in the layout pool
  std::optional<Binding> binding;   // nullopt: none of the homes that were tried offers one
  Grade least = Grade::Usual;       // sense that the task has to make
  std::optional<Style> style = {};  // of a slot of the Linguistic split: the phenomenon; nullopt: any
  bool operator==(const CandidatePlan&) const = default;
};

/// Chooses templates, homes and categories so that the data set is balanced over templates, categories, receptacles,
/// rooms and homes: each is drawn by inverse frequency among the tasks taken so far and the candidates planned before
/// it in the same round. A slot keeps its first template for a few attempts, and for more while no task has that one,
/// or until no home offers it a binding or it is dropped, then takes one that it has not tried, if possible one that no
/// task has; a slot of the Linguistic split keeps its phenomenon for a few templates, then takes its next. Where homes
/// are given (Resources::homes), what they have is all there is: a slot passes over templates that no home offers a
/// binding, without a candidate, until all had their turn.
///
/// Plans depend on the configuration and on the earlier rounds only: equal rounds give equal plans for any threads.
class CandidatePlanner {
 public:
  /// The slots (a block's: numbered one after the other) and what they were planned from must outlive it.
  CandidatePlanner(const RunConfiguration& configuration, const Resources& resources, LayoutPool& layouts,
                   const std::vector<TaskSlot>& slots);

  /// The last candidate of the slot was rejected for what the next one of its template would be rejected for, too: the
  /// slot takes another template next.
  void drop_template(int slot) { turn_of(slot).left = turn_of(slot).more = 0; }

  /// One candidate for each open slot, in ascending order. Rounds must be asked for in order of attempt, without gaps.
  std::vector<CandidatePlan> round(const std::vector<int>& open, int attempt, const Frequencies& taken);

  /// The frequencies as the last round left them, its candidates included.
  const Frequencies& counts() const { return counts_; }

  static constexpr int kAttemptsPerTemplate = 3;
  /// Further ones with a slot's first template while no task has it and no other slot tries it.
  static constexpr int kAttemptsForUnused = 12;
  static constexpr int kTemplatesPerStyle = 4;
  /// The share of a slot's attempts after which tolerable tasks will do where usual ones were asked for.
  static constexpr double kPatience = 0.75;

 private:
  /// The template that a slot currently uses, and those that it has used.
  struct Turn {
    std::size_t source = 0;
    int left = 0;                    // further attempts with it
    int more = 0;                    // and these with the first one, while no task has it
    std::vector<std::size_t> tried;  // templates, the current one included
    int drawn = 0;                   // templates so far
  };
  Turn& turn_of(int slot) { return turns_[static_cast<std::size_t>(slot - slots_.front().index)]; }
  static std::optional<Style> style_of(const TaskSlot& slot, int drawn);
  /// A candidate of the template that the slot has or takes next; the one looked at as number `look` for it.
  CandidatePlan next_candidate(const TaskSlot& slot, int attempt, std::size_t look);
  std::size_t next_template(const TaskSlot& slot, Turn& turn, const Frequencies& counts, Rng rng) const;
  Grade least_of(const TaskSlot& slot, std::size_t source, int attempt) const;
  void choose_home(CandidatePlan& plan, const TaskSlot& slot, Frequencies& counts, const Rng& rng);
  std::optional<Binding> draw_binding(const CandidatePlan& plan, const TaskSlot& slot, const Frequencies& counts,
                                      Rng rng);
  void count(const CandidatePlan& plan, const TaskSlot& slot, Frequencies& counts);
  const RoomTypes& rooms_of(Simulator simulator, int home, const Layout& layout);

  const RunConfiguration& configuration_;
  const Resources& resources_;
  LayoutPool& layouts_;
  const std::vector<TaskSlot>& slots_;
  std::vector<std::vector<Style>> styles_;  // of each template
  std::vector<Turn> turns_;
  Frequencies counts_;
  std::map<std::pair<Simulator, int>, int> tried_;  // candidates planned in a home in earlier rounds
  std::map<std::pair<Simulator, int>, RoomTypes> rooms_;
  /// Template, home, grade and style: no binding was found.
  std::set<std::tuple<std::size_t, Simulator, int, Grade, std::optional<Style>>> barren_;
};

}  // namespace unietp
