#include "exports/habitat_episode.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <nlohmann/json.hpp>

#include "interchange/habitat_assets.h"
#include "interchange/habitat_frame.h"
#include "scene/trace.h"
#include "simulation/shape.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }

/// Rows of the matrix that turns the object's frame into Habitat's world.
Json transform(const Pose& pose) {
  const Eigen::Matrix3d turn = rotation_to_habitat(pose.rotation).toRotationMatrix();
  const Vec3 at = to_habitat(pose.position);
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) {
    rows.push_back({rounded(turn(row, 0)), rounded(turn(row, 1)), rounded(turn(row, 2)), rounded(at[row])});
  }
  rows.push_back({0.0, 0.0, 0.0, 1.0});
  return rows;
}

/// Id of what a thing is on or inside; "" for the floor, the hand and rooms.
std::string holder_of(const Scene& scene, const std::string& id) {
  for (const Edge& edge : scene.edges) {
    if (edge.from == id && (edge.relation == Predicate::Inside || edge.relation == Predicate::On)) return edge.to;
  }
  return "";
}

class EpisodeWriter {
 public:
  EpisodeWriter(const FinishedTask& task, const std::map<std::string, std::string>& names)
      : task_(task), start_(task.start), names_(names), end_(task.start) {
    for (const StepRecord& step : task.shown.at(Mode::M1).steps) end_ = apply(std::move(end_), step.changes);
  }

  Json write() {
    Json rigid = Json::array();
    std::map<std::string, int> count;
    for (const Node& node : start_.nodes) {
      if (!node.movable || node.openable) continue;
      const std::string name = habitat_template_name(node);
      std::array<char, 16> number{};
      std::snprintf(number.data(), number.size(), "_:%04d", count[name]++);
      names_[node.id] = name + number.data();
      rigid.push_back({name + ".object_config.json", transform(node.pose)});
    }
    targets();
    const std::string scene = "scenes/" + task_.record.id + ".scene_instance.json";
    return {{"episode_id", task_.record.id},
            {"scene_id", kHabitatRoot + scene},
            {"scene_dataset_config", kHabitatRoot + std::string("unietp.scene_dataset_config.json")},
            {"additional_obj_config_paths", {kHabitatRoot + std::string("objects")}},
            {"start_position", start_position()},
            {"start_rotation", start_rotation()},
            {"info", info()},
            {"ao_states", openings()},
            {"rigid_objs", std::move(rigid)},
            {"targets", std::move(targets_)},
            {"markers", Json::array()},
            {"target_receptacles", std::move(from_)},
            {"goal_receptacles", std::move(to_)},
            {"name_to_receptacle", Json::object()}};
  }

 private:
  Json start_position() const {
    const Vec3 at = to_habitat({start_.agent.position.x(), start_.agent.position.y(), 0});
    return {rounded(at.x()), rounded(at.y()), rounded(at.z())};
  }

  /// As x, y, z, w. An agent that is not turned looks along -z.
  Json start_rotation() const {
    const double half = (start_.agent.yaw - std::numbers::pi / 2) / 2;
    return {0.0, rounded(std::sin(half)), 0.0, rounded(std::cos(half))};
  }

  /// Positions of the joints of what stands open, by link.
  Json openings() const {
    Json states = Json::object();
    for (const Node& node : start_.nodes) {
      if (!node.openable || node.opening <= 0 || !names_.contains(node.id)) continue;
      const auto joints = shape_of(node).joints;
      Json positions = Json::object();
      for (std::size_t i = 0; i < joints.size(); ++i) {
        positions[std::to_string(i)] = rounded(std::abs(joints[i].travel) * node.opening);
      }
      states[names_.at(node.id)] = std::move(positions);
    }
    return states;
  }

  void targets() {
    for (const Node& node : start_.nodes) {
      if (!node.movable || node.openable) continue;
      const Node* const last = find_node(end_, node.id);
      const std::string from = holder_of(start_, node.id), to = holder_of(end_, node.id);
      if (last == nullptr || from == to || to.empty()) continue;
      labels_[names_.at(node.id)] = "any_targets|" + std::to_string(labels_.size());
      targets_[names_.at(node.id)] = transform(last->pose);
      from_.push_back({handle(from), nullptr});
      to_.push_back({handle(to), nullptr});
    }
  }

  std::string handle(const std::string& id) const {
    const auto found = names_.find(id);
    return found == names_.end() ? "" : found->second;
  }

  Json info() const {
    Json plan = Json::array();
    for (const StepRecord& step : task_.shown.at(Mode::M1).steps) plan.push_back(command_to_json(step.command));
    Json names = Json::object();
    for (const Node& node : start_.nodes) names[node.id] = handle(node.id);
    const TaskRecord& task = task_.record;
    return {{"object_labels", labels_},
            {"unietp",
             {{"task", task.id},
              {"template", task.template_name},
              {"split", task.split},
              {"instruction", task.instruction},
              {"goal", task.goal_text},
              {"names", std::move(names)},
              {"plan", std::move(plan)}}}};
  }

  const FinishedTask& task_;
  const Scene& start_;
  std::map<std::string, std::string> names_;
  Scene end_;
  Json labels_ = Json::object(), targets_ = Json::object(), from_ = Json::array(), to_ = Json::array();
};

}  // namespace

Json habitat_episode(const FinishedTask& task, const std::map<std::string, std::string>& names) {
  return EpisodeWriter(task, names).write();
}

}  // namespace unietp
