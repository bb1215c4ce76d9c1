#include "cli/llm_options.h"

#include "cli/command_parser.h"
#include "core/limits.h"
#include "core/text.h"

namespace unietp {

void add_llm_options(CommandParser& command, LlmChoice& choice, bool required) {
  command.add_option("--llm-url", choice.url, "OpenAI-compatible server: .../v1 or .../v1/chat/completions")
      ->type_name("URL")
      ->required(required);
  command.add_option("--llm-model", choice.model, "Model, by the server's name for it; it is recorded as the source")
      ->type_name("NAME")
      ->required(required);
  command.add_option("--at-once", choice.ask.at_once, "Concurrent requests")
      ->within(1, limits::kRequests)
      ->shows_default();
  command.add_option("--cache", choice.cache, "File of cached answers (default: in the user's cache folder)")->output();
  command.add_option("--llm-timeout", choice.ask.attempt_s, "Seconds for one attempt")
      ->within(limits::kLeastTimeout_s, limits::kTimeout_s)
      ->shows_default();
  command.add_option("--llm-total", choice.ask.total_s, "Seconds for the whole command")
      ->within(limits::kLeastTimeout_s, limits::kTotal_s)
      ->shows_default();
  command.add_option("--llm-attempts", choice.ask.max_attempts, "Attempts per request")
      ->within(1, limits::kRequestAttempts)
      ->shows_default();
  command.add_option("--llm-wait", choice.ask.first_wait_s, "Seconds before the second attempt; doubled each time")
      ->within(0.0, limits::kWait_s)
      ->shows_default();
  command.add_option("--temperature", choice.temperature, "Sampling temperature (default: the server's)")
      ->within(0.0, 2.0);
  command.add_option("--max-tokens", choice.max_tokens, "Most tokens of an answer (default: the server's)")
      ->within(1, limits::kAskedTokens);
  command.add_option("--price-in", choice.price.prompt, "Price of a million prompt tokens, for the cost summary")
      ->not_negative();
  command.add_option("--price-out", choice.price.completion, "Price of a million answer tokens")->not_negative();
  command.add_flag("--dry-run", choice.dry_run, "Print the prompts and send nothing");
}

std::string cost_line(const LlmTotals& totals, const LlmPrice& price) {
  return "tokens     " + std::to_string(totals.prompt_tokens) + " in, " + std::to_string(totals.completion_tokens) +
         " out" +
         (price.prompt + price.completion > 0 ? ", cost " + number_text(cost_of(totals, price)) : std::string());
}

}  // namespace unietp
