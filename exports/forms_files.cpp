#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/staged_folder.h"
#include "core/text.h"
#include "exports/formats.h"
#include "exports/task_folder.h"
#include "record/dataset_reader.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Why a form does not express a task, by the task's id.
using Reasons = std::map<std::string, std::string>;

/// Writes the form in `folder` and removes it again: that a task can be expressed is said by what writes it, no other.
Result<Reasons> refused_by(const ExportFormat& form, ExportRequest request, const fs::path& folder) {
  request.out = folder / form.name;
  if (const auto written = form.write(request); !written) return written.error();
  const auto text = read_file(request.out, "left_out.jsonl");
  if (!text) return text.error();
  Reasons reasons;
  for (const std::string& line : split(*text, '\n')) {
    if (line.empty()) continue;
    const Json json = Json::parse(line);
    reasons[json["task"]] = json["reason"];
  }
  std::error_code code;
  fs::remove_all(request.out, code);
  if (code) return Error{Error::Kind::Io, request.out.string(), {}, code.message()};
  return reasons;
}

/// Of the tasks of one simulator, how many a form expresses, and for each reason how many it does not.
struct Share {
  std::size_t tasks = 0, expressed = 0;
  std::map<std::string, std::size_t> reasons;
};

/// The table for the user: a row for each simulator and form, the reasons below it, the most frequent first.
std::string table_of(const std::map<Simulator, std::vector<Share>>& shares, const std::vector<ExportFormat>& forms) {
  std::string table = "simulator    form               tasks  expressed\n";
  for (const auto& [simulator, by_form] : shares) {
    for (std::size_t i = 0; i < forms.size(); ++i) {
      const Share& share = by_form[i];
      if (share.tasks == 0) continue;
      std::array<char, 128> row{};
      (void)std::snprintf(row.data(), row.size(), "%-12s %-17s %6zu %6zu  %5.1f %%\n",
                          std::string(name_of(simulator)).c_str(), forms[i].name.c_str(), share.tasks, share.expressed,
                          100.0 * static_cast<double>(share.expressed) / static_cast<double>(share.tasks));
      table += row.data();
      table += reason_lines(share.reasons).substr(share.reasons.empty() ? 0 : 1);
      if (!share.reasons.empty()) table += "\n";
    }
  }
  table.pop_back();
  return table;
}

/// The same for programs: an object for each row.
std::string json_of(const std::map<Simulator, std::vector<Share>>& shares, const std::vector<ExportFormat>& forms,
                    const fs::path& out) {
  Json rows = Json::array();
  for (const auto& [simulator, by_form] : shares) {
    for (std::size_t i = 0; i < forms.size(); ++i) {
      const Share& share = by_form[i];
      if (share.tasks == 0) continue;
      rows.push_back({{"simulator", name_of(simulator)},
                      {"form", forms[i].name},
                      {"tasks", share.tasks},
                      {"expressed", share.expressed},
                      {"reasons", reasons_json(share.reasons)}});
    }
  }
  return Json{{"out", out.string()}, {"forms", std::move(rows)}}.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// forms.jsonl: for each task the forms that express it, and of those that are for its simulator and do not, why.
Result<ExportSummary> write_forms(const ExportRequest& request) {
  std::vector<ExportFormat> forms = export_formats();
  std::erase_if(forms, [](const ExportFormat& format) { return !format.is_form; });
  std::map<Simulator, std::vector<Share>> shares;
  const auto written = write_staged_folder(request.dataset, request.out, [&](const fs::path& aside) -> Result<Done> {
    std::vector<Reasons> refused;
    for (const ExportFormat& form : forms) {
      auto reasons = refused_by(form, request, aside);
      if (!reasons) return reasons.error();
      refused.push_back(std::move(*reasons));
    }
    auto tasks = DatasetReader::open(request.dataset, {});
    if (!tasks) return tasks.error();
    std::string lines;
    auto read = for_each_task<TaskRecord>(
        std::move(*tasks), 1, [](const FinishedTask& task) -> Result<TaskRecord> { return task.record; },
        [&](TaskRecord&& task) -> Result<Done> {
          const Simulator simulator = *simulator_named(task.simulator);
          std::vector<Share>& row = shares.try_emplace(simulator, forms.size()).first->second;
          Json expressed = Json::array(), why = Json::object();
          for (std::size_t i = 0; i < forms.size(); ++i) {
            if (forms[i].only.value_or(simulator) != simulator) continue;
            ++row[i].tasks;
            const auto reason = refused[i].find(task.id);
            if (reason == refused[i].end()) {
              ++row[i].expressed;
              expressed.push_back(forms[i].name);
            } else {
              ++row[i].reasons[without_numbers(reason->second)];
              why[forms[i].name] = reason->second;
            }
          }
          const Json line{{"task", task.id},
                          {"simulator", task.simulator},
                          {"template", task.template_name},
                          {"forms", std::move(expressed)},
                          {"refused", std::move(why)}};
          lines += line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
          return Done{};
        });
    if (!read) return read;
    return write_file(aside, "forms.jsonl", lines);
  });
  if (!written) return written.error();
  return ExportSummary{table_of(shares, forms), json_of(shares, forms, request.out)};
}

}  // namespace

ExportFormat forms_format() {
  return {"forms", "which of the other forms express each task, and why not", {}, true, write_forms};
}

}  // namespace unietp
