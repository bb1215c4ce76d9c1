#include "exports/formats.h"

namespace unietp {

// One function per format, defined in the format's own file and called only here.
ExportFormat sft_format();
ExportFormat release_format();
ExportFormat bddl_format();
ExportFormat behavior_format();
ExportFormat pddl_format();
ExportFormat ltlf_format();
ExportFormat starts_format();
ExportFormat virtualhome_format();
ExportFormat virtualhome_unity_format();
ExportFormat habitat_format();
ExportFormat ai2thor_format();
ExportFormat forms_format();

std::vector<ExportFormat> export_formats() {
  return {sft_format(),
          release_format(),
          bddl_format(),
          pddl_format(),
          ltlf_format(),
          virtualhome_format(),
          virtualhome_unity_format(),
          habitat_format(),
          ai2thor_format(),
          behavior_format(),
          starts_format(),
          forms_format()};
}

std::string ExportRequest::value(const std::string& option) const {
  const auto found = options.find(option);
  return found == options.end() || found->second.empty() ? "" : found->second.front();
}

}  // namespace unietp
