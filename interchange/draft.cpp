#include "interchange/draft.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "akb/default_states.h"
#include "core/limits.h"
#include "core/plain_name.h"
#include "core/text.h"
#include "interchange/category_names.h"
#include "interchange/own_ids.h"
#include "scene/archetype_dimensions.h"
#include "scene/fresh_id.h"
#include "scene/near_room.h"
#include "simulation/shape.h"

namespace unietp {
namespace {

using Reason = ImportReason;

constexpr double kThinnestBox_m = 0.002;  // physics needs some thickness
constexpr double kLeaning_rad = 0.05;     // a tilt that physics would not keep
constexpr double kSlab_m = 0.02;          // thickness of a laptop or book that was measured while open
constexpr double kLightest_kg = 0.001;
constexpr double kMostSunk_m = 0.25;  // furniture that reaches deeper below the floor is left as it is

bool finite(const SourceObject& object) {
  return object.pose.position.allFinite() && object.pose.rotation.coeffs().allFinite() && object.size.allFinite() &&
         std::isfinite(object.mass) && std::isfinite(object.opening);
}

/// Rotation nearest to the given one that keeps some axis of the box upright, and how far away that is, radians.
double lean_of(const Quat& rotation) {
  const double upright = (rotation.conjugate() * Vec3::UnitZ()).cwiseAbs().maxCoeff();
  return std::acos(std::clamp(upright, -1.0, 1.0));
}

/// A thing that leans becomes the upright box around it: let go as it is, it would fall.
void stand_up(Node& node) {
  const double yaw = yaw_of(node.pose);
  const Pose straight = upright(node.pose.position, yaw);
  const Bounds around = bounds_of(Pose{Vec3::Zero(), straight.rotation.conjugate() * node.pose.rotation}, node.size);
  node.size = around.high - around.low;
  node.pose = straight;
}

/// The file measured a folding thing with its lid up: the closed body, and how far its lid is open, that fill the box.
void unfold(Node& node) {
  const Vec3 box = node.size;
  const double rise = std::max(box.z() - kSlab_m / 2, kThinnestBox_m);
  double side = box.y(), angle = 2 * std::atan2(box.y(), rise);  // a lid that leans back past upright
  if (angle > kLidTravel_rad) {
    angle = std::asin(std::min(1.0, rise / side));
  } else {
    side = angle > std::numbers::pi / 2 ? rise / std::sin(angle) : box.y();
    angle = std::max(angle, std::numbers::pi / 2);
  }
  node.size = Vec3(box.x(), side, std::min(kSlab_m, box.z()));
  node.pose = node.pose * Pose{Vec3(0, (side - box.y()) / 2, (node.size.z() - box.z()) / 2), Quat::Identity()};
  node.opening = std::clamp(angle / kLidTravel_rad, 0.0, 1.0);
}

/// Cuts furniture off at the floor, below which its doors would stick; by how much, 0 when it does not reach below.
double stand_on_floor(Node& node) {
  const double low = node.pose.position.z() - node.size.z() / 2;
  const bool is_upright = (node.pose.rotation * Vec3::UnitZ()).z() > 1 - 1e-6;
  if (node.movable || !is_upright || low >= 0 || -low > std::min(kMostSunk_m, node.size.z() / 2)) return 0;
  node.size.z() += low;
  node.pose.position.z() -= low / 2;
  return -low;
}

class Placer {
 public:
  Placer(const SourceScene& source, Scene scene, const Knowledge& knowledge, const FormatFacts& facts, bool own_ids)
      : source_(source), knowledge_(knowledge), facts_(facts), own_ids_(own_ids), names_(knowledge) {
    draft_.scene = std::move(scene);
    for (const Room& room : draft_.scene.rooms) ids_.insert(room.id);
    for (const Opening& opening : draft_.scene.openings) ids_.insert(opening.id);
  }

  Draft place() {
    for (std::size_t i = 0; i < source_.objects.size(); ++i) place(i);
    relate();
    draft_.report.objects = static_cast<int>(source_.objects.size());
    draft_.report.placed = static_cast<int>(draft_.scene.nodes.size() + draft_.structure.size());
    return std::move(draft_);
  }

