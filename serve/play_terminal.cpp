#include "serve/play_terminal.h"

#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/in_quotes.h"
#include "core/text.h"
#include "serve/play_text.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

struct PlayTerminal::Impl {
  Protocol* protocol;
  PlayChoice choice;
  std::string token, task;
  std::uint64_t played = 0;  // tasks before this one, of the order or of the seeds
  Json observation;
  std::uint64_t turn = 0;
  double reward = 0;  // of the last step
  std::vector<ListedThing> listed;
  std::vector<std::string> actions;
  bool is_over = false;

  /// The result of a method. Errors: Usage, with what the protocol says.
  Result<Json> call(const std::string& method, Json parameters = Json::object()) {
    if (!token.empty()) parameters["session"] = token;
    const auto answered = protocol->call(method, parameters.dump(), std::chrono::steady_clock::now());
    Json answer = Json::parse(answered.body);
    if (answered.failure) return Error{Error::Kind::Usage, "", {}, answer["error"]["message"].get<std::string>()};
    return answer;
  }

  void take(Json& answer) {
    observation = std::move(answer["observation"]);
    turn = answer["turn"].get<std::uint64_t>();
    task = answer.value("task", task);
    reward = answer.value("reward", 0.0);
    listed = things_of(observation, "boxes");
  }

  Json wanted() const {
    if (choice.procedural) return {{"procedural", choice.seed + played}};
    if (choice.task && played == 0) return {{"task", *choice.task}};
    return {{"seed", choice.seed}, {"episode", choice.task ? played - 1 : played}};
  }

  Result<Done> reset(Json parameters) {
    auto answer = call("reset", std::move(parameters));
    if (!answer) return answer.error();
    take(*answer);
    const auto offered = call("actions");
    if (!offered) return offered.error();
    actions.clear();
    for (const auto& action : (*offered)["actions"]) actions.push_back(action["action"]);
    return Done{};
  }

  std::string task_text() const {
    return "Task " + for_terminal(task) + ": " + for_terminal(observation.value("instruction", "")) + "\n";
  }

  std::string standing() const {
    if (!observation.value("over", false)) {
      const bool tells = observation.contains("boxes");
      const auto seen = listing_text("In view", things_of(observation, "boxes"), 1);
      return standing_text(observation) + (!tells ? "" : seen.empty() ? "Nothing is in view.\n" : seen);
    }
    return std::string("The episode is over: the goal is ") + (reward > 0 ? "" : "not ") +
           "reached. `again`, `next` or `quit`?\n";
  }

  std::string step(const std::string& action) {
    auto answer = call("step", {{"action", action}});
    if (!answer) return answer.error().message + "\n";
    take(*answer);
    return results_text(observation) + standing();
  }

  std::string again(Json parameters) {
    if (const auto done = reset(std::move(parameters)); !done) return for_terminal(done.error().message) + "\n";
    return task_text() + standing();
  }

  std::string home(const std::string& word) {
    std::string text;
    std::vector<ListedThing> all;
    for (const auto& [list, title] :
         {std::pair("rooms", "Rooms"), {"furniture", "Furniture"}, {"movables", "Small things"}}) {
      const auto things = things_of(observation, list, word);
      text += listing_text(title, things, all.size() + 1);
      all.insert(all.end(), things.begin(), things.end());
    }
    if (all.empty()) return "You know of nothing" + (word.empty() ? "" : " with " + in_quotes(word)) + ".\n";
    listed = std::move(all);
    return text;
  }
};

PlayTerminal::PlayTerminal(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PlayTerminal::PlayTerminal(PlayTerminal&&) noexcept = default;
PlayTerminal& PlayTerminal::operator=(PlayTerminal&&) noexcept = default;
PlayTerminal::~PlayTerminal() = default;

Result<PlayTerminal> PlayTerminal::open(Protocol& protocol, const PlayChoice& choice) {
  auto impl = std::make_unique<Impl>();
  impl->protocol = &protocol;
  impl->choice = choice;
  const auto opened = impl->call("open", {{"mode", choice.mode}});
  if (!opened) return opened.error();
  impl->token = (*opened)["session"];
  if (const auto done = impl->reset(impl->wanted()); !done) return done.error();
  return PlayTerminal(std::move(impl));
}

const std::string& PlayTerminal::session() const { return impl_->token; }

std::string PlayTerminal::begin() const { return impl_->task_text() + impl_->standing(); }

std::string PlayTerminal::typed(std::string_view line) {
  const std::string text(trim(line));
  const auto blank = text.find(' ');
  const std::string word = lower(text.substr(0, blank));
  const std::string rest(blank == std::string::npos ? "" : trim(std::string_view(text).substr(blank)));
  if (word == "home") return impl_->home(rest);
  if (rest.empty()) {
    if (word == "quit") impl_->is_over = true;
    if (word == "quit") return "";
    if (word == "help") return play_help();
    if (word == "task") return impl_->task_text();
    if (word == "again") return impl_->again(Json::object());
    if (word.empty() || word == "look") {
      impl_->listed = things_of(impl_->observation, "boxes");
      return impl_->standing();
    }
    if (word == "next") {
      ++impl_->played;
      return impl_->again(impl_->wanted());
    }
    if (word == "actions") {
      const auto answer = impl_->call("actions");
      return answer ? actions_text((*answer)["actions"]) : answer.error().message + "\n";
    }
  }
  const auto action = typed_action(text, impl_->actions, impl_->listed);
  return action ? impl_->step(*action) : for_terminal(action.error().message) + "\n";
}

std::string PlayTerminal::watch() {
  auto answer = impl_->call("observe", {{"turn", impl_->turn}});
  if (!answer || !answer->contains("observation")) return "";
  impl_->take(*answer);
  const bool begins = impl_->observation.value("step", 0) == 0 && !impl_->observation.value("over", false);
  return (begins ? impl_->task_text() : results_text(impl_->observation)) + impl_->standing();
}

bool PlayTerminal::is_over() const { return impl_->is_over; }

}  // namespace unietp
