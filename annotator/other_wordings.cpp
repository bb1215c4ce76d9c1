#include "annotator/other_wordings.h"

#include <cctype>

#include "annotator/frames.h"

namespace unietp {

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
  const std::size_t before = text.find_last_of(".?", text.size() - 2);
  const std::size_t begin = before == text.npos ? 0 : before + 2;
  // "There is a mug on the desk. Can you wash it?"
  const bool told = command.style == Style::Anaphora || command.style == Style::Context;
  std::string plain = text.substr(begin, text.size() - begin - 1);
  if ((begin > 0) != told || plain.starts_with("If ") || plain.starts_with("Please ")) return {};
  plain[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(plain[0])));
  std::vector<Instruction> found;
  for (const std::string& asked : as_requests(plain)) {
    if (found.size() == count) break;
    Instruction request = command;
    request.text.replace(begin, std::string::npos, asked);
    if (!check_instruction(request.text, specification, knowledge, nouns, &home).empty()) continue;
    if (known.insert(request.text).second) found.push_back(std::move(request));
  }
  return found;
}

}  // namespace unietp
