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
          {"loose_held", report.loose_held}};
}

std::map<std::string, int> causes_of(const ImportReport& report) {
  std::map<std::string, int> causes;
  for (const auto& issue : report.issues) ++causes[std::string(name_of(issue.reason))];
  return causes;
}

std::string import_to_json(const ForeignHome& home, const ImportReport& report) {
  auto issues = nlohmann::ordered_json::array();
  for (const auto& issue : report.issues)
    issues.push_back({{"object", issue.object},
                      {"category", issue.category},
                      {"reason", name_of(issue.reason)},
                      {"detail", issue.detail}});
  const nlohmann::ordered_json json{{"format", "unietp-import/1"},
                                    {"id", home.source.id},
                                    {"file", home.file.filename().string()},
                                    {"file_format", home.format},
                                    {"simulator", name_of(home.source.simulator)},
                                    {"scene", scene_file_name(home.source.id)},
                                    {"counts", counts_to_json(report)},
                                    {"issues", std::move(issues)},
                                    {"warnings", home.source.warnings}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace unietp
