#include "cli/likeness_output.h"

#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::pair<std::string_view, double>, 6> kQuantiles{
    {{"least", 0}, {"p10", 0.1}, {"median", 0.5}, {"p90", 0.9}, {"p99", 0.99}, {"greatest", 1}}};

Json pair_json(const LikenessMeasure::Pair& pair) {
  Json json{{"own", pair.own}, {"other", pair.other}, {"value", pair.value}};
  if (pair.likeness)
    json.update({{"home", pair.likeness->home}, {"goal", pair.likeness->goal}, {"text", pair.likeness->text}});
  return json;
}

Json measure_json(const LikenessMeasure& measure) {
  Json json{{"count", measure.values.size()}};
  if (measure.fails_at) json["fails_at"] = *measure.fails_at;
  for (const auto& [name, share] : kQuantiles) json[std::string(name)] = measure.quantile(share);
  json["closest"] = Json::array();
  for (const auto& pair : measure.closest) json["closest"].push_back(pair_json(pair));
  return json;
}

void print_closest(const LikenessMeasure& measure) {
  std::printf("closest %s\n", std::string(measure.name).c_str());
  for (const auto& pair : measure.closest) {
    std::printf("  %.2f  %-28s %-28s", pair.value, pair.own.c_str(), pair.other.c_str());
    if (pair.likeness)
      std::printf("  goal %.2f, text %.2f, home %.2f", pair.likeness->goal, pair.likeness->text, pair.likeness->home);
    std::printf("\n");
  }
}

}  // namespace

Json likeness_json(const LikenessReport& report) {
  Json json{{"folder", report.folder}};
  for (const auto& measure : report.measures) json[std::string(measure.name)] = measure_json(measure);
  json["shared_texts"] = report.shared_texts;
  return json;
}

void print_likeness(const LikenessReport& report) {
  std::printf("likeness to the nearest of %s\n%-8s %8s", report.folder.c_str(), "", "count");
  for (const auto& [name, share] : kQuantiles) std::printf(" %8s", std::string(name).c_str());
  std::printf(" %8s\n", "fails at");
  for (const auto& measure : report.measures) {
    std::printf("%-8s %8zu", std::string(measure.name).c_str(), measure.values.size());
    for (const auto& [name, share] : kQuantiles) std::printf(" %8.2f", measure.quantile(share));
    measure.fails_at ? std::printf(" %8.2f\n", *measure.fails_at) : std::printf(" %8s\n", "-");
  }
  std::printf("%d instructions are also there; on its own that is no leak\n", report.shared_texts);
  for (const auto& measure : report.measures) print_closest(measure);
  std::printf("\n");
}

}  // namespace unietp
