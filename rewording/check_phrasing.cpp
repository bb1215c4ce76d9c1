#include "rewording/check_phrasing.h"

#include <algorithm>
#include <string>

#include "annotator/noun_table.h"
#include "record/text_writer.h"
#include "resources/own_phrasings.h"
#include "templates/phrasing.h"

namespace unietp {
namespace {

/// The words of a phrasing outside of its slots, but for those that a floor is named with, as "the kitchen floor".
std::vector<std::string> own_words(std::string_view phrasing) {
  std::string bare;
  std::size_t at = 0;
  for (const Slot& slot : read_slots(phrasing).slots) {
    bare += std::string(phrasing.substr(at, slot.offset - at)) + " ";
    at = slot.offset + slot.length;
  }
  bare += phrasing.substr(at);
  std::vector<std::string> words;
  for (const Token& token : tokens_of(bare)) {
    const bool of_floor = token.text == "the" || token.text == "floor" || token.text == "of";
    if (!of_floor && std::isalnum(static_cast<unsigned char>(token.text[0])) != 0) words.push_back(token.text);
  }
  return words;
}

bool has_in_order(const std::vector<Token>& text, const std::vector<std::string>& words) {
  auto at = words.begin();
  for (const Token& token : text)
    if (at != words.end() && token.text == *at) ++at;
  return at == words.end();
}

}  // namespace

std::vector<Problem> check_phrasing(const TaskRecord& task, const Resources& resources) {
  if (task.phrasing == 0 || !is_known_template(resources, task.template_name)) return {};
  const auto found = [](std::string message) {
    return std::vector{problem_in(ProblemKind::TextRecord, "", std::move(message))};
  };
  const auto phrasings = phrasings_of_template(resources, task.template_name);
  const std::string said = "its instruction is recorded as phrasing " + std::to_string(task.phrasing);
  if (text_writer_of(task.writer) != TextWriter::Grammar) return found(said + ", but " + task.writer + " wrote it");
  if (static_cast<std::size_t>(task.phrasing) > phrasings.size())
    return found(said + "; its template's phrasings: " + std::to_string(phrasings.size()));
  const std::string& phrasing = phrasings[static_cast<std::size_t>(task.phrasing) - 1];
  if (!has_in_order(tokens_of(task.instruction), own_words(phrasing)))
    return found(said + " of its template, which has other words: " + phrasing);
  return {};
}

}  // namespace unietp
