#include "run/slots.h"

#include <algorithm>
#include <map>

#include "core/rng.h"
#include "core/unknown_name.h"
#include "run/sense_of_binding.h"
#include "run/share_out.h"
#include "run/styles_of_slots.h"

namespace unietp {
namespace {

/// Refined splits use any template without a refinement of its own; the other splits use their own templates.
bool fits(const Template& source, Simulator simulator, Split split) {
  const bool refined = split == Split::InstanceGrounding || split == Split::Linguistic;
  return ((refined && source.refinement.empty()) || split_of_tasks(source) == split) &&
         std::find(source.simulators.begin(), source.simulators.end(), simulator) != source.simulators.end();
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool asked_for(const RunConfiguration& configuration, const Template& source) {
  return (configuration.templates.empty() || has(configuration.templates, source.name)) &&
         !has(configuration.without, source.name);
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
                   "none of the selected templates gives " + std::string(name_of(split)) + " tasks on " +
                       std::string(name_of(simulator)) + "; see `unietp template list`"};
    }
  }
  if (groups.empty())
    return Error{
        Error::Kind::Usage,
        "--template",
        {},
        "none of the selected templates supports " + std::string(name_of(simulator)) + "; see `unietp template list`"};
  return groups;
}

/// Round-robin over the simulators, and over the splits of each.
std::vector<TaskSlot> equal_shares(const RunConfiguration& configuration,
                                   const std::vector<std::vector<Group>>& groups) {
  std::vector<TaskSlot> slots;
  for (int i = 0; i < configuration.count; ++i) {
    const auto share = static_cast<std::size_t>(i) % groups.size();
    const int number = i / static_cast<int>(groups.size());
    const auto& own = groups[share];
    const Group& group = own[static_cast<std::size_t>(number) % own.size()];
    slots.push_back({i, configuration.simulators[share], group.split, group.templates, {}, 0, {}});
  }
  return slots;
}

template <class T>
std::vector<int> counts_of(const std::vector<std::pair<T, int>>& shares) {
  std::vector<int> counts;
  for (const auto& share : shares) counts.push_back(share.second);
  return counts;
}

Result<std::vector<TaskSlot>> by_quotas(const RunConfiguration& configuration, const Resources& resources) {
  const auto& [splits, simulators] = configuration.quotas;
  std::vector<Group> groups;  // simulator by simulator, each with every split
  std::vector<std::vector<bool>> allowed;
  for (const auto& simulator : simulators) {
    allowed.emplace_back();
    for (const auto& split : splits) {
      groups.push_back({split.first, templates_for(configuration, resources, simulator.first, split.first)});
      allowed.back().push_back(!groups.back().templates.empty());
    }
  }
  const auto table = share_out(counts_of(simulators), counts_of(splits), allowed);
  if (table.empty())
    return Error{Error::Kind::Usage,
                 "quotas",
                 {},
                 "cannot be met by the selected templates: some simulator has none for a split that must fill its "
                 "share; see `unietp template list`"};
  std::vector<int> counts;
  for (const auto& row : table) counts.insert(counts.end(), row.begin(), row.end());
  std::vector<TaskSlot> slots;
  for (const std::size_t cell : spread_out(counts)) {
    slots.push_back({static_cast<int>(slots.size()),
                     simulators[cell / splits.size()].first,
                     groups[cell].split,
                     groups[cell].templates,
                     {},
                     0,
                     {}});
  }
  return slots;
}

/// What the tasks of each slot's templates have to reach: the sense asked for, or what is tolerable where a template
/// has nothing better on the simulator. Where others of the same split reach it, those that do not are left out, unless
/// they reach it nowhere and something is tolerable: then they are kept, so that no template is lost. Senseless tasks
/// come only from asking for any.
void grade_templates(std::vector<TaskSlot>& slots, const RunConfiguration& configuration, const Resources& resources) {
  std::map<std::pair<std::size_t, Simulator>, Grade> best;
  std::map<std::size_t, Grade> anywhere;
  for (const auto& slot : slots) {
    for (const auto source : slot.templates) {
      const auto [at, fresh] = best.try_emplace({source, slot.simulator}, Grade::Senseless);
      if (!fresh) continue;
      if (configuration.sense == Grade::Senseless) continue;
      at->second =
          best_grade(configuration.sense, resources.templates[source], resources, slot.simulator, configuration.binding)
              .value_or(Grade::Senseless);
      const auto [most, first] = anywhere.try_emplace(source, at->second);
      most->second = std::max(most->second, at->second);
    }
  }
  for (auto& slot : slots) {
    const auto reached = [&](std::size_t source) { return best[{source, slot.simulator}]; };
    const bool some = std::any_of(slot.templates.begin(), slot.templates.end(),
                                  [&](std::size_t source) { return reached(source) == configuration.sense; });
    if (some) {
      std::erase_if(slot.templates, [&](std::size_t source) {
        return reached(source) < configuration.sense &&
               (anywhere[source] == configuration.sense || reached(source) == Grade::Senseless);
      });
    }
    const Grade worst = std::min(configuration.sense, Grade::Tolerable);
    for (const auto source : slot.templates) slot.least.push_back(std::max(worst, reached(source)));
  }
}

