#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace unietp {

/// The choices of one reading, where words have more than one meaning: "it" after two objects, a name of two
/// categories. Reading a text again after each `next()` gives all its readings, the likeliest first.
class WordChoices {
 public:
  /// One of `count` alternatives, at least one.
  std::size_t choose(std::size_t count) {
    if (at_ == made_.size()) made_.emplace_back(0, count);
    return made_[at_++].first;
  }
  /// Goes on to the next combination, from the start of the text; false after the last one.
  bool next() {
    made_.resize(at_);
    at_ = 0;
    while (!made_.empty() && made_.back().first + 1 >= made_.back().second) made_.pop_back();
    if (made_.empty()) return false;
    ++made_.back().first;
    return true;
  }

 private:
  std::vector<std::pair<std::size_t, std::size_t>> made_;  // the alternative that was taken, and how many there were
  std::size_t at_ = 0;
};

}  // namespace unietp
