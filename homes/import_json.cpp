#include "homes/import_json.h"

#include <nlohmann/json.hpp>

#include "homes/scene_folder.h"

namespace unietp {

nlohmann::ordered_json counts_to_json(const ImportReport& report) {
  return {{"objects", report.objects},
          {"known", report.known},
          {"placed", report.placed},
          {"arrived", report.arrived},
          {"stayed", report.stayed},
          {"relations", report.relations},
          {"relations_held", report.relations_held},
          {"loose", report.loose},
          {"loose_held", report.loose_held},
          {"rooms_drawn", report.rooms_drawn},
          {"openings_made", report.openings_made}};
}

std::map<std::string, int> causes_of(const ImportReport& report) {
  std::map<std::string, int> causes;
  for (const auto& issue : report.issues) ++causes[std::string(name_of(issue.reason))];
  return causes;
}

nlohmann::ordered_json issues_to_json(const ImportReport& report) {
  auto issues = nlohmann::ordered_json::array();
  for (const auto& issue : report.issues)
    issues.push_back({{"object", issue.object},
                      {"category", issue.category},
                      {"reason", name_of(issue.reason)},
                      {"detail", issue.detail},
                      {"treatment", treatment_of(issue.reason)}});
  return issues;
}

nlohmann::ordered_json repairs_to_json(const ImportReport& report) {
  auto repairs = nlohmann::ordered_json::array();
  for (const auto& repair : report.repairs)
    repairs.push_back({{"object", repair.object},
                       {"category", repair.category},
                       {"node", repair.node},
                       {"repair", name_of(repair.kind)},
                       {"other", repair.other},
                       {"by_m", repair.by_m}});
  return repairs;
}

std::string import_to_json(const ForeignHome& home, const ImportReport& report) {
  const nlohmann::ordered_json json{{"format", "unietp-import/1"},
                                    {"id", home.source.id},
                                    {"file", home.file.filename().string()},
                                    {"file_format", name_of(home.format)},
                                    {"simulator", name_of(home.source.simulator)},
                                    {"scene", scene_file_name(home.source.id)},
                                    {"counts", counts_to_json(report)},
                                    {"issues", issues_to_json(report)},
                                    {"repairs", repairs_to_json(report)},
                                    {"warnings", home.source.warnings}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace unietp
