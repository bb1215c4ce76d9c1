#include "cli/show_prompt.h"

#include <algorithm>
#include <charconv>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "evaluation/conversation.h"
#include "record/record_file.h"

namespace unietp {
namespace {

/// What the agent said in the steps of an episode, from a run or else from the demonstration.
Result<std::vector<std::string>> replies_of(const EpisodeKey& key, const std::filesystem::path& out,
                                            const TaskSource& tasks) {
  std::vector<std::string> replies;
  std::error_code code;
  if (!out.empty() && std::filesystem::exists(out / kEpisodesFile, code)) {
    auto file = RecordFile<EpisodeRecord>::open(out, kEpisodesFile, FileNames::WithFolder, &read_episode);
    if (!file) return file.error();
    while (const auto episode = file->next()) {
      if (!*episode) return episode->error();
      if ((*episode)->key != key) continue;
      for (const EpisodeStep& step : (*episode)->steps) replies.push_back(step.reply);
      return replies;
    }
  }
  const auto shown = tasks.demonstration(*tasks.find(key.task), key.mode);
  if (!shown) return shown.error();
  for (const StepRecord& step : shown->steps) replies.push_back(command_to_json(step.command).dump());
  return replies;
}

void print_request(const ModelOptions& model, const std::vector<ChatTurn>& turns, const Environment& environment) {
  std::fputs(display_text(turns).c_str(), stdout);
  if (model.talk.structured)
    std::printf("[schema of the reply]\n%s\n", answer_schema(environment, model.talk.thinking).c_str());
}

Result<Done> print_step(const EpisodeKey& key, int step, const std::filesystem::path& out,
                        const EvaluateRequest& request, const TaskSource& tasks) {
  const auto task = tasks.task(key.task);
  if (!task) return task.error();
  auto environment = Environment::make(*task, request.settings.at(key.mode));
  if (!environment) return environment.error();
  Conversation conversation(request.model->prompt, request.model->talk);
  std::vector<std::string> replies;
  if (step > 1) {
    auto before = replies_of(key, out, tasks);
    if (!before) return before.error();
    replies = std::move(*before);
  }
  for (int i = 1;; ++i) {
    const auto turns = conversation.turns(*environment);
    if (!turns) return turns.error();
    if (i == step) {
      print_request(*request.model, *turns, *environment);
      return Done{};
    }
    if (static_cast<std::size_t>(i) > replies.size() || environment->over())
      return Error{Error::Kind::Usage,
                   "--show-prompt",
                   {},
                   "the episode has " + std::to_string(i - 1) + " steps that are known"};
    conversation.answered(replies[static_cast<std::size_t>(i) - 1]);
    (void)environment->step(replies[static_cast<std::size_t>(i) - 1]);
  }
}

}  // namespace

Exit show_prompt(const std::string& place, const std::filesystem::path& out, const EvaluateRequest& request,
                 const TaskSource& tasks) {
  const auto colon = place.rfind(':');
  int step = 0;
  const char* end = place.data() + place.size();
  const auto read = std::from_chars(place.data() + std::min(colon, place.size() - 1) + 1, end, step);
  if (colon == std::string::npos || read.ec != std::errc() || read.ptr != end || step < 1)
    return refuse({Error::Kind::Usage, "--show-prompt", {}, "expected TASK:STEP, as in ai2thor-00001:3"});
  if (!request.model)
    return refuse({Error::Kind::Usage, "--show-prompt", {}, "a policy is sent no prompt; leave out --policy"});
  if (request.selection.modes.size() > 1)
    return refuse({Error::Kind::Usage, "--show-prompt", {}, "name the mode whose prompt you want, as in --modes M2"});
  const EpisodeKey key{place.substr(0, colon), request.selection.modes.front(), 1};
  const auto done = print_step(key, step, out, request, tasks);
  return done ? Exit::Ok : refuse(done.error());
}

Exit show_plan(const EpisodePlan& plan, const EvaluateRequest& request, const TaskSource& tasks) {
  std::printf("%zu episodes, %d at a time; nothing is sent\n", plan.episodes.size(), request.at_once);
  if (!request.model) return Exit::Ok;
  const EpisodeKey& first = plan.episodes.front().key;
  std::printf("first prompt, of %s in %s:\n\n", first.task.c_str(), std::string(name_of(first.mode)).c_str());
  const auto done = print_step(first, 1, {}, request, tasks);
  return done ? Exit::Ok : refuse(done.error());
}

}  // namespace unietp