/// Each slot in turn takes the template assigned least often so far; among equals the one that fits the fewest slots,
/// since the others fit more of the slots that follow, and then a random one. Where the slot has a phenomenon, its
/// template is one that has it.
void assign_first_templates(std::vector<TaskSlot>& slots, const std::vector<std::vector<Style>>& styles, Rng rng) {
  const std::size_t templates = styles.size();
  std::vector<int> assigned(templates, 0), slots_fitted(templates, 0);
  for (const auto& slot : slots) {
    for (const auto source : slot.templates) ++slots_fitted[source];
  }
  for (auto& slot : slots) {
    std::vector<std::size_t> least;  // positions in slot.templates
    const auto rank = [&](std::size_t at) {
      return std::pair(assigned[slot.templates[at]], slots_fitted[slot.templates[at]]);
    };
    for (std::size_t at = 0; at < slot.templates.size(); ++at) {
      if (!slot.styles.empty() && !is_among(slot.styles.front(), styles[slot.templates[at]])) continue;
      if (!least.empty() && rank(at) > rank(least.front())) continue;
      if (!least.empty() && rank(at) < rank(least.front())) least.clear();
      least.push_back(at);
    }
    slot.first_template = least[rng.below(least.size())];
    ++assigned[slot.templates[slot.first_template]];
  }
}

/// Errors: Usage for a name that no template has.
Result<Done> check_names(const RunConfiguration& configuration, const Resources& resources) {
  std::vector<std::string> known;
  for (const auto& source : resources.templates) known.push_back(source.name);
  for (const auto& name : configuration.templates) {
    if (!has(known, name)) return unknown_name_error("--template", name, known);
  }
  for (const auto& name : configuration.without) {
    if (!has(known, name)) return unknown_name_error("--without-templates", name, known);
  }
  return Done{};
}

/// Errors: Usage when homes are given and a simulator has none of them.
Result<Done> check_homes(const RunConfiguration& configuration, const Resources& resources) {
  for (const auto simulator : configuration.simulators) {
    const auto own = [&](const Scene& home) { return home.simulator == simulator; };
    if (!resources.homes.empty() && std::none_of(resources.homes.begin(), resources.homes.end(), own))
      return Error{Error::Kind::Usage,
                   "--scenes",
                   {},
                   "none of the given scenes belongs to " + std::string(name_of(simulator)) +
                       "; remove that simulator from --simulators or add a scene"};
  }
  return Done{};
}

Result<std::vector<TaskSlot>> slots_by_simulator_and_split(const RunConfiguration& configuration,
                                                           const Resources& resources) {
  if (!configuration.quotas.empty()) return by_quotas(configuration, resources);
  std::vector<std::vector<Group>> groups;
  for (const auto simulator : configuration.simulators) {
    auto found = groups_of(configuration, resources, simulator);
    if (!found) return found.error();
    groups.push_back(std::move(*found));
  }
  return equal_shares(configuration, groups);
}

}  // namespace

Result<std::vector<TaskSlot>> plan_slots(const RunConfiguration& configuration, const Resources& resources) {
  if (auto known = check_names(configuration, resources); !known) return known.error();
  if (auto there = check_homes(configuration, resources); !there) return there.error();
  auto slots = slots_by_simulator_and_split(configuration, resources);
  if (slots) grade_templates(*slots, configuration, resources);
  if (!slots) return slots;
  const auto styles = styles_of_templates(resources.templates);
  deal_styles(*slots, styles, Rng(configuration.seed).fork("styles", 0));
  assign_first_templates(*slots, styles, Rng(configuration.seed).fork("deal", 0));
  return slots;
}

}  // namespace unietp
