#pragma once

#include <filesystem>
#include <memory>

#include "evaluation/episode_log.h"
#include "evaluation/evaluation_manifest.h"
#include "evaluation/policy.h"
#include "evaluation/prompt_file.h"
#include "llm/ask.h"
#include "llm/chat_client.h"

namespace unietp {

/// How a model is reached and told of its episodes.
struct ModelOptions {
  LlmEndpoint endpoint;  // its url is whole
  ChatOptions chat;
  PromptFile prompt;
  TalkSettings talk;
  SamplingSettings sampling;
  LlmPrice price;
  double max_cost = 0;          // of the whole run, with what the log has; 0: no bound
  std::filesystem::path cache;  // of replies, shared between runs; "": none
};

/// A language model behind an OpenAI-compatible server. Whatever it says is its reply and is never asked again; replies
/// are in the log before they are used, and those that the log has to the same prompt are not asked for again.
/// The options and the log are shared by all threads and outlive the policies.
PolicyMaker model_policies(std::shared_ptr<const ModelOptions> options, std::shared_ptr<EpisodeLog> log);

/// The request for these turns, as an episode of this repeat sends it; `schema`: of the answer, "" for none.
ChatRequest chat_request(const ModelOptions& options, std::vector<ChatTurn> turns, int repeat,
                         const Environment& environment);

/// The JSON schema of an answer: one action that the mode and the simulator offer, with its argument.
std::string answer_schema(const Environment& environment, bool thinking);

}  // namespace unietp
