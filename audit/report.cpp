#include <cstdio>

#include <nlohmann/json.hpp>

#include "audit/audit.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

std::string percent(double share) {
  char text[16];
  std::snprintf(text, sizeof text, "%.1f", 100 * share);
  return text;
}

std::string probability(double p) {
  char text[16];
  std::snprintf(text, sizeof text, p < 0.0001 ? "<0.0001" : "%.4f", p);
  return text;
}

std::string line_of(const AuditCell& cell, bool is_first) {
  const auto name = std::string(is_first ? cell.policy->name : "");
  const std::string range = "[" + percent(cell.low) + ", " + percent(cell.high) + "]";
  char text[256];
  std::snprintf(text, sizeof text, "%-30s %-4s %-18s %6d %7s %7s %-14s %8s%s\n", name.c_str(),
                is_first ? std::string(name_of(cell.mode)).c_str() : "", cell.group.c_str(), cell.asked,
                percent(static_cast<double>(cell.right) / cell.asked).c_str(), percent(cell.chance).c_str(),
                range.c_str(), probability(cell.p).c_str(), cell.leaks() ? "  LEAK" : "");
  return text;
}

}  // namespace

std::string audit_table(const AuditReport& report, bool whole) {
  char head[256];
  std::snprintf(head, sizeof head, "%-30s %-4s %-18s %6s %7s %7s %-14s %8s\n", "policy", "mode", "tasks", "asked",
                "right %", "chance", "[95 %]", "p");
  std::string text = head;
  const AuditCell* before = nullptr;
  for (const AuditCell& cell : report.cells) {
    const bool is_first = before == nullptr || before->policy != cell.policy || before->mode != cell.mode;
    before = &cell;
    if (is_first || whole || cell.leaks()) text += line_of(cell, is_first);
  }
  text += std::to_string(report.tasks) + " tasks in " + std::to_string(report.homes) + " homes, ";
  text += std::to_string(report.cells.size()) + " cells, " + std::to_string(report.leaks()) + " better than chance\n";
  return text;
}

std::string audit_json(const AuditReport& report) {
  Json json{{"format", "unietp-audit/1"}, {"tasks", report.tasks},
            {"homes", report.homes},      {"training_tasks", report.examples},
            {"level", kAuditLevel},       {"leaks", report.leaks()},
            {"cells", Json::array()}};
  for (const AuditCell& cell : report.cells) {
    json["cells"].push_back({{"policy", cell.policy->name},
                             {"knows", cell.policy->knows},
                             {"shuffled", cell.policy->channel->name},
                             {"mode", name_of(cell.mode)},
                             {"group", cell.group},
                             {"asked", cell.asked},
                             {"right", cell.right},
                             {"chance", cell.chance},
                             {"chance_range", {cell.low, cell.high}},
                             {"p", cell.p},
                             {"leak", cell.leaks()}});
  }
  return json.dump(2) + "\n";
}

}  // namespace unietp
