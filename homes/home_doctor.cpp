#include "homes/home_doctor.h"

#include <array>
#include <cstdio>
#include <map>
#include <tuple>

#include <nlohmann/json.hpp>

#include "homes/import_json.h"

namespace unietp {
namespace {

std::string centimeters(double meters) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.1f cm", 100 * meters);
  return text.data();
}

/// A fault or repair of one object, in words.
struct Line {
  std::string kind, meaning, object;
};

std::string with_other(std::string text, std::string_view word, const std::string& other, double by_m) {
  if (!other.empty()) text += " " + std::string(word) + " " + other;
  if (by_m > 0) text += ", " + centimeters(by_m);
  return text;
}

std::vector<Line> lines_of(const std::vector<ImportIssue>& issues) {
  std::vector<Line> lines;
  for (const auto& issue : issues) {
    std::string object = issue.object;
    if (!issue.category.empty()) object += " (" + issue.category + ")";
    lines.push_back(
        {std::string(name_of(issue.reason)), std::string(treatment_of(issue.reason)), object + ": " + issue.detail});
  }
  return lines;
}

std::vector<Line> lines_of(const std::vector<ImportRepair>& repairs) {
  std::vector<Line> lines;
  for (const auto& repair : repairs) {
    lines.push_back({std::string(name_of(repair.kind)), std::string(meaning_of(repair.kind)),
                     with_other(repair.object, "for", repair.other, repair.by_m)});
  }
  return lines;
}

std::vector<Line> lines_of(const std::vector<HomeFinding>& faults) {
  std::vector<Line> lines;
  for (const auto& fault : faults) {
    lines.push_back({std::string(name_of(fault.fault)), std::string(meaning_of(fault.fault)),
                     with_other(fault.object, "and", fault.other, fault.by_m)});
  }
  return lines;
}

/// By kind: its number, its meaning, and the first objects.
std::string section(const std::string& title, const std::vector<Line>& lines, std::size_t examples) {
  if (lines.empty()) return "";
  std::map<std::string, std::vector<const Line*>> kinds;
  for (const Line& line : lines) kinds[line.kind].push_back(&line);
  std::string text = "  " + title + "\n";
  for (const auto& [kind, all] : kinds) {
    const auto number = std::to_string(all.size());
    text += std::string(number.size() < 8 ? 8 - number.size() : 0, ' ') + number + " " + kind + ": " +
            all.front()->meaning + "\n";
    for (std::size_t i = 0; i < all.size() && i < examples; ++i) text += "           " + all[i]->object + "\n";
    if (all.size() > examples && examples > 0)
      text += "           and " + std::to_string(all.size() - examples) + " more\n";
  }
  return text;
}

std::string many(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

Result<HomeDiagnosis> diagnose(const HomeInFile& home, const std::vector<Backend>& backends, const FormatFacts& facts) {
  HomeDiagnosis diagnosis;
  diagnosis.id = home.id;
  diagnosis.file = home.file;
  diagnosis.simulator = simulator_of(home);
  Scene scene;
  if (const auto* ours = std::get_if<Scene>(&home.content)) {
    diagnosis.file_format = "unietp-scene";
    scene = *ours;
  } else {
    const auto& foreign = std::get<ForeignHome>(home.content);
    auto imported = import_home(foreign, backends, facts, {});
    if (!imported) return imported.error();
    diagnosis.file_format = name_of(foreign.format);
    diagnosis.warnings = foreign.source.warnings;
    diagnosis.imported = std::move(imported->report);
    scene = std::move(imported->scene);
  }
  diagnosis.rooms = scene.rooms.size();
  diagnosis.objects = scene.nodes.size();
  const auto& backend = backends[static_cast<std::size_t>(diagnosis.simulator)];
  diagnosis.faults = faults_of(scene, backend.knowledge, backend.profile);
  return diagnosis;
}

nlohmann::ordered_json diagnosis_to_json(const HomeDiagnosis& diagnosis) {
  auto faults = nlohmann::ordered_json::array();
  for (const auto& fault : diagnosis.faults)
    faults.push_back({{"fault", name_of(fault.fault)},
                      {"object", fault.object},
                      {"category", fault.category},
                      {"other", fault.other},
                      {"by_m", fault.by_m}});
  nlohmann::ordered_json json{{"id", diagnosis.id},
                              {"file", diagnosis.file.string()},
                              {"file_format", diagnosis.file_format},
                              {"simulator", name_of(diagnosis.simulator)},
                              {"rooms", diagnosis.rooms},
                              {"objects", diagnosis.objects}};
  if (diagnosis.imported) {
    json["counts"] = counts_to_json(*diagnosis.imported);
    json["issues"] = issues_to_json(*diagnosis.imported);
    json["repairs"] = repairs_to_json(*diagnosis.imported);
    json["warnings"] = diagnosis.warnings;
  }
  json["faults"] = std::move(faults);
  return json;
}

std::string diagnosis_text(const HomeDiagnosis& diagnosis, std::size_t examples) {
  std::string text = diagnosis.id + " (" + diagnosis.file_format + ", " + diagnosis.file.string() +
                     "): " + many(diagnosis.rooms, "room") + ", " + many(diagnosis.objects, "object") + "\n";
  if (diagnosis.imported) {
    const ImportReport& report = *diagnosis.imported;
    text += "  the file has " + many(static_cast<std::size_t>(report.objects), "object") + ", of which " +
            std::to_string(report.placed) + " are placed\n";
    if (report.rooms_drawn > 0)
      text += "  it has no rooms: " + std::to_string(report.rooms_drawn) + " drawn around its objects\n";
    if (report.openings_made > 0)
      text += "  it has no doors: " + std::to_string(report.openings_made) + " made in shared walls\n";
    for (const auto& warning : diagnosis.warnings) text += "  " + warning + "\n";
    text += section("not as in the file", lines_of(report.issues), examples);
    text += section("repaired", lines_of(report.repairs), examples);
  }
  if (diagnosis.faults.empty()) return text + "  the home has no faults now\n";
  return text + section("faults of the home now", lines_of(diagnosis.faults), examples);
}

}  // namespace unietp
