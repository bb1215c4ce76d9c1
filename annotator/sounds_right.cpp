#include "annotator/sounds_right.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "core/text.h"

namespace unietp {
namespace {

/// "Both pieces of juice": it is poured, and nobody cuts it.
bool cuts_what_is_poured(std::string_view text) {
  constexpr std::array<std::string_view, 7> kPoured{"beer",  "cereal", "crackers", "face cream",
                                                    "juice", "milk",   "wine"};
  return std::any_of(kPoured.begin(), kPoured.end(), [&](std::string_view poured) {
    return text.find("piece of " + std::string(poured)) != text.npos ||
           text.find("pieces of " + std::string(poured)) != text.npos;
  });
}

/// "A couple of baby shoes": they go in pairs.
bool parts_a_pair(std::string_view text) {
  constexpr std::string_view kCouple = "ouple of ";
  constexpr std::array<std::string_view, 5> kPaired{"shoes", "boots", "sandals", "slippers", "gloves"};
  const std::size_t at = text.find(kCouple);
  if (at == text.npos) return false;
  const std::string_view rest = text.substr(at);
  const std::string_view thing = rest.substr(0, std::min({rest.find(" in"), rest.find(" on"), rest.find('.')}));
  return std::any_of(kPaired.begin(), kPaired.end(), [&](std::string_view pair) { return thing.ends_with(pair); });
}

/// "Open the chest of drawers": one opens a drawer of it.
bool opens_all_drawers(std::string_view text) {
  for (std::size_t at = text.find("chest of drawers"); at != text.npos; at = text.find("chest of drawers", at + 1)) {
    const std::string before = lower(text.substr(0, at));
    const std::size_t opens = before.rfind("open ");
    if (opens == before.npos) continue;
    const std::string_view between = std::string_view(before).substr(opens);
    constexpr std::array<std::string_view, 7> kOthers{",", ".", " and ", " in ", " on ", " of ", " to "};
    if (std::none_of(kOthers.begin(), kOthers.end(),
                     [&](std::string_view other) { return between.find(other) != between.npos; }))
      return true;
  }
  return false;
}

}  // namespace

bool sounds_right(const std::string& text) {
  constexpr std::array kNever{" from with ",    " with with ",     " in with ", " on with ",
                              " on on ",        " on in ",         " in in ",   " in on ",
                              " with on ",      " with in ",       " me it.",   " on something ",
                              " turned on to ", " turned off to ", " at first", " for each platter ",
                              " up it.",        " up it ",         " up them"};
  constexpr std::array kNeverNeeded{"ick up something ", "ash something to cover ", "lean something to cover ",
                                    "ash something to dry ", "lean something to dry "};
  // "… the fork nearest to the oven in the dishwasher": into it, or so it is heard as where the oven is.
  constexpr std::string_view kNearest = " nearest to ";
  if (const std::size_t near = text.find(kNearest); near != std::string::npos) {
    const std::string rest = text.substr(0, text.find_first_of(",.", near)).substr(near);
    const std::size_t in = std::min(rest.find(" in the "), rest.find(" in a "));
    if (in < rest.find(" and ")) return false;
  }
  // "… put the taco on the table. Put the plum on it.": on the taco?
  std::size_t from = 0;
  bool placed = false;
  for (std::size_t end = text.find('.'); end != text.npos; from = end + 2, end = text.find('.', from)) {
    const std::string sentence = text.substr(std::min(from, end), end - std::min(from, end));
    if (placed && (sentence.ends_with(" on it") || sentence.ends_with(" in it"))) return false;
    placed = lower(sentence).find("put ") != sentence.npos || lower(sentence).find("place ") != sentence.npos;
  }
  const auto says = [&](const char* words) { return text.find(words) != text.npos; };
  return std::none_of(kNever.begin(), kNever.end(), says) &&
         std::none_of(kNeverNeeded.begin(), kNeverNeeded.end(), says) && !cuts_what_is_poured(text) &&
         !parts_a_pair(text) && !opens_all_drawers(text);
}

}  // namespace unietp
