// What may be bound to the parameters of a template, by plain loops over the tables.
#include <algorithm>
#include <set>

#include "core/text.h"
#include "small_home.h"
#include "templates/constraint_kinds.h"

namespace unietp {
namespace {

class ScannedBinding {
 public:
  ScannedBinding(const Binding& binding, const Knowledge& knowledge) : binding_(binding), knowledge_(knowledge) {}

  bool affords(const std::string& parameter, const std::string& wanted) const {
    const auto name = category_of(parameter);
    bool found = wanted == "any";
    for (const auto& known : knowledge_.categories()) {
      if (wanted == "room" || wanted == "colour" || wanted == "material") {
        const auto& words = wanted == "room" ? known.rooms : wanted == "colour" ? known.colors : known.materials;
        found = found || std::find(words.begin(), words.end(), name) != words.end();
      }
      found = found || (known.name == name &&
                        ((wanted == "furniture" && !known.movable) || (wanted == "movable" && known.movable) ||
                         (wanted == "countable" && known.countable)));
    }
    for (const auto& effect : knowledge_.effects())
      found = found || (wanted == "substance" && !name.empty() && effect.gives == name);
    for (const auto& fact : knowledge_.affordances())
      found = found || (fact.category == name && fact.affordance == wanted);
    return found;
  }

  bool holds(const std::string& kind, const std::vector<std::string>& arguments) const {
    if (kind == "distinct") {
      std::set<std::string> names;
      for (const auto& argument : arguments) names.insert(category_of(argument));
      return names.size() == arguments.size();
    }
    if (kind == "comes-in-sizes") return comes_in_sizes(known(arguments[0]));
    if (kind == "comes-in") return comes_in(known(arguments[0]), category_of(arguments[1]));
    if (kind == "same-kind") return same_kind(arguments);
    if (kind.starts_with("fits-")) return fits(replace_all(kind.substr(5), "-", "_"), arguments);
    bool found = false;
    if (kind == "found-in") {
      const auto& rooms = known(arguments[0]).rooms;
      found = std::count(rooms.begin(), rooms.end(), category_of(arguments[1])) > 0;
    } else if (kind == "has-words") {
      for (const auto& alias : knowledge_.aliases())
        found = found || (alias.category == category_of(arguments[0]) && name_of(alias.kind) == arguments[1]);
    } else if (kind == "kind") {
      for (const auto& wider : known(arguments[0]).kinds)
        found = found || std::count(arguments.begin() + 1, arguments.end(), wider) > 0;
    } else {
      for (const auto& row : knowledge_.effects())
        found =
            found || (row.tool == category_of(arguments[0]) && row.target == category_of(arguments[1]) &&
                      name_of(row.treatment) == kind &&
                      (arguments.size() < 3 || row.gives == arguments[2] || row.gives == category_of(arguments[2])));
    }
    return found;
  }

 private:
  /// What an argument stands for: the bound category, or the slices of it for "A/slice".
  std::string category_of(std::string argument) const {
    const bool slice = argument.ends_with("/slice");
    if (slice) argument.resize(argument.size() - 6);
    for (const auto& [name, bound] : binding_) {
      if (name != argument) continue;
      for (const auto& effect : knowledge_.effects()) {
        if (slice && effect.treatment == Treatment::Slices && effect.target == bound && !effect.gives.empty())
          return effect.gives;
      }
      return bound;
    }
    return "";
  }

  const Category& known(const std::string& argument) const { return *knowledge_.find(category_of(argument)); }

  /// Nothing has models here, so everything may be scaled, except what nobody tells apart by its size.
  static bool comes_in_sizes(const Category& category) {
    return std::count(category.traits.begin(), category.traits.end(), KindTrait::OneSize) == 0;
  }

  static bool comes_in(const Category& category, const std::string& value) {
    auto words = category.colors;
    words.insert(words.end(), category.materials.begin(), category.materials.end());
    const auto alike = value == "red" ? "orange" : value == "orange" ? "red" : "";
    return std::count(words.begin(), words.end(), value) == 1 &&
           words.size() > 1 + static_cast<std::size_t>(std::count(words.begin(), words.end(), alike));
  }

  bool same_kind(const std::vector<std::string>& arguments) const {
    const auto is_kind = [](const std::string& word) { return word.front() >= 'a'; };
    const bool listed = is_kind(arguments.back());
    bool found = false;
    for (const auto& wider : known(arguments[0]).kinds) {
      bool all = listed ? std::count(arguments.begin(), arguments.end(), wider) > 0
                        : wider != "thing" && wider != "movable" && wider != "place" && wider != "fixture";
      for (const auto& argument : arguments) {
        if (is_kind(argument)) continue;
        const auto& others = known(argument).kinds;
        all = all && std::count(others.begin(), others.end(), wider) > 0;
      }
      found = found || all;
    }
    return found;
  }

  bool fits(const std::string& relation, const std::vector<std::string>& arguments) const {
    const int wanted = arguments.size() > 2 ? std::stoi(arguments[2]) : 1;
    bool found = false;
    for (const auto& row : knowledge_.placements()) {
      found = found || (row.object == category_of(arguments[0]) && row.receptacle == category_of(arguments[1]) &&
                        info(row.relation).name == relation && row.capacity >= wanted);
    }
    return found;
  }

  const Binding& binding_;
  const Knowledge& knowledge_;
};

}  // namespace

bool fits_by_scan(const Template& source, const Binding& binding, const Knowledge& knowledge) {
  const ScannedBinding scanned(binding, knowledge);
  if (binding.size() != source.parameters.size()) return false;
  for (const auto& parameter : source.parameters) {
    for (const auto& wanted : parameter.affordances)
      if (!scanned.affords(parameter.name, wanted)) return false;
  }
  return std::all_of(source.constraints.begin(), source.constraints.end(), [&](const auto& constraint) {
    return scanned.holds(std::string(info(constraint.type).name), constraint.arguments);
  });
}

}  // namespace unietp
