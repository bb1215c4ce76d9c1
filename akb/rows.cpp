#include "akb/rows.h"

namespace unietp {

bool well_formed_source(std::string_view source) {
  if (source == "curated") return true;
  for (const std::string_view kind : {"metadata:", "derived:", "llm:", "override:"}) {
    if (source.starts_with(kind)) {
      const auto name = source.substr(kind.size());
      return !name.empty() && name.find_first_of(" \t\r\n") == std::string_view::npos;
    }
  }
  return false;
}

}  // namespace unietp
