#pragma once

#include <map>
#include <string>
#include <string_view>

#include "akb/knowledge.h"
#include "interchange/format_facts.h"

namespace unietp {

/// Finds the category that a simulator's file means: by the knowledge base's own name, else by its letters and digits
/// alone ("kitchen_cabinet" is kitchencabinet), else by a display name, plural or synonym. Ties go to the first in
/// table order. `knowledge` must outlive it.
class CategoryNames {
 public:
  explicit CategoryNames(const Knowledge& knowledge);
  /// nullptr when nothing fits.
  const Category* find(std::string_view name) const;

 private:
  const Knowledge* knowledge_;
  std::map<std::string, const Category*, std::less<>> by_letters_;
};

/// True for what a home is built of and what our scenes draw as rooms, walls and openings: floors, walls, ceilings,
/// doors in walls and their frames. The words are the table building_words.csv.
bool is_of_the_building(std::string_view name, const FormatFacts& facts);

}  // namespace unietp
