// The export in the format of the paper's authors: what their loader asks for, and goals that mean the same in their
// evaluator and in ours on every trace at hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <numeric>

#include "core/files.h"
#include "data_set.h"
#include "logic/evaluate.h"
#include "record/task_record.h"
#include "release_reader.h"
#include "scene/scene_json.h"
#include "scene/trace.h"
#include "schema_checker.h"

namespace unietp::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const std::map<std::string, std::string> kFiles{
    {"ai2thor", "THOR.json"}, {"virtualhome", "VH.json"}, {"habitat", "Hab.json"}, {"behavior", "BEHAVIOR.json"}};

const fs::path& release() {
  static const ScratchFolder kScratch;
  static const fs::path kFolder = [] {
    const auto ended = run_program(
        {"export", small_data_set().string(), "--format", "unietp-release", "--out", kScratch.at("release")});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return fs::path(kScratch.at("release"));
  }();
  return kFolder;
}

/// Every exported element, with the simulator that its file is of.
std::vector<std::pair<std::string, Json>> elements() {
  std::vector<std::pair<std::string, Json>> all;
  for (const auto& [simulator, file] : kFiles) {
    if (!fs::exists(release() / file)) continue;
    for (const auto& element : Json::parse(*read_file(release() / file))) all.emplace_back(simulator, element);
  }
  return all;
}

/// A task's start and every scene after a step of its demonstration.
struct Shown {
  TaskRecord task;
  Scene start;
  std::vector<Delta> changes;
  std::vector<Scene> scenes;
};
std::map<std::string, Shown> shown() {
  std::map<std::string, Shown> all;
  for (const auto& line : json_lines(small_data_set() / "tasks.jsonl")) {
    Shown one;
    one.task = *read_task("tasks.jsonl", 1, line.dump());
    one.start = start_of(small_data_set(), line);
    all[one.task.id] = std::move(one);
  }
  for (const auto& line : json_lines(small_data_set() / "demonstrations" / "M1.jsonl")) {
    const auto read = *read_demonstration("M1.jsonl", 1, line.dump());
    Shown& one = all[read.task];
    one.scenes = {one.start};
    one.changes = changes_by_moment(read);
    for (const Delta& change : one.changes) one.scenes.push_back(apply(one.scenes.back(), change));
  }
  return all;
}

/// What their scene graph of a simulator shows of a scene of ours, by the tables of the release; `names` are those of
/// objects that a reference is made to.
ReleaseGraph graph_of(const Scene& scene, const std::string& simulator, const Json& names) {
  const bool thor = simulator == "ai2thor", behavior = simulator == "behavior", habitat = simulator == "habitat";
  const auto name = [&](const std::string& id) { return names.value(id, id); };
  ReleaseGraph graph;
  graph.nodes["robot_agent"].category = "agent";
  for (const Room& room : scene.rooms) {
    std::string category = room.type;
    if (thor)
      category = std::map<std::string, std::string>{{"kitchen", "Kitchen"},
                                                    {"living_room", "LivingRoom"},
                                                    {"bedroom", "Bedroom"},
                                                    {"bathroom", "Bathroom"}}[room.type];
    if (simulator == "virtualhome" && category == "living_room") category = "livingroom";
    if (behavior) category = category.substr(0, category.find('_'));
    graph.nodes[room.id].category = category;
  }
  for (const Node& node : scene.nodes) {
    auto& own = graph.nodes[name(node.id)];
    own.category = behavior && node.category.starts_with("half_") ? node.category.substr(5) + "Sliced" : node.category;
    for (const State& state : node.states.all()) {
      const std::string word(info(state.predicate).name);
      const bool door = word == "open" || word == "closed", power = word == "power_on" || word == "power_off";
      if (!door && (habitat || (simulator == "virtualhome" && !power))) continue;
      if (habitat && power) continue;
      if (word == "filled") own.states["filled_with_liquid"] = {{"liquid_type", state.symbol}};
      if (word == "empty") own.states["no_liquid"] = nullptr;
      if (word == "covered" && behavior) own.states["covered"] = {{"systems", {state.symbol}}};
      if (word == "raw") own.states["not_cooked"] = nullptr;
      if (word == "room_temperature") own.states["normal_temperature"] = nullptr;
      if (word == "unburnt") own.states["not_burnt"] = nullptr;
      if (word == "soaked") own.states["saturated"] = nullptr;
      if (word == "dry") own.states["not_saturated"] = nullptr;
      for (const char* same : {"open", "closed", "power_on", "power_off", "clean", "dirty", "hot", "cool", "cooked",
                               "burnt", "used_up", "broken"}) {
        if (word == same) own.states[word] = nullptr;
      }
    }
  }
  for (const Edge& edge : scene.edges) {
    const auto from = edge.from == "agent" ? std::string("robot_agent") : name(edge.from), to = name(edge.to);
    if (edge.relation == Predicate::On) graph.edges.insert({from, "on_receptacle", to});
    if (edge.relation == Predicate::Inside) graph.edges.insert({from, "inside_receptacle", to});
    if (edge.relation == Predicate::OnFloor && thor) graph.edges.insert({from, "on_room_floor", to});
    if (edge.relation == Predicate::InRoom && (edge.from == "agent" || (!thor && !habitat)))
      graph.edges.insert({from, "inside_room", to});
  }
  if (const Room* room = room_at(scene, scene.agent.position); room != nullptr)
    graph.edges.insert({"robot_agent", "inside_room", room->id});
  for (const auto& id : scene.agent.held) graph.edges.insert({"robot_agent", "grasping", name(id)});
  return graph;
}

