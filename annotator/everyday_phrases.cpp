#include "annotator/everyday_phrases.h"

#include <utility>
#include <vector>

#include "core/text.h"

namespace unietp {

std::string with_room_tables(std::string text) {
  text = replace_all(std::move(text), "dining table in the dining room", "dining room table");
  return replace_all(std::move(text), "dining room dining table", "dining room table");
}

std::string with_zips(std::string text) {
  return replace_all(std::move(text), "closed backpack", "zipped-up backpack");
}

std::string with_tops(std::string text, const NounTable& nouns) {
  const std::vector<Token> tokens = tokens_of(text);
  const auto is = [&](std::size_t at, std::string_view word) { return at < tokens.size() && tokens[at].text == word; };
  for (std::size_t i = tokens.size(); i-- > 1;) {
    if (!is(i, "on") || is(i - 1, "turn") || is(i - 1, "switch") || is(i - 1, "lid")) continue;
    std::size_t at = i + 1;
    while (is(at, "the") || is(at, "a") || is(at, "one") || is(at, "of") || is(at, "same")) ++at;
    std::size_t length = nouns.noun_at(tokens, at).length;
    if (const std::size_t room = nouns.room_at(tokens, at).length; room > 0 && room >= length) {  // "kitchen cupboard"
      const std::size_t named = nouns.noun_at(tokens, at + room).length;
      length = named == 0 ? length : room + named;
    }
    const bool high = length > 0 && at + length <= tokens.size() &&
                      nouns.everyday()->is_word_for(tokens[at + length - 1].text, NameUse::HasTop);
    if (high && at > i + 1) text.insert(static_cast<std::size_t>(tokens[i].column) + 1, " top of");
  }
  return text;
}

std::string with_one_of(std::string text, const NounTable& nouns) {
  const std::vector<Token> tokens = tokens_of(text);
  const auto is = [&](std::size_t at, std::string_view word) { return at < tokens.size() && tokens[at].text == word; };
  for (std::size_t i = tokens.size(); i-- > 0;) {
    const bool turn = is(i, "turn") || is(i, "switch");
    const std::size_t at = turn && is(i + 1, "off") ? i + 2 : i + 1;  // of the article
    if ((!turn && !is(i, "close") && !is(i, "shut")) || (!is(at, "a") && !is(at, "an"))) continue;
    const NounTable::Reading noun = nouns.noun_at(tokens, at + 1);
    const std::size_t after = at + 1 + noun.length;
    if (noun.length == 0 || noun.nouns.size() != 1 || (turn && at == i + 1 && !is(after, "off"))) continue;
    if (noun.nouns[0].members.size() != 1 || noun.nouns[0].members[0].slice) continue;
    const auto* name = nouns.display(noun.nouns[0].members[0].category);
    const auto begin = static_cast<std::size_t>(tokens[at].column) - 1;
    const auto end = static_cast<std::size_t>(tokens[after - 1].column) - 1 + tokens[after - 1].text.size();
    const std::size_t word = static_cast<std::size_t>(tokens[at + 1].column) - 1;
    if (name == nullptr || !name->countable || text.substr(word, end - word) != name->singular) continue;
    text.replace(begin, end - begin, "one of the " + name->plural);
  }
  return text;
}

}  // namespace unietp
