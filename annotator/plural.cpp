#include "annotator/plural.h"

#include <algorithm>
#include <array>
#include <utility>

namespace unietp {
namespace {

/// Ends of words, also of compounds: "bookshelf", "policewoman".
constexpr std::array<std::pair<std::string_view, std::string_view>, 23> kIrregular{{
    {"knife", "knives"},    {"shelf", "shelves"},
    {"leaf", "leaves"},     {"loaf", "loaves"},
    {"scarf", "scarves"},   {"half", "halves"},
    {"calf", "calves"},     {"wife", "wives"},
    {"woman", "women"},     {"child", "children"},
    {"foot", "feet"},       {"tooth", "teeth"},
    {"goose", "geese"},     {"mouse", "mice"},
    {"person", "people"},   {"potato", "potatoes"},
    {"tomato", "tomatoes"}, {"mango", "mangoes"},
    {"quiz", "quizzes"},    {"fez", "fezzes"},
    {"snowman", "snowmen"}, {"gingerbread man", "gingerbread men"},
    {" die", " dice"},
}};

constexpr std::array<std::string_view, 22> kUnchanging{
    "scissors", "pants",     "trousers",  "jeans",      "shorts",    "tights", "tongs", "pliers",
    "tweezers", "glasses",   "goggles",   "headphones", "earphones", "series", "sheep", "fish",
    "clothes",  "groceries", "leftovers", "binoculars", "pyjamas",   "dice"};

bool ends_in_word(std::string_view noun, std::string_view word) {
  return noun == word || (noun.ends_with(word) && noun[noun.size() - word.size() - 1] == ' ');
}

bool is_vowel(char c) { return std::string_view("aeiou").find(c) != std::string_view::npos; }

}  // namespace

std::string plural_of(std::string_view noun) {
  for (const std::string_view link : {" of ", " with ", " without ", " for ", " in ", " under "})
    if (const auto at = noun.find(link); at != std::string_view::npos)
      return plural_of(noun.substr(0, at)) + std::string(noun.substr(at));
  for (const std::string_view same : kUnchanging)
    if (ends_in_word(noun, same)) return std::string(noun);
  for (const auto& [one, many] : kIrregular)
    if (noun.ends_with(one)) return std::string(noun.substr(0, noun.size() - one.size())) + std::string(many);
  const auto ends = [&](std::string_view tail) { return noun.size() > tail.size() && noun.ends_with(tail); };
  if (ends("s") || ends("x") || ends("z") || ends("ch") || ends("sh")) return std::string(noun) + "es";
  if (ends("y") && !is_vowel(noun[noun.size() - 2])) return std::string(noun.substr(0, noun.size() - 1)) + "ies";
  return std::string(noun) + "s";
}

}  // namespace unietp
