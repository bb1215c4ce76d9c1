#pragma once

#include <string>
#include <vector>

#include "templates/template.h"

namespace unietp {

/// A phrasing that may ask for less than the goal: it has no word for a number of two or more that the goal counts
/// ("two", "2", "both", "pair" …), or none for "all" nor "the {A:plural}", where the goal says something of every
/// object.
struct DoubtfulPhrasing {
  std::size_t index = 0;  // in Template::instructions
  std::string message;
  bool operator==(const DoubtfulPhrasing&) const = default;
};
/// In order of phrasings. A hint for people: words are looked up in a short table, not understood.
std::vector<DoubtfulPhrasing> doubtful_phrasings(const Template& source);

}  // namespace unietp
