#include "evaluation/program_policy.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/base64.h"
#include "core/digest.h"
#include "core/limits.h"
#include "core/png.h"
#include "environment/observation_json.h"
#include "evaluation/child_process.h"
#include "evaluation/evaluation_asset.h"
#include "evaluation/random_policy.h"
#include "record/record_fields.h"
#include "scene/json_parse.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

class ProgramPolicy : public Policy {
 public:
  explicit ProgramPolicy(ProgramOptions options) : options_(std::move(options)) {}

  std::optional<NoReply> begin(const PlannedEpisode& episode, const Environment& start) override {
    params_ = {{"task", episode.key.task},
               {"mode", name_of(episode.key.mode)},
               {"repeat", episode.key.repeat},
               {"seed", episode_rng(options_.seed, episode.key).next() >> 11},
               {"prompt", start.prompt()}};
    method_ = "begin";
    if (process_) return std::nullopt;
    auto process = ChildProcess::start(options_.arguments);
    if (!process) {
      NoReply none{EpisodeErrorKind::Policy, format(process.error())};
      none.hopeless = true;
      return none;
    }
    process_.emplace(std::move(*process));
    return std::nullopt;
  }

  PolicyAnswer next(const Environment& environment) override {
    const auto begin = std::chrono::steady_clock::now();
    if (auto done = add_observation(environment); !done) return failed(done.error());
    const std::string params = params_.dump(-1, ' ', false, Json::error_handler_t::replace);
    const std::string call = R"({"jsonrpc":"2.0","id":)" + std::to_string(++calls_) + R"(,"method":")" + method_ +
                             R"(","params":)" + params + "}";
    const auto line = process_->exchange(call, options_.reply_s, limits::kMessageBytes, options_.stop);
    if (!line) return failed(line.error());
    auto reply = read_policy_answer(*line, calls_);
    if (!reply) return failed(reply.error());
    reply->prompt = sha256(params);
    reply->attempts = 1;
    reply->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    params_ = Json::object();
    method_ = "act";
    return std::move(*reply);
  }

 private:
  Result<Done> add_observation(const Environment& environment) {
    const Observation& seen = environment.observe();
    params_["observation"] = observation_to_json(seen, environment.settings());
    params_["text"] = environment.text();
    if (!options_.pictures || !seen.has_picture) return Done{};
    const Picture picture = environment.picture();
    const auto bytes = png(picture.width, picture.height, picture.rgb);
    if (!bytes) return bytes.error();
    params_["picture"] = {{"width", picture.width}, {"height", picture.height}, {"png", base64(*bytes)}};
    return Done{};
  }

  /// Whatever the program is doing, the next episode begins with a new one.
  NoReply failed(const Error& error) {
    process_.reset();
    NoReply none{EpisodeErrorKind::Policy, error.message};
    none.attempts = 1;
    none.stopped = options_.stop != nullptr && *options_.stop;
    none.again = !none.stopped;
    return none;
  }

  ProgramOptions options_;
  std::optional<ChildProcess> process_;
  Json params_;  // of the next call
  std::string method_;
  int calls_ = 0;
};

}  // namespace

Result<PolicyReply> read_policy_answer(std::string_view line, int id) {
  const auto json = parse_json("policy's answer", line);
  if (!json) return json.error();
  PolicyReply reply;
  JsonReader reader("policy's answer");
  const JsonAt root{*json};
  JsonFields fields(reader, root);
  if (const auto f = fields.required("jsonrpc"); f && f->json != "2.0") reader.fail(*f, "expected \"2.0\"");
  if (const auto f = fields.required("id"); f && f->json != id)
    reader.fail(*f, "expected " + std::to_string(id) + ", the id of the call");
  if (const auto f = fields.optional("error")) reader.fail(*f, "the policy reports " + f->json.dump().substr(0, 300));
  if (const auto f = fields.required("result")) {
    JsonFields own(reader, *f);
    if (const auto action = own.required("action"))
      reply.text = action->json.is_string() ? action->json.get<std::string>() : action->json.dump();
    if (const auto thinking = own.optional("thinking")) reply.thinking = text_or_empty(reader, *thinking);
    if (const auto tokens = own.optional("prompt_tokens")) reply.prompt_tokens = read_whole(reader, *tokens);
    if (const auto tokens = own.optional("completion_tokens")) reply.completion_tokens = read_whole(reader, *tokens);
    own.finish();
  }
  fields.finish();
  if (reader.error()) return *reader.error();
  return reply;
}

Result<std::vector<std::string>> python_policy(const std::string& text) {
  const std::string name = text.substr(text.find(':') + 1);
  const auto is_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.'; };
  const bool has_class = name.find('.') != std::string::npos && name.front() != '.' && name.back() != '.';
  if (!has_class || !std::all_of(name.begin(), name.end(), is_name))
    return Error{Error::Kind::Usage, "--policy", {}, "expected python:module.Class, as in python:my_agent.Agent"};
  return std::vector<std::string>{"python3", "-c", std::string(evaluation_asset("policy_host.py")), name};
}

PolicyMaker program_policies(ProgramOptions options) {
  return [options = std::move(options)] { return std::make_unique<ProgramPolicy>(options); };
}

}  // namespace unietp
