#include "annotator/other_wordings.h"

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

}  // namespace unietp
