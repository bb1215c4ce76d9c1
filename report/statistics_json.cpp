#include <nlohmann/json.hpp>

#include "report/statistics.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

/// A list, since names such as words and categories are no fields.
Json to_json(const Tally& tally) {
  Json list = Json::array();
  for (const auto& [name, count] : tally) list.push_back({{"name", name}, {"count", count}});
  return list;
}

Json to_json(const Histogram& histogram) {
  Json counts = Json::array();
  for (const auto& [value, count] : histogram.counts) counts.push_back({{"value", value}, {"count", count}});
  return {{"mean", histogram.mean()}, {"median", histogram.median()}, {"counts", std::move(counts)}};
}

Json to_json(const DatasetStatistics& set) {
  Json pairs = Json::array();
  for (const auto& [key, count] : set.by_simulator_and_split)
    pairs.push_back({{"simulator", key.first}, {"split", key.second}, {"tasks", count}});
  Json plans = Json::array();
  for (const auto& [mode, lengths] : set.plan_lengths)
    plans.push_back({{"mode", mode},
                     {"lengths", to_json(lengths)},
                     {"actions", to_json(set.actions.at(mode))},
                     {"failed_steps", set.failed_steps.at(mode)}});
  Json funnel = Json::array();
  for (const FunnelRow& row : set.funnel)
    funnel.push_back({{"template", row.template_name}, {"accepted", row.accepted}, {"given_up", to_json(row.causes)}});
  Json coverage = Json::array();
  for (const auto& one : set.coverage)
    coverage.push_back(
        {{"simulator", one.simulator}, {"known", one.known}, {"handled", one.handled}, {"in_homes", one.in_homes}});
  Json things = Json::array();
  for (const GoalThings& one : set.things)
    things.push_back({{"simulator", one.simulator},
                      {"objects", one.objects},
                      {"added", one.added},
                      {"moved", one.moved},
                      {"categories", to_json(one.categories)},
                      {"movable", one.movable},
                      {"common_unused", one.common_unused}});
  Json balance = Json::array();
  for (const Evenness& even : set.evenness)
    balance.push_back({{"dimension", even.dimension},
                       {"effective", even.effective},
                       {"by_entropy", even.by_entropy},
                       {"variation", even.variation},
                       {"tasks", to_json(even.tasks)}});
  return {{"name", set.name},
          {"tasks", set.tasks},
          {"candidates", set.candidates()},
          {"by_simulator_and_split", std::move(pairs)},
          {"templates", to_json(set.templates)},
          {"purposes", to_json(set.purposes)},
          {"instructions",
           {{"styles", to_json(set.styles)},
            {"phenomena", to_json(set.phenomena)},
            {"writers", to_json(set.writers)},
            {"lengths", to_json(set.instruction_words)},
            {"distinct_words", set.distinct_words},
            {"words", to_json(set.words)}}},
          {"goals",
           {{"operators", to_json(set.operators)},
            {"predicates", to_json(set.predicates)},
            {"alternatives", to_json(set.alternatives)},
            {"kinds", to_json(set.kinds_asked_for)}}},
          {"plans", std::move(plans)},
          {"funnel", std::move(funnel)},
          {"categories", std::move(coverage)},
          {"things", std::move(things)},
          {"homes", {{"count", set.homes}, {"rooms", to_json(set.rooms)}, {"objects", to_json(set.objects)}}},
          {"balance", std::move(balance)}};
}

}  // namespace

std::string usual_coverage_json(const std::vector<std::pair<std::string, std::vector<UsualCoverage>>>& sets) {
  Json list = Json::array();
  for (const auto& [name, all] : sets) {
    Json simulators = Json::array();
    for (const UsualCoverage& one : all) {
      Json common = Json::array();
      for (const CommonUnused& unused : one.common)
        common.push_back({{"category", unused.category}, {"templates", unused.templates}, {"tasks", unused.tasks}});
      Json sole = Json::array();
      for (const SoleCategory& only : one.sole)
        sole.push_back({{"category", only.category},
                        {"templates", only.templates},
                        {"tasks", only.tasks},
                        {"named", only.named},
                        {"all", only.all}});
      simulators.push_back({{"simulator", one.simulator},
                            {"with_usual_goals", one.usual},
                            {"in_goals", one.usual - one.missing.size()},
                            {"in_no_goal", one.missing},
                            {"common_in_no_goal", std::move(common)},
                            {"only_choice", std::move(sole)}});
    }
    list.push_back({{"name", name}, {"simulators", std::move(simulators)}});
  }
  const Json json{{"format", "unietp-usual-coverage/1"}, {"sets", std::move(list)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string statistics_json(const std::vector<DatasetStatistics>& sets) {
  Json list = Json::array();
  for (const auto& set : sets) list.push_back(to_json(set));
  const Json json{{"format", "unietp-statistics/1"}, {"sets", std::move(list)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace unietp
