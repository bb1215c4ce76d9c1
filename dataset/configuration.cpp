#include "dataset/configuration.h"

#include "core/unknown_name.h"

#include <algorithm>

#include "core/text.h"

namespace unietp {
namespace {

std::vector<std::string> names(std::string_view text) {
  std::vector<std::string> all;
  for (const auto& part : split(text, ',')) {
    if (const auto name = trim(part); !name.empty()) all.emplace_back(name);
  }
  return all;
}

template <class T>
Result<std::vector<T>> parse_names(std::string_view option, std::string_view text, const std::vector<T>& known) {
  std::vector<std::string> accepted;
  for (const T value : known) accepted.emplace_back(name_of(value));
  const auto asked = names(text);
  if (asked.empty())
    return Error{Error::Kind::Usage, std::string(option), {}, "is empty; accepted: " + join(accepted, ", ")};
  for (const auto& name : asked) {
    if (std::find(accepted.begin(), accepted.end(), name) == accepted.end())
      return unknown_name_error(option, name, accepted);
  }
  std::vector<T> values;
  for (const T value : known) {
    if (std::find(asked.begin(), asked.end(), name_of(value)) != asked.end()) values.push_back(value);
  }
  return values;
}

}  // namespace

std::string_view name_of(HomeSource source) {
  static constexpr std::array<std::string_view, kHomeSources.size()> kNames{"drawn", "benchmark", "training"};
  return kNames[static_cast<std::size_t>(source)];
}

std::string_view name_of(Phrasings phrasings) {
  static constexpr std::array<std::string_view, kPhrasings.size()> kNames{"everyday", "all", "training", "benchmark"};
  return kNames[static_cast<std::size_t>(phrasings)];
}

std::optional<Phrasings> phrasings_named(std::string_view name) {
  for (const Phrasings set : kPhrasings) {
    if (name_of(set) == name) return set;
  }
  return std::nullopt;
}

std::string_view name_of(English english) { return english == English::Us ? "us" : "gb"; }

std::string_view name_of_least(Grade grade) { return grade == Grade::Senseless ? "any" : name_of(grade); }

const std::vector<Split>& all_splits() {
  static const std::vector<Split> kSplits{Split::Atomic, Split::Compositional, Split::Logical, Split::InstanceGrounding,
                                          Split::Linguistic};
  return kSplits;
}

Result<std::vector<Simulator>> parse_simulators(std::string_view option, std::string_view text) {
  return parse_names(option, text, std::vector<Simulator>{kSimulators.begin(), kSimulators.end()});
}

Result<std::vector<Split>> parse_splits(std::string_view option, std::string_view text) {
  return parse_names(option, text, all_splits());
}

Result<Grade> parse_sense(std::string_view option, std::string_view text) {
  std::vector<std::string> accepted;
  for (const Grade grade : {Grade::Usual, Grade::Tolerable, Grade::Senseless}) {
    if (name_of_least(grade) == text) return grade;
    accepted.emplace_back(name_of_least(grade));
  }
  return unknown_name_error(option, text, accepted);
}

Result<std::vector<Mode>> parse_modes(std::string_view option, std::string_view text) {
  return parse_names(option, text, std::vector<Mode>{kModes.begin(), kModes.end()});
}

Result<std::vector<Mode>> parse_modes_to_make(std::string_view option, std::string_view text) {
  auto modes = parse_modes(option, text);
  if (modes && modes->front() != Mode::M1) modes->insert(modes->begin(), Mode::M1);
  return modes;
}

}  // namespace unietp
