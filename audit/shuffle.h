#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "audit/guess.h"
#include "core/rng.h"

namespace unietp {

/// Among which options values change places.
enum class ShuffleScope : std::uint8_t {
  All,          // all options of the question
  WithinKind,   // those of one kind: what the kind tells stays
  AcrossKinds,  // whole kinds: options of one kind get the value of another
  OfAnyHome,    // each gets the value of an option of its kind in any home (KindPool): what the kind tells stays
  InList,       // a list that goes room by room stays so: the rooms change places, and the things of each; else All
};

/// What may leak in some way: fields of the options that are shuffled together.
struct LeakChannel {
  struct Part {
    ShuffleScope scope = ShuffleScope::All;
    std::vector<float GuessOption::*> fields;
  };
  std::string_view name;  // for people: "order of the list"
  std::vector<Part> parts;
};

/// All options of one choice, in any home, by kind.
using KindPool = std::map<std::uint64_t, std::vector<const GuessOption*>>;
/// The tasks must outlive it.
KindPool pool_of(const std::vector<AuditedTask>& tasks, GuessChoice choice);

/// Makes random permutations of what may leak in a question.
class Shuffler {
 public:
  /// `pool`: of the question's choice; every kind of its options is in it.
  Shuffler(const std::vector<GuessOption>& options, const LeakChannel& channel, const KindPool& pool);
  /// `shuffled` becomes the options with the channel's fields permuted; all other fields must be those of the options.
  void draw(Rng& rng, std::vector<GuessOption>& shuffled);

 private:
  void draw_sources(ShuffleScope scope, Rng& rng);
  void draw_of_any_home(const LeakChannel::Part& part, Rng& rng, std::vector<GuessOption>& shuffled) const;

  const std::vector<GuessOption>& options_;
  const LeakChannel& channel_;
  std::vector<const std::vector<const GuessOption*>*> of_kind_;  // of any home, by option
  std::vector<std::vector<std::size_t>> kinds_;                  // options of each kind
  std::vector<std::vector<std::size_t>> rooms_;  // options of each room, in the order of the list; empty: not by room
  std::vector<std::size_t> listed_;              // options in the order of the list
  std::vector<std::size_t> source_;              // of the present draw: whose value each option gets
  std::vector<std::size_t> order_;
};

}  // namespace unietp
