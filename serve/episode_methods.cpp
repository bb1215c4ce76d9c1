#include "serve/episode_methods.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/base64.h"
#include "core/png.h"
#include "environment/observation_json.h"
#include "scene/action.h"
#include "scene/scene_json.h"
#include "serve/parameters.h"
#include "simulation/channel_png.h"
#include "simulation/picture.h"
#include "simulation/viewpoint.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// Runs `run(session, parameters)` for a call to a session. It asks for its parameters and then for their problem.
template <class Run>
MethodResult in_session(const MethodCall& call, Run run) {
  Parameters parameters(call.parameters);
  const auto token = session_token(call, parameters);
  if (!token) return wrong_parameters(parameters.problem().value_or("expected \"session\""));
  Session* session = call.sessions.find(*token, call.now);
  if (session == nullptr) return unknown_session();
  return run(*session, parameters);
}

/// The same for a session that has an episode.
template <class Run>
MethodResult in_episode(const MethodCall& call, Run run) {
  return in_session(call, [&](Session& session, Parameters& parameters) -> MethodResult {
    if (!session.environment) return CallError{CallFailure::NotReset, "there is no episode yet; call `reset` first"};
    return run(session, parameters);
  });
}

Json picture_json(const Environment& environment, bool boxes) {
  Picture picture = environment.picture();
  const auto& seen = environment.observe().boxes;
  if (boxes && seen) {
    for (const ObservedObject& object : *seen) draw_box(picture, object.box, {255, 60, 20});
  }
  const auto bytes = png(picture.width, picture.height, picture.rgb);
  return {{"width", picture.width}, {"height", picture.height}, {"png", bytes ? base64(*bytes) : ""}};
}

/// What `render` asks for.
struct View {
  std::string camera, channel;
  int width = 0, height = 0;
};

/// A side of the image; what no image has is refused where it is drawn.
int side_of(const std::optional<std::uint64_t>& wanted, int own) {
  return wanted ? static_cast<int>(std::min<std::uint64_t>(*wanted, std::numeric_limits<int>::max())) : own;
}

bool is_agents(const View& view) { return viewpoint_named(view.camera) == Viewpoint::Agent; }

MethodResult view_json(const Environment& environment, const View& view) {
  const auto viewpoint = viewpoint_named(view.camera);
  if (!viewpoint) return wrong_parameters("/camera: expected \"agent\", \"behind\" or \"above\"");
  const auto channel = channel_named(view.channel);
  if (!channel) return wrong_parameters("/channel: expected \"color\", \"depth\", \"normals\" or \"instances\"");
  Json answer{{"width", view.width}, {"height", view.height}};
  const auto finish = [&](const Result<std::string>& bytes) { answer["png"] = bytes ? base64(*bytes) : ""; };
  if (*channel == Channel::Color) {
    const auto picture = environment.render(view.width, view.height, *viewpoint);
    if (!picture) return wrong_parameters(picture.error().message);
    finish(png(picture->width, picture->height, picture->rgb));
    return answer;
  }
  const auto channels = environment.channels(view.width, view.height, *viewpoint);
  if (!channels) return wrong_parameters(channels.error().message);
  finish(channel_png(*channels, *channel));
  if (*channel != Channel::Instances) return answer;
  Json ids = Json::array({""});
  for (const Node& node : environment.scene().nodes) ids.push_back(node.id);
  if (*viewpoint != Viewpoint::Agent) ids.push_back("agent");
  answer["ids"] = std::move(ids);
  return answer;
}

/// What the last reset or step of a session gave, with its turn and, if the session wants it, the picture.
Json answer_of(const Session& session) {
  const Environment& environment = *session.environment;
  Json answer{{"task", environment.task()->text.id}, {"turn", session.turn}};
  if (session.step) {
    answer.update(step_to_json(*session.step, session.settings));
  } else {
    answer["observation"] = observation_to_json(environment.observe(), session.settings);
  }
  if (session.pictures) answer["picture"] = picture_json(environment, false);
  return answer;
}

/// Which task `reset` is to begin; at most one is named.
struct WantedTask {
  std::optional<std::string> id;
  std::optional<std::uint64_t> index, seed, procedural;
  std::uint64_t episode = 0;  // of the seed's order

  int named() const { return (id ? 1 : 0) + (index ? 1 : 0) + (seed ? 1 : 0) + (procedural ? 1 : 0); }
};

Result<SharedTask> find_task(const ServedTasks& tasks, const WantedTask& wanted) {
  const auto none = [](std::string message) { return Error{Error::Kind::Usage, "", {}, std::move(message)}; };
  if (wanted.procedural && !tasks.made) return none("the server makes no new tasks");
  if (wanted.procedural) return tasks.made(*wanted.procedural);
  if (!tasks.stored || tasks.stored->size() == 0)
    return none("the server has no data set; \"procedural\" makes a task");
  if (wanted.id) return tasks.stored->task(*wanted.id);
  if (wanted.index) return tasks.stored->task(static_cast<std::size_t>(*wanted.index));
  const auto order = tasks.stored->order(*wanted.seed);
  return tasks.stored->task(order[wanted.episode % order.size()]);
}

/// Errors but those about the call name files, which are none of the client's business.
CallError no_task(const MethodCall& call, const Error& error) {
  if (error.kind == Error::Kind::Usage) return {CallFailure::NoTask, error.message};
  if (error.kind == Error::Kind::Unsatisfiable) return {CallFailure::NoTask, "no task could be made from this seed"};
  if (call.options.log) call.options.log(error);
  return {CallFailure::NoTask, "the task cannot be loaded; the server's log says why"};
}

