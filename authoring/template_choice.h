#pragma once

#include <string>
#include <vector>

#include "generator/specification.h"
#include "resources/resources.h"

namespace unietp {

/// A template and everything needed to try it.
struct TemplateChoice {
  Resources resources;
  std::size_t position = 0;   // of the template, in resources.templates
  std::vector<Error> errors;  // empty when valid

  Binding binding;                    // what was given for its placeholders
  std::vector<Simulator> simulators;  // to try it on

  const Template& source() const { return resources.templates[position]; }  // the chosen template
};

/// The template of that name, or the one in a file, which may lie outside of any folder of templates. Errors: those of
/// load_resources; Usage for an unknown name, with the nearest one.
TemplateChoice choose_template(const DataFolders& folders, const std::string& name_or_file);

/// The same with `--bind` and `--simulator` read: without simulators, those of simulators_for. Errors, besides: those
/// of read_binding and parse_simulators.
TemplateChoice choose_template(const DataFolders& folders, const std::string& name_or_file,
                               const std::vector<std::string>& binding, const std::string& simulators);

}  // namespace unietp
