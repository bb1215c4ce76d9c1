#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>

#include <nlohmann/json.hpp>

#include "exports/ai2thor_floor_plan.h"
#include "exports/ai2thor_goal.h"
#include "exports/ai2thor_plan.h"
#include "exports/ai2thor_words.h"
#include "exports/express.h"
#include "exports/moments_of_step.h"
#include "exports/own_scene.h"
#include "interchange/formats.h"
#include "interchange/own_ids.h"
#include "scene/trace.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// Objects that the demonstration names or holds.
std::set<std::string> handled(const FinishedTask& task) {
  const std::vector<std::string>& held = task.start.agent.held;
  std::set<std::string> ids(held.begin(), held.end());
  for (const auto& step : task.shown.at(Mode::M1).steps) {
    for (const auto& argument : step.command.args) {
      if (find_node(task.start, argument.id) != nullptr) ids.insert(argument.id);
    }
  }
  return ids;
}

/// A house, and of each piece of something that the start has, the objectId of the whole that AI2-THOR has to cut.
struct ThorHouse {
  ExportedScene written;
  std::map<std::string, std::string> wholes;
};

/// The whole that such a piece is cut from; nullptr for what is no piece.
const Category* whole_of(const std::string& piece, const Knowledge& knowledge) {
  for (const Effect& effect : knowledge.effects()) {
    if (effect.treatment == Treatment::Slices && effect.gives == piece) return knowledge.find(effect.target);
  }
  return nullptr;
}

/// What AI2-THOR loads. It has no models of pieces: the whole stands where a piece lies, unless that is inside a
/// smaller thing.
Result<ThorHouse> write_house(const FinishedTask& task, const Knowledge& knowledge, const FormatFacts& facts) {
  if (is_floor_plan(task)) return ThorHouse{write_floor_plan(task), {}};
  const Scene& start = task.start;
  Scene scene = start;
  std::map<std::string, std::string> pieces;  // category by id
  for (const Node& node : start.nodes) {
    const Category* const whole = whole_of(node.category, knowledge);
    if (whole == nullptr || !knowledge.asset_rows_of(node.category).empty()) continue;
    const bool too_large = std::any_of(start.edges.begin(), start.edges.end(), [&](const Edge& edge) {
      if (edge.relation != Predicate::Inside || edge.from != node.id) return false;
      const Node* const place = find_node(start, edge.to);
      return place == nullptr || (whole->size.head<2>().array() > place->size.head<2>().array()).any();
    });
    if (too_large) continue;
    pieces[node.id] = node.category;
    Node& stands = *edit_node(scene, node.id);
    stands.category = whole->name;
    stands.archetype = whole->archetype;
    stands.asset.clear();
    stands.boards.clear();
    stands.pose.position.z() += (whole->size.z() - node.size.z()) / 2;
    stands.size = whole->size;
  }
  for (const Node& node : start.nodes) {  // an object of ours may have another model, which can do what it has to
    if (facts.model_lacks.contains(node.asset) && !own_id_of(node, Simulator::Ai2thor))
      edit_node(scene, node.id)->asset.clear();
  }
  const auto listed = [&](const std::string& thing, const std::string& place) {
    return listed_in_ai2thor(knowledge, thing, place);
  };
  auto written = write_procthor(scene, knowledge, facts, listed);
  if (!written) return written.error();
  ThorHouse house{std::move(*written), {}};
  for (const auto& [id, category] : pieces) {
    const auto name = house.written.names.find(id);
    if (name == house.written.names.end()) continue;
    house.wholes[id] = name->second;
    name->second += "|" + category + "_0";
  }
  return house;
}

/// Why an object is not in the house: what its writer says of it.
std::string reason_for(const std::string& id, const ExportedScene& house) {
  for (const std::string& line : house.left_out) {
    if (line.starts_with(id + ": ")) return line.substr(id.size() + 2);
  }
  return "it is not in the house";
}