/// Errors: those of Environment::make.
Result<Done> begin(Session& session, const SharedTask& task) {
  if (session.environment) return session.environment->reset(task);
  auto made = Environment::make(task, session.settings);
  if (!made) return made.error();
  session.environment.emplace(std::move(*made));
  return Done{};
}

}  // namespace

MethodResult reset_method(const MethodCall& call) {
  return in_session(call, [&](Session& session, Parameters& parameters) -> MethodResult {
    WantedTask wanted;
    wanted.id = parameters.text("task");
    wanted.index = parameters.whole("index");
    wanted.seed = parameters.whole("seed");
    wanted.procedural = parameters.whole("procedural");
    const auto episode = parameters.whole("episode");
    if (const auto problem = parameters.problem()) return wrong_parameters(*problem);
    if (wanted.named() > 1) return wrong_parameters("expected one of \"task\", \"index\", \"seed\" and \"procedural\"");
    if (episode && !wanted.seed) return wrong_parameters("\"episode\" counts the tasks of a \"seed\"");
    wanted.episode = episode.value_or(0);
    if (wanted.named() == 0 && !session.environment)
      return wrong_parameters("expected one of \"task\", \"index\", \"seed\" and \"procedural\"");
    if (wanted.named() == 0) {
      session.environment->reset();
    } else {
      const auto task = find_task(call.tasks, wanted);
      if (!task) return no_task(call, task.error());
      if (const auto begun = begin(session, *task); !begun) return no_task(call, begun.error());
    }
    ++session.turn;
    session.step.reset();
    return answer_of(session);
  });
}

MethodResult step_method(const MethodCall& call) {
  return in_episode(call, [&](Session& session, Parameters& parameters) -> MethodResult {
    const Json* said = parameters.any("action");
    if (const auto problem = parameters.problem()) return wrong_parameters(*problem);
    if (said == nullptr) return wrong_parameters("expected \"action\"");
    session.step = session.environment->step(said->is_string() ? said->get<std::string>() : said->dump());
    session.step->executed.clear();
    ++session.turn;
    return answer_of(session);
  });
}

MethodResult observe_method(const MethodCall& call) {
  return in_episode(call, [&](Session& session, Parameters& parameters) -> MethodResult {
    const auto known = parameters.whole("turn");
    if (const auto problem = parameters.problem()) return wrong_parameters(*problem);
    if (known == session.turn) return Json{{"turn", session.turn}};
    return answer_of(session);
  });
}

MethodResult text_method(const MethodCall& call) {
  return in_episode(call, [&](Session& session, Parameters& parameters) -> MethodResult {
    const bool reasoning = parameters.flag("reasoning");
    if (const auto problem = parameters.problem()) return wrong_parameters(*problem);
    return Json{{"prompt", session.environment->prompt(reasoning)}, {"observation", session.environment->text()}};
  });
}

MethodResult actions_method(const MethodCall& call) {
  return in_episode(call, [&](Session& session, Parameters& parameters) -> MethodResult {
    if (const auto problem = parameters.problem()) return wrong_parameters(*problem);
    const ModeRules& rules = session.settings.rules;
    Json offered = Json::array();
    for (const auto& actions : {all_actions(), extension_actions()}) {
      for (const ActionInfo& action : actions) {
        if (!session.environment->task()->data.profile->offers(action.type) || !offers(action, rules)) continue;
        offered.push_back({{"action", action.name},
                           {"argument", name_of(action.argument)},
                           {"class", name_of(action.group)},
                           {"effect", action.effect}});
      }
    }
    return Json{{"actions", std::move(offered)}};
  });
}

MethodResult render_method(const MethodCall& call) {
  return in_episode(call, [&](Session& session, Parameters& parameters) -> MethodResult {
    const bool boxes = parameters.flag("boxes");
    View view;
    view.camera = parameters.text("camera").value_or("agent");
    view.channel = parameters.text("channel").value_or("color");
    const auto width = parameters.whole("width"), height = parameters.whole("height");
    if (const auto problem = parameters.problem()) return wrong_parameters(*problem);
    if (!session.settings.rules.picture) return wrong_parameters("the setting \"picture\" of this session is false");
    const Observation& seen = session.environment->observe();
    view.width = side_of(width, seen.image_width);
    view.height = side_of(height, seen.image_height);
    const bool own = is_agents(view) && channel_named(view.channel) == Channel::Color && !width && !height;
    if (boxes && !own) return wrong_parameters("\"boxes\" are those of the agent's picture in its own size");
    if (own) return picture_json(*session.environment, boxes);
    if ((!is_agents(view) || channel_named(view.channel) == Channel::Instances) && !call.options.privileged)
      return CallError{CallFailure::NotAllowed, "other cameras and \"instances\" need a server with --privileged"};
    return view_json(*session.environment, view);
  });
}

MethodResult state_method(const MethodCall& call) {
  if (!call.options.privileged)
    return CallError{CallFailure::NotAllowed, "the server was not started with --privileged"};
  return in_episode(call, [&](Session& session, Parameters& parameters) -> MethodResult {
    const bool scene = parameters.flag("scene"), expert = parameters.flag("expert");
    if (const auto problem = parameters.problem()) return wrong_parameters(*problem);
    Json state = privileged_to_json(session.environment->privileged());
    if (expert) {
      const auto left = session.environment->expert_steps_left();
      state["expert_steps_left"] = left ? Json(*left) : Json();
    }
    if (scene) state["scene"] = Json::parse(scene_to_json(session.environment->scene()));
    return state;
  });
}

}  // namespace unietp
