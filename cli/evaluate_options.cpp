#include "cli/evaluate_options.h"

#include <charconv>

#include <nlohmann/json.hpp>

#include "cli/command_parser.h"
#include "cli/common_options.h"
#include "core/files.h"
#include "core/in_quotes.h"
#include "core/limits.h"
#include "core/text.h"
#include "dataset/configuration.h"
#include "evaluation/child_process.h"
#include "evaluation/program_policy.h"
#include "evaluation/prompt_slots.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

Error usage(const std::string& option, const std::string& message) { return {Error::Kind::Usage, option, {}, message}; }

/// "full" (-1), "none" (0) or a whole number.
Result<int> read_count(const std::string& option, const std::string& text, const std::string& all, int value_of_all) {
  if (text == all) return value_of_all;
  if (text == "none") return 0;
  int count = -1;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, count);
  if (read.ec != std::errc() || read.ptr != end || count < 0 || count > 1000)
    return usage(option, "expected " + all + ", none or a number up to 1000");
  return count;
}

std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  for (const std::string& name : split(text, ',')) {
    if (!trim(name).empty()) names.emplace_back(trim(name));
  }
  return names;
}

Result<EpisodeSelection> read_selection(const EvaluateChoice& choice) {
  EpisodeSelection selection;
  auto modes = parse_modes("--modes", choice.modes);
  if (!modes) return modes.error();
  selection.modes = std::move(*modes);
  if (!choice.splits.empty()) {
    const auto splits = parse_splits("--splits", choice.splits);
    if (!splits) return splits.error();
    for (const auto one : *splits) selection.splits.emplace_back(name_of(one));
  }
  if (!choice.simulators.empty()) {
    const auto simulators = parse_simulators("--simulators", choice.simulators);
    if (!simulators) return simulators.error();
    for (const auto one : *simulators) selection.simulators.emplace_back(name_of(one));
  }
  selection.tasks = names_in(choice.tasks);
  selection.limit = choice.limit;
  selection.repeats = choice.repeats;
  selection.seed = choice.seed.value_or(0);
  return selection;
}

/// The value of NAME=VALUE as JSON: a number or a truth value where it reads as one, else text.
Json setting_value(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  return json.is_number() || json.is_boolean() ? json : Json(text);
}

Result<Settings> read_settings(const EvaluateChoice& choice, Mode mode) {
  Json json{{"mode", name_of(mode)}, {"conventions", choice.preset}, {"feedback", choice.feedback}};
  if (!choice.boxes.empty()) json["boxes"] = choice.boxes == "on";
  if (!choice.box_form.empty()) json["box_form"] = choice.box_form;
  for (const std::string& one : choice.settings) {
    const auto equals = one.find('=');
    if (equals == std::string::npos) return usage("--setting", "expected NAME=VALUE, as in steps=60");
    const std::string name = one.substr(0, equals);
    if (name == "mode" || name == "conventions") return usage("--setting", "use --modes and --preset instead");
    json[name] = setting_value(one.substr(equals + 1));
  }
  auto settings = settings_from_json("--setting", json);
  if (settings && settings->rules.limits.steps > limits::kEvaluatedSteps)
    return usage("--setting", "expected at most " + std::to_string(limits::kEvaluatedSteps) + " steps");
  return settings;
}

Result<PromptFile> read_prompt_choice(const EvaluateChoice& choice, const CommandLine& program) {
  const bool built_in = choice.prompt == "unietp" || choice.prompt == "release";
  const std::filesystem::path path = built_in ? program.folders.root / "data" / "prompts" / (choice.prompt + ".prompt")
                                              : std::filesystem::path(choice.prompt);
  const auto text = read_file(path);
  if (!text) return text.error();
  return read_prompt(path.string(), *text, prompt_slot_names());
}

Result<TalkSettings> read_talk(const EvaluateChoice& choice, const PromptFile& prompt) {
  TalkSettings talk;
  talk.prompt = prompt.name;
  talk.prompt_digest = prompt.digest;
  const auto history = read_count("--history", choice.history, "full", -1);
  const auto images = read_count("--images", choice.images, "current", 1);
  if (!history) return history.error();
  if (!images) return images.error();
  talk.history = *history;
  talk.images = *images;
  talk.multi = choice.chat == "multi";
  talk.described = talk.images == 0;
  talk.thinking = choice.reasoning;
  talk.structured = choice.structured;
  return talk;
}

