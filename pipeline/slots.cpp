#include "pipeline/slots.h"

#include <algorithm>

#include "core/text.h"

namespace unietp {
namespace {

/// A refinement takes any template that has none of its own; the other splits take their own.
bool fits(const Template& source, Simulator simulator, Split split) {
  const bool refined = split == Split::InstanceGrounding || split == Split::Linguistic;
  return ((refined && source.refinement.empty()) || split_of_tasks(source) == split) &&
         std::find(source.simulators.begin(), source.simulators.end(), simulator) != source.simulators.end();
}

bool asked_for(const RunConfiguration& configuration, const Template& source) {
  return configuration.templates.empty() || std::find(configuration.templates.begin(), configuration.templates.end(),
                                                      source.name) != configuration.templates.end();
}

std::vector<std::size_t> templates_for(const RunConfiguration& configuration, const Resources& resources,
                                       Simulator simulator, Split split) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < resources.templates.size(); ++i) {
    const auto& source = resources.templates[i];
    if (asked_for(configuration, source) && fits(source, simulator, split)) found.push_back(i);
  }
  return found;
}

struct Group {
  Split split;
  std::vector<std::size_t> templates;
};

Result<std::vector<Group>> groups_of(const RunConfiguration& configuration, const Resources& resources,
                                     Simulator simulator) {
  std::vector<Group> groups;
  for (const Split split : configuration.splits.empty() ? all_splits() : configuration.splits) {
    auto templates = templates_for(configuration, resources, simulator, split);
    if (!templates.empty()) {
      groups.push_back({split, std::move(templates)});
    } else if (!configuration.splits.empty()) {
      return Error{Error::Kind::Usage,
                   "--splits",
                   {},
                   "no template of those asked for makes " + std::string(name_of(split)) + " tasks on " +
                       std::string(name_of(simulator)) + "; `unietp template list` shows what each can make"};
    }
  }
  if (groups.empty())
    return Error{Error::Kind::Usage,
                 "--template",
                 {},
                 "none of the templates asked for fits " + std::string(name_of(simulator)) +
                     "; `unietp template list` shows what each can make"};
  return groups;
}

}  // namespace

int layouts_per_simulator(const RunConfiguration& configuration) {
  constexpr int kTasksPerLayout = 5, kFirst = 50;  // of the first tasks of a simulator
  constexpr int kTasksPerLayoutThen = 25;
  constexpr int kMostObjects = 90'000;  // in all homes of a run, which then take some 600 MB
  constexpr int kFurniture = 100;       // about as many pieces stand in a home
  const int simulators = std::max<int>(1, static_cast<int>(configuration.simulators.size()));
  const int tasks = (configuration.count + simulators - 1) / simulators;
  const int first = std::min(tasks, kFirst), then = tasks - first;
  const int wanted = (first + kTasksPerLayout - 1) / kTasksPerLayout + then / kTasksPerLayoutThen;
  return std::clamp(wanted, 1, std::max(1, kMostObjects / (configuration.objects + kFurniture) / simulators));
}

Result<std::vector<TaskSlot>> plan_slots(const RunConfiguration& configuration, const Resources& resources) {
  std::vector<std::string> known;
  for (const auto& source : resources.templates) known.push_back(source.name);
  for (const auto& name : configuration.templates) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      return unknown_name_error("--template", name, known);
  }
  std::vector<std::vector<Group>> groups;
  for (const auto simulator : configuration.simulators) {
    const auto own = [&](const Scene& home) { return home.simulator == simulator; };
    if (!resources.homes.empty() && std::none_of(resources.homes.begin(), resources.homes.end(), own))
      return Error{Error::Kind::Usage,
                   "--scenes",
                   {},
                   "none of the scenes given is one of " + std::string(name_of(simulator)) +
                       "; leave that simulator out of --simulators or give one"};
    auto found = groups_of(configuration, resources, simulator);
    if (!found) return found.error();
    groups.push_back(std::move(*found));
  }

  std::vector<TaskSlot> slots;
  for (int i = 0; i < configuration.count; ++i) {
    const auto share = static_cast<std::size_t>(i) % groups.size();
    const int number = i / static_cast<int>(groups.size());
    const auto& own = groups[share];
    const Group& group = own[static_cast<std::size_t>(number) % own.size()];
    slots.push_back({i, configuration.simulators[share], group.split, group.templates});
  }
  return slots;
}

}  // namespace unietp
