#include "annotator/llm_writer.h"

#include "core/text.h"
#include "llm/one_field.h"

namespace unietp {
namespace {

constexpr int kSamples = 3;  // wordings of the grammar that the prompt shows
constexpr const char* kField = "instruction";

/// The reader only knows controlled English, so the prompt teaches it by examples of this very goal.
std::string request_for(const Specification& specification, const std::vector<Instruction>& samples) {
  std::string text = "Goal formula: " + to_text(specification.goal) + "\nStyle: " + specification.style +
                     "\nWordings of this goal that are right:\n";
  for (const Instruction& sample : samples) text += "- " + sample.text + "\n";
  return text + "Write one more, in your own words but in the same plain constructions.";
}

constexpr const char* kRules =
    "You word tasks for a household robot. Say every object, number, quantifier, order and description of the goal, "
    "and nothing else. Call objects what the examples call them; never use an id such as mug_3. Say 'a' for some "
    "object, "
    "'that' for one named before, 'every' for all, 'exactly', 'at least' or 'at most' before numbers. Answer with "
    "JSON: {\"instruction\": \"...\"}.";

}  // namespace

Result<Instruction> write_instruction_with_llm(const Specification& specification, const Knowledge& knowledge,
                                               const LlmWriterOptions& options, Rng rng) {
  const NounTable nouns(knowledge);
  std::vector<Instruction> samples;
  for (int i = 0; i < kSamples; ++i) {
    auto sample = write_instruction(specification, knowledge, nouns, rng.fork("sample", static_cast<std::uint64_t>(i)));
    if (!sample) return sample;  // a goal the reader could never check
    samples.push_back(std::move(*sample));
  }
  const auto prompt = request_for(specification, samples);
  auto request = one_field_request(kRules, prompt, kField);
  for (int round = 0; round <= options.rewrites; ++round) {
    LlmOptions asking = options.ask;
    asking.seed = rng.fork("ask", static_cast<std::uint64_t>(round)).next();
    const auto answer = ask_all(options.endpoint, {request}, asking, options.cache).front();
    if (!answer && answer.error().kind != Error::Kind::Schema) break;
    const auto text = answer ? field_of(*answer, kField) : answer.error();
    std::vector<std::string> wrong;
    if (text) {
      wrong = check_instruction(*text, specification, knowledge, nouns);
      if (wrong.empty())
        return Instruction{*text, "llm:" + options.endpoint.model, specification.style, {"parses-back", "no-ids"}};
    } else {
      wrong.push_back(format(text.error()));
    }
    request.user = prompt + "\nYour last answer was refused: " + join(wrong, "; ");
  }
  return samples.front();
}

}  // namespace unietp
