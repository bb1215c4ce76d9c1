#pragma once

#include <cstddef>
#include <cstdint>
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

/// Makes random permutations of what may leak in a question.
class Shuffler {
 public:
  Shuffler(const std::vector<GuessOption>& options, const LeakChannel& channel);
  /// `shuffled` becomes the options with the channel's fields permuted; all other fields must be those of the options.
  void draw(Rng& rng, std::vector<GuessOption>& shuffled);

 private:
  void draw_sources(ShuffleScope scope, Rng& rng);

  const std::vector<GuessOption>& options_;
  const LeakChannel& channel_;
  std::vector<std::vector<std::size_t>> kinds_;  // options of each kind
  std::vector<std::vector<std::size_t>> rooms_;  // options of each room, in the order of the list; empty: not by room
  std::vector<std::size_t> listed_;              // options in the order of the list
  std::vector<std::size_t> source_;              // of the present draw: whose value each option gets
  std::vector<std::size_t> order_;
};

}  // namespace unietp
