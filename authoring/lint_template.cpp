#include "authoring/lint_template.h"

#include <algorithm>

#include "authoring/purpose_fit.h"
#include "core/sexpr.h"
#include "generator/specification.h"
#include "templates/constraint_kinds.h"
#include "templates/phrasing_counts.h"

namespace unietp {
namespace {

constexpr int kTried = 12;  // bindings that are sampled before a warning

/// A section of a file that can be read; nullptr when it was left out.
const Sexpr* section_of(const Sexpr& file, std::string_view name) {
  for (const auto& child : file.children) {
    if (child.is_form(name)) return &child;
  }
  return nullptr;
}

/// The first constraint without which there would be a binding, or "".
std::string blocking_constraint(const Template& source, const Knowledge& knowledge) {
  for (std::size_t i = 0; i < source.constraints.size(); ++i) {
    auto without = source;
    without.constraints.erase(without.constraints.begin() + static_cast<std::ptrdiff_t>(i));
    if (!enumerate_bindings(without, knowledge, 1).empty()) return to_text(source.constraints[i]);
  }
  return "";
}

/// Why a claimed simulator makes no task of the template; "" when it makes some.
std::string reason_for_no_task(const Template& source, const Knowledge& knowledge) {
  const std::string simulator(name_of(knowledge.simulator()));
  if (enumerate_bindings(source, knowledge, 1).empty()) {
    const auto culprit = blocking_constraint(source, knowledge);
    return simulator + " has no categories that can be bound to all placeholders" +
           (culprit.empty() ? "" : "; without " + culprit + " it would have");
  }
  std::string last;
  for (int i = 0; i < kTried; ++i) {
    const auto binding = sample_binding(source, knowledge, {}, Rng(0).fork("lint", static_cast<std::uint64_t>(i)));
    if (!binding) continue;
    const auto made = instantiate(source, knowledge, *binding);
    if (made) return "";
    last = made.error().message;
  }
  return "none of " + std::to_string(kTried) + " bindings drawn for " + simulator +
         " gives a task; the last one: " + last;
}

}  // namespace

LintedFile lint_template(const std::string& path, std::string text, const std::vector<Backend>& backends) {
  LintedFile linted{path, std::move(text), "", {}};
  const auto reading = parse_template(path, linted.text);
  for (const auto& error : reading.errors) linted.problems.push_back({error, false});
  if (reading.templates.empty()) return linted;
  const auto& source = reading.templates.front();
  for (auto& error : unknown_categories(source, backends)) linted.problems.push_back({std::move(error), false});
  if (!linted.problems.empty()) return linted;
  linted.name = source.name;

  const auto file = read_sexpr(path, linted.text);
  const auto warn = [&](SourcePos pos, std::string message) {
    linted.problems.push_back({{Error::Kind::Schema, path, pos, std::move(message)}, true});
  };
  const auto* phrasings = section_of(*file, "instruction");
  for (const auto& doubtful : doubtful_phrasings(source)) {
    warn(phrasings->children[doubtful.index + 1].pos, doubtful.message);
  }
  const auto* purpose = section_of(*file, "purpose");
  for (auto& doubt : doubtful_purpose(source))
    warn(purpose == nullptr ? file->children[1].pos : purpose->pos, std::move(doubt));
  const auto* claims = section_of(*file, "simulators");
  for (std::size_t i = 0; i < source.simulators.size(); ++i) {
    auto why = reason_for_no_task(source, backends[static_cast<std::size_t>(source.simulators[i])].knowledge);
    if (why.empty()) continue;
    warn(claims == nullptr ? file->children[1].pos : claims->children[i + 1].pos, std::move(why));
  }
  auto readings = read_phrasings(source, backends);
  for (std::size_t i = 0; i < readings.size(); ++i)
    linted.phrasings.push_back({phrasings->children[i + 1].pos.line, std::move(readings[i])});
  return linted;
}

}  // namespace unietp
