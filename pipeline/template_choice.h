#pragma once

#include <string>
#include <vector>

#include "pipeline/resources.h"

namespace unietp {

/// A template and all that it takes to try it.
struct TemplateChoice {
  Resources resources;
  std::size_t position = 0;   // of the template, in resources.templates
  std::vector<Error> errors;  // empty when sound

  const Template& source() const { return resources.templates[position]; }
};

/// The template of that name, or that a file holds: a file of a library, or one of the user's own, which need not lie
/// in any folder of templates. Errors: those of load_resources; Usage for an unknown name, with the nearest one.
TemplateChoice choose_template(const DataFolders& folders, const std::string& name_or_file);

}  // namespace unietp