 private:
  void issue(const SourceObject& object, Reason reason, std::string detail) {
    draft_.report.issues.push_back({object.id, object.category, reason, std::move(detail)});
  }

  void place(std::size_t index) {
    const SourceObject& object = source_.objects[index];
    const Asset* asset = object.asset.empty() ? nullptr : knowledge_.asset(object.asset);
    const Category* category = names_.find(object.category);
    if (category == nullptr && asset != nullptr) category = knowledge_.find(asset->category);
    const bool structure = is_of_the_building(object.category, facts_);
    if (category == nullptr && !structure) {
      return issue(object, Reason::UnknownCategory,
                   object.category.empty() ? "the file does not say what it is" : "the knowledge base has none");
    }
    if (category != nullptr) ++draft_.report.known;
    if (!by_id_.try_emplace(object.id, index).second) {
      return issue(object, Reason::DuplicateId, "an earlier object has the same id");
    }
    known_.insert(index);
    if (!finite(object) || std::abs(object.pose.rotation.norm() - 1) > 1e-3 || object.size.minCoeff() < 0) {
      return issue(object, Reason::NotFinite, "its pose or size is not finite");
    }
    if (object.pose.position.cwiseAbs().maxCoeff() > limits::kHomeOffset_m ||
        object.size.maxCoeff() > limits::kImportedObject_m) {
      return issue(object, Reason::TooFar, "its pose or size is larger than a home");
    }
    if (structure) {
      if (category != nullptr) draft_.structure.push_back(index);
      return;
    }
    if (!is_near_a_room(draft_.scene, object.pose.position.head<2>())) {
      return issue(object, Reason::OutsideRooms, "it lies more than half a meter from every room");
    }
    add_node(index, object, *category, asset);
  }

  void add_node(std::size_t index, const SourceObject& object, const Category& category, const Asset* asset) {
    Node node;
    node.category = category.name;
    node.movable = category.movable;
    node.archetype = category.archetype;
    node.openable = knowledge_.has(category.name, "openable");
    node.size = object.size;
    if (node.size.maxCoeff() <= 0 && asset != nullptr) node.size = asset->size;
    if (node.size.maxCoeff() <= 0) {
      node.size = category.size;
      issue(object, Reason::TypicalSize, "neither the file nor the knowledge base has its own");
    }
    if (node.size.maxCoeff() <= 0) return issue(object, Reason::NoSize, "its size is unknown");
    node.size = node.size.cwiseMax(kThinnestBox_m);
    node.mass = std::max(object.mass > 0 ? object.mass : category.mass, kLightest_kg);
    node.pose = {object.pose.position, object.pose.rotation.normalized()};
    node.asset = object.asset;
    set_default_states(node, knowledge_);
    for (const State& state : object.states) set_state(node, object, state);
    open_up(node, object);
    if (lean_of(node.pose.rotation) > kLeaning_rad) {
      if (node.movable) issue(object, Reason::Leaning, "taken as the upright box around it");
      stand_up(node);
    }
    if (const double sunk = stand_on_floor(node); sunk > 0)
      draft_.repairs.push_back({draft_.scene.nodes.size(), RepairKind::Cut, std::nullopt, sunk});
    node.id = id_for(object, category);
    node_of_[index] = draft_.scene.nodes.size();
    draft_.source_of.push_back(index);
    draft_.file_center.push_back(object.pose.position);
    draft_.center_in_node.push_back(inverse(node.pose) * object.pose.position);
    draft_.scene.nodes.push_back(std::move(node));
  }

  void set_state(Node& node, const SourceObject& object, const State& state) {
    for (const StateGroup& group : state_groups()) {
      const auto& predicates = group.predicates;
      if (std::find(predicates.begin(), predicates.end(), state.predicate) == predicates.end()) continue;
      if (knowledge_.has(node.category, group.affordance)) {
        node.states.set(state);
      } else {
        issue(object, Reason::UnknownState,
              "the knowledge base does not give " + node.category + " the state " +
                  std::string(info(state.predicate).name));
      }
    }
  }

