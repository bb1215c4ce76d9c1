#include <algorithm>
#include <functional>
#include <map>

#include "akb/facts.h"
#include "akb/wordnet.h"
#include "bodies.h"
#include "core/text.h"
#include "dataset/configuration.h"
#include "fuzz_bodies.h"
#include "grounding/furniture_position.h"
#include "llm/ask.h"
#include "run/given_binding.h"
#include "support.h"
#include "templates/phrasing.h"

namespace unietp::fuzz {
namespace {

/// A list of names reads, sorted and without repeats, or says what is accepted.
template <class Name>
bool accepted_list(const Result<std::vector<Name>>& names) {
  if (!check_result(names)) return false;
  require(!names->empty() && std::is_sorted(names->begin(), names->end()));
  require(std::adjacent_find(names->begin(), names->end()) == names->end());
  return true;
}

bool binding_body(std::string_view text) {
  Template source;
  source.parameters.resize(2);
  source.parameters[0].name = "A";
  source.parameters[1].name = "B";
  const auto texts = split(text, ' ');
  const auto binding = read_binding(texts, source);
  if (!check_result(binding)) return false;
  require(!to_text(*binding).empty());
  return true;
}

bool grade_body(std::string_view text) {
  const auto grade = parse_sense("--sense", text);
  if (!check_result(grade)) return false;
  require(name_of_least(*grade) == text);
  return true;
}

bool fact_body(std::string_view text) {
  const auto fact = parse_fact(text);
  if (!check_result(fact)) return false;
  const auto again = parse_fact(to_text(*fact));
  require(again && *again == *fact);
  return true;
}

bool place_body(std::string_view text) {
  const auto where = parse_furniture_position(text);
  require(!where || !where->height_m || (*where->height_m >= 0 && *where->height_m <= 2.5));
  return where.has_value();
}

bool url_body(std::string_view text) {
  const auto url = chat_url(std::string(text));
  if (!check_result(url)) return false;
  require(check_result(chat_url(*url)) && *chat_url(*url) == *url);
  return true;
}

bool phrasing_body(std::string_view text) {
  const SlotReading reading = read_slots(text);
  return reading.errors.empty();
}

}  // namespace

bool names_body(std::string_view text) {
  static const std::map<std::string, std::function<bool(std::string_view)>, std::less<>> kOptions{
      {"simulators", [](std::string_view value) { return accepted_list(parse_simulators("--simulators", value)); }},
      {"splits", [](std::string_view value) { return accepted_list(parse_splits("--splits", value)); }},
      {"modes",
       [](std::string_view value) {
         return accepted_list(parse_modes("--modes", value)) && accepted_list(parse_modes_to_make("--modes", value));
       }},
      {"sense", grade_body},
      {"bind", binding_body},
      {"fact", fact_body},
      {"where", place_body},
      {"url", url_body},
      {"phrasing", phrasing_body},
      {"synset", [](std::string_view value) { return synset_named(value).has_value(); }},
  };
  const std::size_t end = std::min(text.find('\n'), text.size());
  const auto option = kOptions.find(text.substr(0, end));
  return option != kOptions.end() && option->second(text.substr(std::min(end + 1, text.size())));
}

}  // namespace unietp::fuzz
