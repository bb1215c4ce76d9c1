#include "import_rates.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "simulation/relations.h"

namespace unietp::testing {
namespace {

double share(int part, int whole) { return whole == 0 ? 1.0 : static_cast<double>(part) / whole; }

}  // namespace

std::filesystem::path upstream() { return UNIETP_UPSTREAM_DIR; }

const FormatFacts& format_facts() {
  static const FormatFactsReading reading =
      read_format_facts(std::filesystem::path(UNIETP_SOURCE_DIR) / "data/scene_files");
  if (!reading.errors.empty()) throw std::runtime_error(format(reading.errors.front()));
  return reading.facts;
}

const Profile& profile_of(Simulator simulator) {
  static std::map<Simulator, Profile> loaded;
  const auto found = loaded.find(simulator);
  if (found != loaded.end()) return found->second;
  const auto profile = load_profile(std::filesystem::path(UNIETP_SOURCE_DIR) / "data/simulators", simulator);
  if (!profile) throw std::runtime_error(format(profile.error()));
  return loaded.emplace(simulator, *profile).first->second;
}

std::vector<Imported> import_all(const std::vector<SourceScene>& scenes, std::size_t stride) {
  std::vector<Imported> all;
  for (std::size_t i = 0; i < scenes.size(); i += stride) {
    const SourceScene& source = scenes[i];
    const auto imported =
        assemble(source, committed_knowledge(source.simulator), profile_of(source.simulator), format_facts());
    if (!imported) throw std::runtime_error(format(imported.error()));
    all.push_back({source.id, imported->report, restless(imported->scene).size()});
  }
  return all;
}

double arrived_share(const ImportReport& report) { return share(report.arrived, report.known); }
double held_share(const ImportReport& report) { return share(report.relations_held, report.relations); }
double loose_share(const ImportReport& report) { return share(report.loose_held, report.loose); }

std::string table_row(const std::string& format, const std::vector<Imported>& all) {
  ImportReport sum;
  std::map<std::string, int> reasons;
  std::size_t not_at_rest = 0;
  double worst_arrived = 1, worst_stayed = 1, worst_held = 1, worst_loose = 1;
  for (const auto& [scene, r, restless_count] : all) {
    not_at_rest += restless_count;
    sum.objects += r.objects, sum.known += r.known, sum.arrived += r.arrived, sum.stayed += r.stayed;
    sum.relations += r.relations, sum.relations_held += r.relations_held;
    sum.loose += r.loose, sum.loose_held += r.loose_held;
    for (const ImportIssue& issue : r.issues) ++reasons[std::string(name_of(issue.reason))];
    worst_arrived = std::min(worst_arrived, arrived_share(r));
    worst_stayed = std::min(worst_stayed, share(r.stayed, r.known));
    worst_held = std::min(worst_held, held_share(r));
    worst_loose = std::min(worst_loose, loose_share(r));
  }
  char text[600];
  std::snprintf(
      text, sizeof text,
      "| %s | %zu | %d | %d | %.1f %% (%.1f %%) | %.1f %% (%.1f %%) | %d | %.1f %% (%.1f %%) | %.1f %% (%.1f %%) |",
      format.c_str(), all.size(), sum.objects, sum.known, 100 * share(sum.arrived, sum.known), 100 * worst_arrived,
      100 * share(sum.stayed, sum.known), 100 * worst_stayed, sum.relations,
      100 * share(sum.relations_held, sum.relations), 100 * worst_held, 100 * share(sum.loose_held, sum.loose),
      100 * worst_loose);
  std::string row = text;
  row += " not at rest " + std::to_string(not_at_rest);
  for (const auto& [reason, count] : reasons) row += " " + reason + " " + std::to_string(count);
  return row;
}

std::vector<std::string> restless(const Scene& scene) {
  const PhysicsWorld world = physics_of(scene);
  SettleOptions two_seconds;
  two_seconds.max_steps = two_seconds.calm_steps = 480;
  std::vector<BodyId> loose;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].movable) loose.push_back(BodyId::node(i));
  }
  std::vector<std::string> moved;
  for (const SettledBody& settled : world.settle(loose, two_seconds).bodies) {
    const Node& node = scene.nodes[settled.body.index()];
    if ((settled.pose.position - node.pose.position).norm() > 0.005) moved.push_back(node.id);
  }
  return moved;
}

}  // namespace unietp::testing