  /// Files measure what is open with its lid up, but doors and drawers as if shut.
  void open_up(Node& node, const SourceObject& object) {
    if (!node.openable) return;
    const bool open = object.opening > 0 || node.states.has(Predicate::Open);
    node.states.set({open ? Predicate::Open : Predicate::Closed, {}});
    if (!open) return;
    if (node.archetype == Archetype::Folding) {
      unfold(node);
    } else if (node.archetype == Archetype::Lidded) {
      node.openable = false;  // the box stays as the file has it, open above
    } else {
      node.opening = object.opening > 0 ? std::min(object.opening, 1.0) : 1.0;
    }
  }

  std::string id_for(const SourceObject& object, const Category& category) {
    const std::string own = own_ids_ ? simulators_id(object, source_.simulator, category.name) : "";
    return is_label(own) && ids_.insert(own).second ? own : free_id(category.name);
  }

  std::string free_id(const std::string& category) {
    auto [at, fresh] = stems_.try_emplace(category);
    if (fresh) at->second.first = fresh_id(Scene(), category);
    std::string stem = at->second.first.substr(0, at->second.first.rfind('_') + 1), id;
    do {
      id = stem + std::to_string(++numbers_[stem]);
    } while (!ids_.insert(id).second);
    return id;
  }

  void relate() {
    std::map<std::size_t, std::vector<std::size_t>> holders;
    for (const auto& [id, index] : by_id_) {
      const SourceObject& object = source_.objects[index];
      if (!known_.contains(index)) continue;
      for (const SourceRelation& relation : object.held_by) {
        const auto receptacle = by_id_.find(relation.receptacle);
        if (receptacle == by_id_.end()) {
          if (!in_file(relation.receptacle)) {
            issue(object, Reason::UnknownReceptacle, "the file has no object " + relation.receptacle);
          }
          continue;
        }
        if (holds(holders, index, receptacle->second)) {
          issue(object, Reason::CyclicContainment, "it would hold " + relation.receptacle + ", which holds it");
          continue;
        }
        holders[index].push_back(receptacle->second);
        draft_.relations.push_back(
            {relation.kind, index, receptacle->second, node_at(index), node_at(receptacle->second)});
      }
    }
    std::sort(draft_.relations.begin(), draft_.relations.end(), [](const auto& a, const auto& b) {
      return std::pair(a.object, a.receptacle) < std::pair(b.object, b.receptacle);
    });
  }

  bool in_file(const std::string& id) {
    if (all_ids_.empty()) {
      for (const SourceObject& object : source_.objects) all_ids_.insert(object.id);
    }
    return all_ids_.contains(id);
  }

  /// Whether `holder` is held by `index`, directly or through others.
  static bool holds(const std::map<std::size_t, std::vector<std::size_t>>& holders, std::size_t index,
                    std::size_t holder) {
    std::set<std::size_t> seen{holder};
    std::vector<std::size_t> open{holder};
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      if (at == index) return true;
      const auto above = holders.find(at);
      if (above == holders.end()) continue;
      for (const std::size_t next : above->second) {
        if (seen.insert(next).second) open.push_back(next);
      }
    }
    return false;
  }

  std::optional<std::size_t> node_at(std::size_t index) const {
    const auto found = node_of_.find(index);
    return found == node_of_.end() ? std::nullopt : std::optional(found->second);
  }

  const SourceScene& source_;
  const Knowledge& knowledge_;
  const FormatFacts& facts_;
  bool own_ids_;
  CategoryNames names_;
  Draft draft_;
  std::map<std::string, std::size_t> by_id_;    // known objects of the file
  std::map<std::size_t, std::size_t> node_of_;  // node of an object of the file
  std::set<std::size_t> known_;
  std::set<std::string> ids_, all_ids_;
  std::map<std::string, std::pair<std::string, int>> stems_;
  std::map<std::string, int> numbers_;
};

}  // namespace

Draft draft_of(const SourceScene& source, Scene scene, const Knowledge& knowledge, const FormatFacts& facts,
               bool own_ids) {
  return Placer(source, std::move(scene), knowledge, facts, own_ids).place();
}

Bounds box_of(const Node& node) { return bounds_of(shape_of(node), node.pose, node.opening); }

}  // namespace unietp
