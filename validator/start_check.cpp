#include "validator/start_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "akb/default_states.h"
#include "core/text.h"
#include "scene/start.h"

namespace unietp {
namespace {

bool is_among_names(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether two states belong to one group of exclusive ones, or are the same.
bool in_one_group(Predicate a, Predicate b) {
  if (a == b) return true;
  const auto& groups = state_groups();
  return std::any_of(groups.begin(), groups.end(), [&](const StateGroup& group) {
    const auto& own = group.predicates;
    return std::find(own.begin(), own.end(), a) != own.end() && std::find(own.begin(), own.end(), b) != own.end();
  });
}

bool has_group(Predicate predicate) {
  const auto& groups = state_groups();
  return std::any_of(groups.begin(), groups.end(), [&](const StateGroup& group) {
    return std::find(group.predicates.begin(), group.predicates.end(), predicate) != group.predicates.end();
  });
}

/// Whether both have a state of the same groups. What belongs to no group, such as being covered, comes and goes.
bool same_groups(const StateSet& a, const StateSet& b) {
  const auto all = [](const StateSet& states, const StateSet& in) {
    const auto& others = in.all();
    return std::all_of(states.all().begin(), states.all().end(), [&](const State& state) {
      return !has_group(state.predicate) || std::any_of(others.begin(), others.end(), [&](const State& other) {
        return in_one_group(state.predicate, other.predicate);
      });
    });
  };
  return all(a, b) && all(b, a);
}

/// What cannot be so of an object's color and material; "" when nothing is wrong.
std::string look_fault(const Node& node, const Category* category) {
  if (category == nullptr) return "";
  if (!node.color.empty() && !is_among_names(category->colors, node.color))
    return "has the color " + node.color + ", in which a " + node.category + " does not come";
  if (!node.material.empty() && !is_among_names(category->materials, node.material))
    return "has the material " + node.material + ", of which a " + node.category + " is not made";
  return "";
}

/// What cannot be so of an object's model; "" when nothing is wrong.
std::string model_fault(const Node& node, const Knowledge& knowledge) {
  const Asset* asset = node.asset.empty() ? nullptr : knowledge.asset(node.asset);
  if (node.asset.empty() || (asset != nullptr && asset->category == node.category)) return "";
  return "has the model " + node.asset + ", which is none of a " + node.category;
}

/// What cannot be so of an object that is not in the home; "" when nothing is wrong.
std::string new_object_fault(const Node& node, const Knowledge& knowledge) {
  if (!node.slice_of.empty()) return "";  // as cutting makes it
  const Category* category = knowledge.find(node.category);
  if (category == nullptr) return "is of the category " + node.category + ", which the knowledge base does not have";
  if (node.movable != category->movable || node.archetype != category->archetype ||
      node.openable != knowledge.has(category->name, "openable"))
    return "is not built as a " + node.category + " is";
  if (auto fault = model_fault(node, knowledge); !fault.empty()) return fault;
  if (!node.boards.empty()) return "has solids of its own";
  const double density = category->mass / category->size.prod(), own = node.mass / node.size.prod();
  if (std::abs(own - density) > 1e-9 * density) return "does not have the mass of a " + node.category + " of its size";
  if (auto fault = look_fault(node, category); !fault.empty()) return fault;
  if (node.color.empty() != category->colors.empty() || node.material.empty() != category->materials.empty())
    return "lacks a color or material, or has one too many";
  Node plain = node;
  plain.states = {};
  set_default_states(plain, knowledge);
  if (!same_groups(plain.states, node.states)) return "has states that a " + node.category + " does not have";
  return "";
}

/// What cannot have changed of an object of the home, which may have another model if it is `resized`; "" when nothing
/// is wrong.
std::string changed_object_fault(const Node& before, const Node& now, bool resized, const Knowledge& knowledge) {
  if (now.category != before.category || now.movable != before.movable || now.archetype != before.archetype ||
      now.openable != before.openable || (now.asset != before.asset && !resized) || now.boards != before.boards ||
      now.slice_of != before.slice_of || now.whole_category != before.whole_category)
    return "is built differently than in the home";
  if (auto fault = model_fault(now, knowledge); resized && !fault.empty()) return fault;
  const double density = before.mass / before.size.prod(), own = now.mass / now.size.prod();
  if (std::abs(own - density) > 1e-9 * density) return "has a different density than in the home";
  if (!same_groups(before.states, now.states)) return "has other kinds of states than in the home";
  if (now.color != before.color || now.material != before.material)
    return look_fault(now, knowledge.find(now.category));
  return "";
}

/// Follows the edits in words from the home to the start.
class EditsCheck {
 public:
  EditsCheck(const TaskRecord& task, const Scene& home, const Scene& start) : task_(task), start_(start) {
    for (const Node& node : home.nodes) present_[node.id];
    for (const auto& edit : task.edits) follow(edit);
    compare();
  }

  /// Whether an edit made an object larger or smaller.
  bool is_resized(const std::string& id) const { return resized_.contains(id); }
  const std::vector<std::string>& faults() const { return faults_; }

 private:
  void follow(const std::string& edit) {
    const auto wrong = [&](const char* why) { faults_.push_back("say \"" + edit + "\", " + why); };
    const auto words = split(edit, ' ');
    if (edit.starts_with("the agent starts in ")) {
      if (!task_.changes.agent) wrong("but the agent stands where it stands in the home");
    } else if (words.size() < 2) {
      wrong("which names nothing");
    } else if (words[0] == "added" && words.size() > 3) {
      if (!present_.emplace(words[2], Present{words[1]}).second) wrong("but there is one already");
    } else if (words[0] == "removed" && words.size() == 2) {
      if (present_.erase(words[1]) == 0) wrong("but there is none");
    } else if (words[0] == "moved" || words[0] == "made") {
      if (!present_.contains(words[1])) wrong("but there is none");
      if (words[0] == "made" && !is_so(words)) wrong("but it is not so");
      if (words[0] == "made" && (words.back() == "larger" || words.back() == "smaller")) resized_.insert(words[1]);
    } else {
      wrong("which is none of added, removed, moved, made, the agent starts");
    }
    // They tell what was changed in the end, not what was tried on the way.
    const std::size_t id = words[0] == "added" ? 2 : 1;
    const bool of_place = words[0] == "added" || words[0] == "removed" || words[0] == "moved";
    if (of_place && words.size() > id && !placed_.insert(words[id]).second) wrong("a second time");
  }

  /// Whether a thing of the start has the state that "made mug_1 filled water" gives it; true for other properties.
  bool is_so(const std::vector<std::string>& words) const {
    const Node* node = find_node(start_, words[1]);
    const auto predicate = words.size() > 2 ? predicate_named(words[2]) : std::nullopt;
    if (node == nullptr || !predicate) return node != nullptr;
    return node->states.has(State{*predicate, words.size() > 3 ? words[3] : ""});
  }

  /// The objects that the edits lead to are those of the start.
  void compare() {
    for (const Node& node : start_.nodes) {
      const auto found = present_.find(node.id);
      if (found == present_.end()) {
        faults_.push_back("do not say that " + node.id + " was added");
        continue;
      }
      auto& [category, in_start] = found->second;
      in_start = true;
      if (!category.empty() && category != node.category)
        faults_.push_back("say that " + node.id + " is a " + category + ", but it is a " + node.category);
    }
    for (const auto& [id, one] : present_) {
      if (!one.in_start) faults_.push_back("do not say that " + id + " was removed");
    }
  }

  struct Present {
    std::string category;  // of an added object; "" of one of the home
    bool in_start = false;
  };

  const TaskRecord& task_;
  const Scene& start_;
  std::map<std::string, Present> present_;  // by id
  std::set<std::string> resized_;
  std::set<std::string> placed_;  // ids that were said to come, to go or to move
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<Problem> check_start(const TaskRecord& task, const Scene& home, const Scene& start,
                                 const Knowledge& knowledge, const std::string& where) {
  std::vector<Problem> problems;
  const auto found = [&](std::string message) {
    problems.push_back(problem_in(ProblemKind::Edits, where, std::move(message)));
  };
  if (changes_of(home, start) != task.changes) found("the changes of its start are not the shortest ones, in order");
  const EditsCheck edits(task, home, start);
  for (const Node& node : task.changes.nodes) {
    const Node* before = find_node(home, node.id);
    auto fault = before == nullptr ? new_object_fault(node, knowledge)
                                   : changed_object_fault(*before, node, edits.is_resized(node.id), knowledge);
    if (!fault.empty()) found(node.id + " of its start " + std::move(fault));
  }
  for (const auto& fault : edits.faults()) found("the edits of its start " + fault);
  return problems;
}

}  // namespace unietp
