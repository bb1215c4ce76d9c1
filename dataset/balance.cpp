#include "dataset/balance.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.h"
#include "generator/domain_constraints.h"
#include "scene/edge_change.h"
#include "templates/constraint_kinds.h"

namespace unietp {
namespace {

constexpr std::array<std::string_view, kDimensionCount> kNames{"template", "category", "receptacle",
                                                               "room",     "scene",    "use"};

bool asks_for(const Parameter& parameter, std::string_view affordance) {
  const auto& all = parameter.affordances;
  return std::find(all.begin(), all.end(), affordance) != all.end();
}

}  // namespace

std::string_view name_of(Dimension dimension) { return kNames[static_cast<std::size_t>(dimension)]; }

Dimension dimension_of(const Parameter& parameter, const Template& source) {
  if (asks_for(parameter, "room")) return Dimension::Room;
  if (asks_for(parameter, "receptacle") || asks_for(parameter, "container")) return Dimension::Receptacle;
  for (const auto& constraint : source.constraints) {
    if (info(constraint.type).meaning != ConstraintKind::Meaning::Placement) continue;
    const auto uses = placeholders_of(constraint);
    if (uses.size() > 1 && uses[1].name == parameter.name) return Dimension::Receptacle;
  }
  return Dimension::Category;
}

std::vector<Trait> traits_of(const Template& source, const Episode& episode, const Demonstration& demonstration) {
  const auto& specification = episode.specification;
  const std::string simulator = std::string(name_of(specification.simulator)) + "/";
  std::set<std::pair<Dimension, std::string>> found{{Dimension::Template, specification.template_name},
                                                    {Dimension::Scene, episode.layout}};
  for (const auto& parameter : source.parameters) {
    if (is_value(parameter)) continue;
    for (const auto& [placeholder, category] : specification.binding) {
      if (placeholder == parameter.name) found.emplace(dimension_of(parameter, source), simulator + category);
    }
  }
  std::set<std::string> handled;
  for (const auto& step : demonstration.steps) handled.insert(step.action.args.begin(), step.action.args.end());
  for (const auto& id : handled) {
    for (const auto& edge : edges_from(episode.start.edges, Predicate::InRoom, id)) {
      if (const Room* room = find_room(episode.start, edge.to)) found.emplace(Dimension::Room, simulator + room->type);
    }
  }
  std::vector<Trait> traits;
  for (const auto& [dimension, value] : found) traits.push_back({dimension, value});
  return traits;
}

std::string to_text(const std::vector<Trait>& traits) {
  std::string text;
  for (const auto& trait : traits) text += std::string(name_of(trait.dimension)) + " " + trait.value + "\n";
  return text;
}

std::optional<Dimension> dimension_named(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Dimension>(found - kNames.begin());
}

std::vector<Trait> traits_from(std::string_view text) {
  std::vector<Trait> traits;
  for (const auto& line : split(text, '\n')) {
    const auto blank = line.find(' ');
    if (blank == std::string::npos) continue;
    if (const auto dimension = dimension_named(line.substr(0, blank)))
      traits.push_back({*dimension, line.substr(blank + 1)});
  }
  return traits;
}

double Frequencies::count(Dimension dimension, const std::string& value) const {
  const auto& own = counts_[index(dimension)];
  const auto found = own.find(value);
  return found == own.end() ? 0 : found->second;
}

double Frequencies::weight(Dimension dimension, const std::string& value) const {
  const double inverse = 1 / (1 + count(dimension, value));
  return inverse * inverse;
}

std::vector<Spread> Frequencies::spreads() const {
  std::vector<Spread> all;
  for (std::size_t i = 0; i < kDimensionCount; ++i) {
    if (counts_[i].empty()) continue;
    double sum = 0, squares = 0;
    for (const auto& [value, count] : counts_[i]) sum += count, squares += count * count;
    const auto values = static_cast<double>(counts_[i].size());
    const double mean = sum / values;
    const double variance = std::max(0.0, squares / values - mean * mean);
    all.push_back(
        {static_cast<Dimension>(i), static_cast<int>(values), sum * sum / squares, std::sqrt(variance) / mean});
  }
  return all;
}

}  // namespace unietp