Result<ModelOptions> read_model(const EvaluateChoice& choice, const CommandLine& program) {
  if (choice.url.empty())
    return usage("--llm-url", "expected the server of the model, such as http://localhost:8080/v1");
  const auto url = chat_url(choice.url);
  if (!url) return url.error();
  auto prompt = read_prompt_choice(choice, program);
  if (!prompt) return prompt.error();
  auto talk = read_talk(choice, *prompt);
  if (!talk) return talk.error();
  auto extra = check_extra(choice.extra);
  if (!extra) return usage("--extra", extra.error().message);
  if (choice.max_cost > 0 && choice.price_in + choice.price_out <= 0)
    return usage("--max-cost", "needs --price-in or --price-out");
  ModelOptions model;
  model.endpoint = {*url, choice.model, program.llm_key};
  model.chat.attempt_s = choice.attempt_s;
  model.chat.max_attempts = choice.attempts;
  model.chat.first_wait_s = choice.first_wait_s;
  model.chat.stop = program.interrupted;
  model.prompt = std::move(*prompt);
  model.talk = std::move(*talk);
  if (choice.temperature >= 0) model.sampling.temperature = choice.temperature;
  if (choice.top_p >= 0) model.sampling.top_p = choice.top_p;
  if (choice.max_tokens > 0) model.sampling.max_tokens = choice.max_tokens;
  model.sampling.seed = choice.sampling_seed;
  model.sampling.extra = std::move(*extra);
  model.price = {choice.price_in, choice.price_out};
  model.max_cost = choice.max_cost;
  model.cache = choice.cache;
  return model;
}

void add_selection_options(CommandParser& command, EvaluateChoice& choice) {
  command.add_option("--modes", choice.modes, "Modes")->type_name("M1,M2,M3")->shows_default();
  command.add_option("--splits", choice.splits, "Only tasks of these splits")
      ->type_name("NAME,...")
      ->suggests(split_names());
  add_simulators_option(command, choice.simulators, "Only tasks of these simulators");
  command
      .add_option("--backend", choice.backend,
                  "Where actions are done and goals judged: unietp or, with the simulator's Python packages "
                  "(docs/native.md), virtualhome (its graph simulator), ai2thor, behavior or habitat")
      ->type_name("NAME")
      ->suggests({kOwnBackend, "virtualhome", "ai2thor", "behavior", "habitat"})
      ->shows_default();
  command.add_option("--tasks", choice.tasks, "Only these tasks, by their ids")->type_name("ID,...");
  command.add_option("--limit", choice.limit, "At most so many tasks, the first ones")->within(1, limits::kTasks);
  command.add_option("--repeats", choice.repeats, "Times that each task is played")->within(1, 10'000)->shows_default();
  command.add_option("--seed", choice.seed, "Seed of policies that draw (default: 0)");
}

void add_telling_options(CommandParser& command, EvaluateChoice& choice) {
  command.add_option("--preset", choice.preset, "Where the paper and the released runner differ")
      ->one_of({"paper", "release"})
      ->shows_default();
  command.add_option("--feedback", choice.feedback, "What the agent is told of its actions")
      ->one_of({"full", "success", "none"})
      ->shows_default();
  command.add_option("--boxes", choice.boxes, "Tell the boxes of objects in view (default: as the mode says)")
      ->one_of({"on", "off"});
  command.add_option("--box-format", choice.box_form, "Numbers of boxes (default: as the preset says)")
      ->one_of({"pixels", "unit", "thousand", "thousand_y_first"});
  command.add_option("--setting", choice.settings, "Another setting of docs/environment.md, as in steps=60")
      ->type_name("NAME=VALUE")
      ->one_each();
  command.add_option("--prompt", choice.prompt, "unietp, release or a file (docs/evaluation.md)")
      ->suggests({"unietp", "release"})
      ->shows_default();
  command.add_option("--history", choice.history, "Steps that a model is told again: full, none or a number")
      ->shows_default();
  command
      .add_option("--images", choice.images,
                  "Pictures that a model is sent: current, so many of the last ones, or none, for models that "
                  "cannot see: they are told what is in view in words")
      ->shows_default();
  command.add_option("--chat", choice.chat, "All in one turn, or a turn of the chat for each step")
      ->one_of({"single", "multi"})
      ->shows_default();
  command.add_flag("--reasoning", choice.reasoning, "Ask for a rationale before each action");
  command.add_flag("--structured", choice.structured, "Ask the server to keep replies to a JSON schema");
}

void add_server_options(CommandParser& command, EvaluateChoice& choice) {
  command.add_option("--temperature", choice.temperature, "Sampling temperature (default: the server's)")
      ->within(0.0, 2.0);
  command.add_option("--top-p", choice.top_p, "Nucleus sampling (default: the server's)")->within(0.0, 1.0);
  command.add_option("--max-tokens", choice.max_tokens, "Most tokens of a reply (default: the server's)")
      ->within(1, limits::kAskedTokens);
  command.add_option("--sampling-seed", choice.sampling_seed,
                     "Seed that the server is sent; each further repeat adds 1 (default: none)");
  command.add_option("--extra", choice.extra, "Further fields of the request, as in {\"min_p\": 0.1}")
      ->type_name("JSON");
  command.add_option("--llm-timeout", choice.attempt_s, "Seconds for one attempt, or for a policy's reply")
      ->within(limits::kLeastTimeout_s, limits::kTimeout_s)
      ->shows_default();
  command.add_option("--llm-attempts", choice.attempts, "Attempts per reply, when the server fails")
      ->within(1, limits::kRequestAttempts)
      ->shows_default();
  command.add_option("--llm-wait", choice.first_wait_s, "Seconds before the second attempt; doubled each time")
      ->within(0.0, limits::kWait_s)
      ->shows_default();
  command.add_option("--price-in", choice.price_in, "Price of a million prompt tokens")->not_negative();
  command.add_option("--price-out", choice.price_out, "Price of a million reply tokens")->not_negative();
  command.add_option("--max-cost", choice.max_cost, "Ask for no further reply once the run has cost so much")
      ->not_negative();
  command.add_option("--cache", choice.cache, "File of replies, to share them between runs (default: none)")->output();
}

}  // namespace