/// What an action needs of the object that it names, in words for people.
struct ThorNeed {
  std::string_view action, affordance, words;
};
constexpr std::array kThorNeeds{
    ThorNeed{"pick_up", "pickupable", "cannot be picked up"}, ThorNeed{"place_on", "receptacle", "cannot hold things"},
    ThorNeed{"place_in", "container", "cannot hold things"},  ThorNeed{"open", "openable", "does not open"},
    ThorNeed{"close", "openable", "does not open"},           ThorNeed{"turn_on", "switchable", "has no switch"},
    ThorNeed{"turn_off", "switchable", "has no switch"},      ThorNeed{"slice", "sliceable", "cannot be sliced"}};

/// Why a step cannot be done with the models of a house; "" when all can.
std::string denied_by_models(const DemonstrationRecord& shown, const ExportedScene& house, const FormatFacts& facts) {
  for (const StepRecord& step : shown.steps) {
    for (const ThorNeed& need : kThorNeeds) {
      if (step.command.action != need.action || !step.success) continue;
      const auto model = house.models.find(step.command.args.front().id);
      if (model == house.models.end()) continue;
      const auto lacks = facts.model_lacks.find(model->second);
      if (lacks != facts.model_lacks.end() && lacks->second.contains(std::string(need.affordance)))
        return model->second + " " + std::string(need.words) + ", says ProcTHOR's database";
    }
  }
  return "";
}

/// The task without the objects that are not in the house.
FinishedTask in_house(FinishedTask task, const ThorNames& names) {
  std::set<std::string> missing;
  for (const Node& node : task.start.nodes) {
    if (!names.contains(node.id)) missing.insert(node.id);
  }
  const auto without = [&](const Edge& edge) { return missing.contains(edge.from) || missing.contains(edge.to); };
  Delta gone;
  gone.removed.assign(missing.begin(), missing.end());
  for (const Edge& edge : task.start.edges) {
    if (without(edge)) gone.edges_removed.push_back(edge);
  }
  task.start = apply(std::move(task.start), gone);
  const auto take_out = [&](Delta& changes) {
    std::erase_if(changes.nodes, [&](const Node& node) { return missing.contains(node.id); });
    std::erase_if(changes.removed, [&](const std::string& id) { return missing.contains(id); });
    std::erase_if(changes.edges_added, without);
    std::erase_if(changes.edges_removed, without);
  };
  for (auto& step : task.shown.at(Mode::M1).steps) {
    take_out(step.changes);
    for (Delta& moment : step.moments) take_out(moment);
  }
  return task;
}

/// How each place that is in the house holds things, "on" it or "inside"; where both, heights tell which. `parts`: the
/// types of the parts of places that hold them.
struct ThorPlaces {
  Json holds = Json::object(), parts = Json::object();
};

ThorPlaces places_of(const Scene& start, const ThorNames& names, const Knowledge& knowledge) {
  ThorPlaces places;
  for (const Node& node : start.nodes) {
    if (!names.contains(node.id)) continue;
    Json ways = Json::array();
    if (knowledge.has(node.category, "receptacle")) ways.push_back("on");
    if (knowledge.has(node.category, "container")) ways.push_back("inside");
    if (!ways.empty()) places.holds[node.id] = std::move(ways);
    if (const auto part = thor_holding_part(node.category); !part.empty()) places.parts[node.id] = part;
  }
  return places;
}

Json rooms_of(const Scene& start) {
  Json rooms = Json::object();
  const std::vector<std::string> ids = procthor_room_ids(start);
  for (std::size_t i = 0; i < ids.size(); ++i) rooms[start.rooms[i].id] = ids[i];
  return rooms;
}

