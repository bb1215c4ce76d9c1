#pragma once

#include <map>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "homes/foreign_scenes.h"
#include "interchange/import_scene.h"

namespace unietp {

/// The report on one imported home: a file *.import.json of format `unietp-import/1` (data/schemas/import.schema.json).
std::string import_to_json(const ForeignHome& home, const ImportReport& report);

/// The counts of a report by name, in order.
nlohmann::ordered_json counts_to_json(const ImportReport& report);

/// The lists of a report, as data/schemas/import.schema.json has them.
nlohmann::ordered_json issues_to_json(const ImportReport& report);
nlohmann::ordered_json repairs_to_json(const ImportReport& report);

/// Number of issues by reason.
std::map<std::string, int> causes_of(const ImportReport& report);

}  // namespace unietp