void add_evaluate_options(CommandParser& command, EvaluateChoice& choice) {
  command.add_option("DATASET", choice.folder, "A finished data set")->existing_folder()->required();
  command.add_option("--out", choice.out, "Folder for the results")->folder()->output();
  auto* model = command.add_option("--model", choice.model, "Model, by the server's name for it")->type_name("NAME");
  command.add_option("--llm-url", choice.url, "OpenAI-compatible server: .../v1; its key is in UNIETP_LLM_KEY")
      ->type_name("URL")
      ->needs(model);
  command
      .add_option("--policy", choice.policy,
                  "expert, replay, random, stop, noisy:P, python:module.Class, or a command that speaks JSON lines")
      ->excludes(model)
      ->suggests({"expert", "replay", "random", "stop", "noisy:0.1"});
  add_selection_options(command, choice);
  add_telling_options(command, choice);
  add_server_options(command, choice);
  command.add_option("--at-once", choice.at_once, "Episodes at a time (default: 4 for a model, else the processors)")
      ->within(1, limits::kRequests);
  command
      .add_option("--report-pictures", choice.report_pictures,
                  "Episodes that the report has pictures of, spread over modes, splits and results; --resume gives a "
                  "finished run another report")
      ->within(0, 1'000'000)
      ->shows_default();
  command.add_flag("--resume", choice.resume, "Go on with the run in the folder --out");
  command.add_flag("--dry-run", choice.dry_run, "Say what would be run, with the first prompt; send nothing");
  command.add_option("--show-prompt", choice.show_prompt, "Print what a model is sent at a step, counted from 1")
      ->type_name("TASK:STEP");
}

Result<EvaluateRequest> read_evaluate_options(const EvaluateChoice& choice, const CommandLine& program) {
  EvaluateRequest request;
  auto selection = read_selection(choice);
  if (!selection) return selection.error();
  request.selection = std::move(*selection);
  for (const Mode mode : request.selection.modes) {
    auto settings = read_settings(choice, mode);
    if (!settings) return settings.error();
    request.settings.emplace(mode, *settings);
  }
  const bool only_shows = !choice.show_prompt.empty() && choice.model.empty();
  if (choice.model.empty() && choice.policy.empty() && !only_shows)
    return usage("unietp evaluate", "expected --model NAME or --policy POLICY");
  request.at_once = choice.at_once > 0 ? choice.at_once : choice.model.empty() ? program.processors : 4;
  if (!choice.model.empty() || only_shows) {
    EvaluateChoice asked = choice;
    if (only_shows) {
      asked.model = "model";
      asked.url = "http://localhost/v1";
    }
    auto model = read_model(asked, program);
    if (!model) return model.error();
    request.model = std::move(*model);
    return request;
  }
  const auto built_in = built_in_policy(choice.policy);
  if (!built_in) return built_in.error();
  request.built_in = *built_in;
  if (request.built_in) return request;
  auto words = choice.policy.starts_with("python:") ? python_policy(choice.policy) : words_of_command(choice.policy);
  if (!words) return words.error();
  if (!program_named(words->front())) {
    const auto near = nearest_name(choice.policy, {"expert", "replay", "random", "stop", "noisy:0.1"});
    return usage("--policy", "there is no program " + in_quotes(words->front()) +
                                 (near.empty() ? "" : "; did you mean " + near + "?"));
  }
  request.program = std::move(*words);
  return request;
}

}  // namespace unietp
