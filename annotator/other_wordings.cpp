#include "annotator/other_wordings.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "annotator/frames.h"

namespace unietp {
namespace {

/// "No mug may be left there.", "Once the bread is in, turn on the toaster."
bool is_command(std::string_view plain) {
  constexpr std::array<std::string_view, 26> kOthers{
      "a",    "all", "an",   "after", "any",    "as",  "at",   "before", "both", "each",  "every", "i",    "i'd",
      "it's", "if",  "once", "no",    "nobody", "one", "only", "some",   "the",  "there", "two",   "when", "while"};
  const std::string_view first = plain.substr(0, plain.find(' '));
  return first != "please" && std::find(kOthers.begin(), kOthers.end(), first) == kOthers.end();
}

}  // namespace

std::vector<Instruction> other_wordings(const Specification& specification, const Knowledge& knowledge,
                                        const NounTable& nouns, const WritingOptions& options,
                                        std::set<std::string> known, std::size_t count, const Rng& rng) {
  constexpr std::size_t kDrawsForEach = 6;  // many goals have few forms, and most draws repeat one of them
  std::vector<Instruction> found;
  for (std::size_t draw = 0; draw < kDrawsForEach * count && found.size() < count; ++draw) {
    auto text = write_instruction(specification, knowledge, nouns, options, rng.fork("other wording", draw));
    if (!text || text->style != specification.style) break;  // no other draw has the style
    if (known.insert(text->text).second) found.push_back(std::move(*text));
  }
  return found;
}

std::vector<Instruction> requests_for(const Instruction& command, const Specification& specification,
                                      const Knowledge& knowledge, const NounTable& nouns, const Scene& home,
                                      std::set<std::string> known, std::size_t count) {
  const std::string& text = command.text;
  if (!text.ends_with('.')) return {};
  // "There is a mug on the desk. Can you wash it?", "Can you slice the apple? Put one of the slices on a plate."
  const bool told = command.style == Style::Anaphora || command.style == Style::Context ||
                    nouns.sentence_at(tokens_of(text), 0).first != nullptr;
  const std::size_t last = text.find_last_of(".?", text.size() - 2);
  if (told && last == text.npos) return {};
  std::size_t begin = told ? last + 2 : 0;
  const std::size_t end = text.find('.', begin), comma = text.find(", ", begin);
  if (text.compare(begin, 3, "If ") == 0 && comma < end) begin = comma + 2;
  std::string plain = text.substr(begin, end - begin);
  if (plain.find('?') != plain.npos) return {};
  const bool opens = std::isupper(static_cast<unsigned char>(plain[0])) != 0;
  plain[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(plain[0])));
  if (!is_command(plain)) return {};
  std::vector<Instruction> found;
  for (std::string asked : as_requests(plain)) {
    if (found.size() == count) break;
    if (!opens) asked[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(asked[0])));
    Instruction request = command;
    request.text.replace(begin, end + 1 - begin, asked);
    if (!check_instruction(request.text, specification, knowledge, nouns, &home).empty()) continue;
    if (known.insert(request.text).second) found.push_back(std::move(request));
  }
  return found;
}

}  // namespace unietp
