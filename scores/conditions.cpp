#include <algorithm>
#include <set>

#include "core/text.h"
#include "scores/result_tables.h"

namespace unietp {
namespace {

/// The values of all runs, each once, in the order of the runs.
template <class Value>
std::string listed(std::span<const ScoredRun> runs, const Value& value_of) {
  std::vector<std::string> values;
  for (const ScoredRun& run : runs) {
    std::string value = value_of(run);
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(std::move(value));
  }
  return join(values, " and ");
}

std::string preset_of(const ScoredRun& run) {
  std::vector<std::string> presets;
  for (const auto& [mode, settings] : run.manifest.setup.settings) {
    std::string preset(name_of(settings.conventions));
    if (settings != settings_for(mode, settings.conventions)) preset += " with changes";
    if (std::find(presets.begin(), presets.end(), preset) == presets.end()) presets.push_back(std::move(preset));
  }
  return join(presets, ", ");
}

}  // namespace

std::vector<std::string> labels_of(std::span<const ScoredRun> runs) {
  std::vector<std::string> labels;
  for (const ScoredRun& run : runs) {
    const std::string& agent = run.manifest.setup.agent.name;
    const auto same = std::count_if(runs.begin(), runs.end(),
                                    [&](const ScoredRun& other) { return other.manifest.setup.agent.name == agent; });
    labels.push_back(same > 1 ? agent + " (" + run.name + ")" : agent);
  }
  return labels;
}

std::string conditions_of(std::span<const ScoredRun> runs) {
  const auto dataset = [](const ScoredRun& run) {
    const EvaluatedDataset& set = run.manifest.setup.dataset;
    return set.version.empty() ? "data set " + set.name + " (" + set.digest.substr(0, 12) + ")"
                               : "benchmark " + set.version;
  };
  std::string text = listed(runs, dataset);
  text.front() = text.front() == 'b' ? 'B' : 'D';
  text += ", backend " + listed(runs, [](const ScoredRun& run) { return run.manifest.setup.backend; }) + ", preset " +
          listed(runs, preset_of) + ", unietp " +
          listed(runs, [](const ScoredRun& run) { return run.manifest.setup.program_version; }) + ".";
  const auto labels = labels_of(runs);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].complete()) continue;
    const auto errored = std::count_if(runs[i].scores.begin(), runs[i].scores.end(),
                                       [](const EpisodeScore& one) { return one.errored(); });
    text += " Incomplete: " + labels[i] + ", of " + std::to_string(runs[i].manifest.totals.episodes) + " episodes " +
            std::to_string(errored) + " errored, " + std::to_string(runs[i].missing()) + " missing.";
  }
  return text;
}

}  // namespace unietp
