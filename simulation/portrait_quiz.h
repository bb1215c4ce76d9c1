#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "simulation/portrait.h"

namespace unietp {

/// A question about one picture (what is it?) or about two pictures of one thing (which is which?).
struct QuizItem {
  const Knowledge* knowledge = nullptr;
  const Category* category = nullptr;
  std::vector<Node> shown;
  PortraitOptions view;
  std::string question;  // "dirty or clean", of pairs; "movable" or "furniture" of single things
  std::string answer;    // the state or material of the first picture; the name of a single thing
};

/// Categories drawn by `seed`, each once, as many of each simulator as there are for it, in a random order. Seen from
/// the front or a little from a side; movable ones from above at arm's length to across a table, furniture from a
/// standing person's eyes.
std::vector<QuizItem> quiz_of_things(const std::vector<const Knowledge*>& knowledge, std::size_t movables,
                                     std::size_t furniture, std::uint64_t seed);
/// Pairs that differ in a state, as many of each state that a goal can name and of each simulator as there are for it.
std::vector<QuizItem> quiz_of_states(const std::vector<const Knowledge*>& knowledge, std::size_t count,
                                     std::uint64_t seed);
/// Pairs that differ in a material, of categories that are usually made of either.
std::vector<QuizItem> quiz_of_materials(const std::vector<const Knowledge*>& knowledge, std::size_t count,
                                        std::uint64_t seed);

}  // namespace unietp
