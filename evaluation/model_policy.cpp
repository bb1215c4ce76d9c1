#include "evaluation/model_policy.h"

#include <chrono>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/digest.h"
#include "core/text.h"
#include "evaluation/conversation.h"
#include "llm/cache.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

NoReply no_reply(const ChatFailure& failure, int attempts) {
  NoReply none;
  switch (failure.kind) {
    case ChatFailure::Kind::RateLimit:
      none.kind = EpisodeErrorKind::RateLimit;
      break;
    case ChatFailure::Kind::Server:
      none.kind = EpisodeErrorKind::Server;
      break;
    case ChatFailure::Kind::Connection:
      none.kind = EpisodeErrorKind::Connection;
      break;
    case ChatFailure::Kind::Timeout:
      none.kind = EpisodeErrorKind::Timeout;
      break;
    case ChatFailure::Kind::Rejected:
      none.kind = EpisodeErrorKind::Rejected;
      break;
    case ChatFailure::Kind::Stopped:
      none.stopped = true;
      break;
  }
  none.message = failure.message;
  none.attempts = attempts;
  none.hopeless = failure.status == 401 || failure.status == 403 || failure.status == 404 || failure.status == 405;
  return none;
}

NoReply broken(const Error& error) {
  NoReply none{EpisodeErrorKind::Policy, format(error)};
  none.hopeless = true;
  return none;
}

class ModelPolicy : public Policy {
 public:
  ModelPolicy(std::shared_ptr<const ModelOptions> options, std::shared_ptr<EpisodeLog> log,
              std::shared_ptr<ServerPause> server_pause)
      : options_(std::move(options)),
        log_(std::move(log)),
        client_(options_->endpoint, options_->chat, std::move(server_pause)),
        conversation_(options_->prompt, options_->talk) {}

  std::optional<NoReply> begin(const PlannedEpisode& episode, const Environment& /*start*/) override {
    key_ = episode.key;
    step_ = 0;
    conversation_ = Conversation(options_->prompt, options_->talk);
    if (options_->cache.empty() || cache_) return std::nullopt;
    auto cache = LlmCache::open(options_->cache);
    if (!cache) return broken(cache.error());
    cache_.emplace(std::move(*cache));
    return std::nullopt;
  }

  PolicyAnswer next(const Environment& environment) override {
    auto turns = conversation_.turns(environment);
    if (!turns) return broken(turns.error());
    const std::string body =
        chat_body(options_->endpoint.model, chat_request(*options_, std::move(*turns), key_.repeat, environment));
    const std::string prompt = sha256(body);
    auto reply = log_->reply_to(key_, step_, prompt);
    if (!reply) {
      auto answer = ask(body, prompt);
      if (auto* none = std::get_if<NoReply>(&answer)) return std::move(*none);
      reply = std::get<PolicyReply>(std::move(answer));
      if (auto done = log_->add(LoggedReply{key_, step_, *reply}); !done) return broken(done.error());
    }
    ++step_;
    conversation_.answered(reply->text);
    return std::move(*reply);
  }

 private:
  PolicyAnswer ask(const std::string& body, const std::string& prompt) {
    if (options_->max_cost > 0 && log_->cost() >= options_->max_cost) {
      NoReply none{EpisodeErrorKind::Policy, "the replies so far cost " + number_text(log_->cost()) +
                                                 ", which --max-cost does not allow to go on from"};
      none.stopped = none.hopeless = true;
      return none;
    }
    const std::string digest = cache_ ? digest_of(body, key_.repeat) : "";
    if (cache_) {
      if (const auto kept = cache_->find(digest)) {
        if (const auto reply = read_stored_reply(kept->text)) return reply_of(*reply, prompt, 0, 0);
      }
    }
    const auto begin = std::chrono::steady_clock::now();
    auto answer = client_.ask(body, Rng(0).fork(prompt, static_cast<std::uint64_t>(key_.repeat)));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (const auto* failure = std::get_if<ChatFailure>(&answer.result)) return no_reply(*failure, answer.attempts);
    const auto& reply = std::get<ChatReply>(answer.result);
    if (cache_) cache_->store(digest, options_->endpoint.model, {to_text(reply), 0, 0, answer.attempts, false});
    return reply_of(reply, prompt, answer.attempts, seconds);
  }

  PolicyReply reply_of(const ChatReply& reply, const std::string& prompt, int attempts, double seconds) const {
    PolicyReply said;
    said.text = reply.text;
    said.thinking = reply.thinking;
    said.finish = reply.finish;
    said.prompt = prompt;
    said.model = reply.model;
    said.prompt_tokens = reply.prompt_tokens;
    said.completion_tokens = reply.completion_tokens;
    if (attempts > 0) {
      LlmTotals totals;
      totals.prompt_tokens = reply.prompt_tokens;
      totals.completion_tokens = reply.completion_tokens;
      said.cost = cost_of(totals, options_->price);
    }
    said.attempts = attempts;
    said.seconds = seconds;
    return said;
  }

  std::shared_ptr<const ModelOptions> options_;
  std::shared_ptr<EpisodeLog> log_;
  ChatClient client_;
  Conversation conversation_;
  std::optional<LlmCache> cache_;
  EpisodeKey key_;
  int step_ = 0;
};

}  // namespace

ChatRequest chat_request(const ModelOptions& options, std::vector<ChatTurn> turns, int repeat,
                         const Environment& environment) {
  ChatRequest request;
  request.turns = std::move(turns);
  request.temperature = options.sampling.temperature;
  request.top_p = options.sampling.top_p;
  request.max_tokens = options.sampling.max_tokens;
  if (options.sampling.seed) request.seed = *options.sampling.seed + static_cast<std::uint64_t>(repeat - 1);
  request.extra = options.sampling.extra;
  if (options.talk.structured) request.schema = answer_schema(environment, options.talk.thinking);
  return request;
}

std::string answer_schema(const Environment& environment, bool thinking) {
  const ModeRules& rules = environment.settings().rules;
  const Profile& profile = *environment.task()->data.profile;
  Json names = Json::array();
  bool by_box = false;
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : list) {
      if (!profile.offers(action.type) || !offers(action, rules)) continue;
      names.push_back(action.name);
      by_box = by_box || (action.argument != ActionArgument::None && naming_of(action, rules) == Naming::Box);
    }
  }
  Json argument = {{"type", "string"}};
  if (by_box) {
    const Json box = {{"type", "object"},
                      {"properties", {{"bbox", {{"type", "array"}, {"items", {{"type", "number"}}}}}}},
                      {"required", {"bbox"}},
                      {"additionalProperties", false}};
    argument = {{"anyOf", {argument, box}}};
  }
  Json schema{{"type", "object"}, {"properties", Json::object()}, {"required", Json::array()}};
  const auto add = [&](const char* name, Json type) {
    schema["properties"][name] = std::move(type);
    schema["required"].push_back(name);
  };
  if (thinking) add("reasoning", {{"type", "string"}});
  add("action", {{"type", "string"}, {"enum", std::move(names)}});
  add("args", {{"type", "array"}, {"items", std::move(argument)}});
  schema["additionalProperties"] = false;
  return schema.dump();
}

PolicyMaker model_policies(std::shared_ptr<const ModelOptions> options, std::shared_ptr<EpisodeLog> log) {
  auto server_pause = std::make_shared<ServerPause>();  // shared: one server, many threads
  return [options = std::move(options), log = std::move(log), server_pause] {
    return std::make_unique<ModelPolicy>(options, log, server_pause);
  };
}

}  // namespace unietp
