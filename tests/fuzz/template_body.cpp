#include "../annotator/small_knowledge.h"
#include "bodies.h"
#include "fuzz_bodies.h"
#include "support.h"
#include "templates/phrasing.h"
#include "templates/template.h"
#include "templates/template_text.h"

namespace unietp::fuzz {

bool template_body(std::string_view text) {
  static const Knowledge knowledge = testing_support::small_knowledge();
  const TemplateReading reading = parse_template("fuzz.template", text);
  require(reading.templates.empty() != reading.errors.empty());
  for (const Error& error : reading.errors) check_error(error);
  for (const Template& one : reading.templates) {
    require(one.name == "fuzz");
    const TemplateReading again = parse_template("fuzz.template", to_text(one));
    require(again.templates.size() == 1 && same_content(again.templates.front(), one));
    check_formula(one.goal, FormulaUse::Goal);
    for (const Formula& start : one.init) check_formula(start, FormulaUse::State);
    std::vector<std::pair<std::string, std::string>> binding;
    for (const Parameter& parameter : one.parameters) binding.emplace_back(parameter.name, "Mug");
    for (const std::string& phrasing : one.instructions) {
      require(read_slots(phrasing).errors.empty());
      require(!fill_phrasing(phrasing, binding, knowledge).empty());
    }
  }
  return reading.errors.empty();
}

}  // namespace unietp::fuzz