/// Orders in which the states of a demonstration are read: each beginning of it; and, where nothing is born or gone,
/// back to the start, and the way there backwards.
std::vector<std::vector<std::size_t>> orders(const Shown& one) {
  std::vector<std::vector<std::size_t>> all;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < one.scenes.size(); ++i) {
    order.push_back(i);
    all.push_back(order);
  }
  const bool same = std::all_of(one.scenes.begin(), one.scenes.end(),
                                [&](const Scene& scene) { return scene.nodes.size() == one.start.nodes.size(); });
  if (!same) return all;
  order.push_back(0);
  all.push_back(order);
  std::reverse(order.begin() + 1, order.end());
  all.push_back(order);
  return all;
}

TEST(ExportRelease, EachGoalMeansTheSameInTheirEvaluatorAndInOurs) {
  const auto ours = shown();
  std::size_t compared = 0, met = 0;
  for (const auto& [simulator, element] : elements()) {
    const Shown& one = ours.at(element["unietp"]["task"]);
    SCOPED_TRACE(one.task.id + " " + one.task.goal_text);
    const Json names = element["unietp"].value("referents", Json::object());
    Json references = element["unietp"].value("object_reference", Json::object());
    if (!element["sampled_scenes"].empty())
      references = element["sampled_scenes"][0].value("object_reference", Json::object());
    std::vector<ReleaseGraph> graphs;
    for (const auto& scene : one.scenes) graphs.push_back(graph_of(scene, simulator, names));
    const Trace whole = to_logic(one.start, one.changes, true);
    for (const auto& order : orders(one)) {
      Trace trace{whole.entities, {}};
      std::vector<ReleaseGraph> theirs;
      for (const auto at : order) {
        trace.states.push_back(whole.states[at]);
        theirs.push_back(graphs[at]);
      }
      const bool expected = holds(one.task.goal_tree, trace);
      try {
        ASSERT_EQ(release_goal_holds(element["logic_dict"], theirs, references), expected) << element["logic_dict"];
      } catch (const ReleaseError& error) {
        FAIL() << error.what() << " in " << element["logic_dict"];
      }
      ++compared;
      met += expected ? 1 : 0;
    }
    EXPECT_FALSE(release_goal_holds(element["logic_dict"], {graphs.front()}, references)) << "true at the start";
    EXPECT_TRUE(release_goal_holds(element["logic_dict"], graphs, references));
  }
  EXPECT_GT(compared, 100U);
  EXPECT_GT(met, 20U);
}

TEST(ExportRelease, RecordsHoldWhatTheirLoaderAsksFor) {
  SchemaChecker checker;
  for (const auto& [simulator, element] : elements()) {
    SCOPED_TRACE(element["unietp"]["task"].get<std::string>());
    EXPECT_EQ(checker.check(element, "release.schema.json"), "");
    if (element["unietp"].contains("scene_file")) {
      EXPECT_TRUE(fs::exists(release() / element["unietp"]["scene_file"].get<std::string>()));
    }
    if (simulator == "ai2thor" || simulator == "behavior") continue;
    ASSERT_EQ(element["sampled_scenes"].size(), 1U);
    const Json& record = element["sampled_scenes"][0];
    if (simulator == "habitat") {
      for (const char* list : {"all_placement", "all_state_change", "all_new_placement"}) {
        EXPECT_TRUE(record.at(list).is_array());
      }
      EXPECT_TRUE(record.at("scene_id").is_string());
      continue;
    }
    EXPECT_TRUE(record.at("scene_id").is_number());
    for (const Json& node : record.at("vheg").at("nodes")) {
      for (const Json& state : node["states"]) {
        const Json needed = state == "OPEN" || state == "CLOSED" ? "CAN_OPEN" : "HAS_SWITCH";
        EXPECT_TRUE(state == "OPEN" || state == "CLOSED" || state == "ON" || state == "OFF") << state;
        EXPECT_NE(std::find(node["properties"].begin(), node["properties"].end(), needed), node["properties"].end());
      }
    }
    const Json references = record.value("object_reference", Json::object());
    for (const auto& [category, ids] : references.items()) {
      for (const std::string id : ids) {  // "mug_57": node 57, of the class mug
        const auto number = std::stoi(id.substr(id.rfind('_') + 1));
        const auto& nodes = record["vheg"]["nodes"];
        const auto named = std::find_if(nodes.begin(), nodes.end(), [&](const Json& n) { return n["id"] == number; });
        ASSERT_NE(named, nodes.end());
        EXPECT_EQ((*named)["class_name"], category);
        EXPECT_EQ(id.substr(0, id.rfind('_')), category);
      }
    }
  }
}

TEST(ExportRelease, EveryTaskIsThereOrLeftOutWithAReason) {
  SchemaChecker checker;
  std::set<std::string> told;
  for (const auto& [simulator, element] : elements())
    EXPECT_TRUE(told.insert(element["unietp"]["task"].get<std::string>()).second);
  const auto exported = told.size();
  for (const auto& line : json_lines(release() / "left_out.jsonl")) {
    EXPECT_EQ(checker.check(line, "left_out.schema.json"), "");
    EXPECT_TRUE(told.insert(line["task"].get<std::string>()).second);
  }
  EXPECT_EQ(told.size(), json_lines(small_data_set() / "tasks.jsonl").size());
  EXPECT_GE(2 * exported, told.size()) << *read_file(release() / "left_out.jsonl");
  const auto scenes = json_lines(release() / "scenes.jsonl");
  ASSERT_EQ(scenes.size(), exported);
  for (const auto& line : scenes) {
    EXPECT_TRUE(told.contains(line["task"].get<std::string>()));
    EXPECT_FALSE(line["not_said"].empty()) << "no format holds all of a scene";
  }
}

}  // namespace
}  // namespace unietp::testing