/// A task as the runner reads it, and its house. Errors: Unsatisfiable, for what AI2-THOR cannot express.
Result<Json> task_json(const FinishedTask& task, ThorHouse& made, const Knowledge& knowledge,
                       const FormatFacts& facts) {
  ExportedScene& house = made.written;
  ThorNames names = house.names;
  std::set<std::string> used = handled(task);
  for (const std::string& id : used) {
    if (!names.contains(id)) {
      const Node* const node = find_node(task.start, id);
      return Error{Error::Kind::Unsatisfiable, "", {}, node->category + ": " + reason_for(id, house)};
    }
  }
  if (std::string denied = denied_by_models(task.shown.at(Mode::M1), house, facts); !denied.empty())
    return Error{Error::Kind::Unsatisfiable, "", {}, std::move(denied)};
  const FinishedTask theirs = in_house(task, names);
  const DemonstrationRecord& shown = theirs.shown.at(Mode::M1);
  auto plan = thor_plan(shown, theirs.start, names);
  if (!plan) return plan.error();
  const auto goal = thor_goal(theirs, names, thor_pieces(theirs, names, made.wholes, knowledge), knowledge);
  if (!goal) return goal.error();
  used.insert(goal->objects.begin(), goal->objects.end());
  auto start = thor_start(theirs.start, names, used, house.left_out);
  if (!start) return start.error();
  if (is_floor_plan(task)) start->insert(start->begin(), Json{{"call", floor_plan_poses(task.start)}});
  for (const auto& [id, whole] : made.wholes) {
    const Json cut{{"action", "SliceObject"}, {"objectId", whole}, {"forceAction", true}};
    const Json one{{"unless", *thor_test({Predicate::Sliced, ""}, whole)}, {"call", cut}};
    start->insert(start->begin(), one);
  }
  ThorPlaces places = places_of(theirs.start, names, knowledge);
  std::size_t at = 0, moment = 0;
  for (const StepRecord& step : shown.steps) {
    const auto moments = moments_of_step(goal->holding, moment, step.moments.size());
    if (!step.success || step.command.action == "stop") continue;
    Json& planned = (*plan)[at++];
    planned["holds"] = moments.back();
    if (moments.size() > 1) planned["moments"] = moments;
  }
  return Json{{"format", "unietp-ai2thor/1"},
              {"task", task.record.id},
              {"template", task.record.template_name},
              {"instruction", task.record.instruction},
              {"house", task.record.id + ".house.json"},
              {"objects", names},
              {"rooms", rooms_of(theirs.start)},
              {"places", std::move(places.holds)},
              {"parts", std::move(places.parts)},
              {"not_said", house.left_out},
              {"start", std::move(*start)},
              {"plan", std::move(*plan)},
              {"goal",
               {{"text", task.record.goal_text},
                {"formula", goal->formula},
                {"propositions", Json::parse(goal->propositions)},
                {"holds", goal->holding.front()}}},
              {"words", thor_words()}};
}

/// For each task of AI2-THOR `<task>.house.json`, its home for CreateHouse, and `<task>.json`, the calls that start it,
/// the demonstration in M1 as calls, and the goal as tests of the metadata; and left_out.jsonl.
Result<ExportSummary> write_ai2thor_files(const ExportRequest& request) {
  return write_expressed(request, express_ai2thor(request));
}

}  // namespace

Result<ExpressTask> express_ai2thor(const ExportRequest& request) {
  auto [facts, wrong] = read_format_facts(request.data / "scene_files");
  if (!wrong.empty()) return wrong.front();
  return ExpressTask([facts = std::move(facts), &request](const FinishedTask& task) -> Result<ExpressedTask> {
    if (task.start.simulator != Simulator::Ai2thor) return ExpressedTask{"not a task of AI2-THOR", nullptr};
    const Knowledge& knowledge = *backend_of(request.backends, task.start).knowledge;
    if (auto why = unlisted_in_ai2thor(task, knowledge); !why.empty()) return ExpressedTask{std::move(why), nullptr};
    auto house = write_house(task, knowledge, facts);
    if (!house) return house.error();
    auto json = task_json(task, *house, knowledge, facts);
    if (!json) return ExpressedTask{json.error().message, nullptr};
    return ExpressedTask{"", [id = task.record.id, json = std::move(*json), text = std::move(house->written.text)] {
                           return Result(std::vector<AssetFile>{
                               {id + ".json", json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"},
                               {id + ".house.json", text}});
                         }};
  });
}

ExportFormat ai2thor_format() {
  return {"ai2thor",
          "AI2-THOR's houses, controller calls and goals on its metadata",
          {},
          true,
          write_ai2thor_files,
          true,
          Simulator::Ai2thor};
}

}  // namespace unietp
