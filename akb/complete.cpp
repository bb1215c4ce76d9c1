#include "akb/complete.h"

#include <algorithm>

#include "core/text.h"

namespace unietp {
namespace {

bool is_filled(const CompletionBatch& batch, const StatedFacts& stated) {
  return std::all_of(batch.facts.begin(), batch.facts.end(), [&](FactKind kind) {
    return std::all_of(batch.categories.begin(), batch.categories.end(),
                       [&](const std::string& name) { return is_stated(stated, kind, name); });
  });
}

/// Adds the facts of `from` whose category has none of the kind yet.
template <class Row, class Key>
void add(std::vector<Row>& to, std::vector<Row> from, const StatedFacts& stated, std::map<FactKind, int>& accepted,
         const Key& key) {
  for (auto& row : from) {
    const auto [kind, category] = key(row);
    if (is_stated(stated, kind, category)) continue;
    ++accepted[kind];
    to.push_back(std::move(row));
  }
}

void add_facts(CompletedFacts& to, CompletedFacts from, std::map<FactKind, int>& accepted) {
  const auto stated = stated_by(to);
  const auto of = [](FactKind kind) {
    return [kind](const auto& row) { return std::pair(kind, std::string_view(row.category)); };
  };
  add(to.sizes, std::move(from.sizes), stated, accepted, of(FactKind::Size));
  add(to.masses, std::move(from.masses), stated, accepted, of(FactKind::Mass));
  add(to.synsets, std::move(from.synsets), stated, accepted, of(FactKind::Synset));
  add(to.affordances, std::move(from.affordances), stated, accepted, of(FactKind::Affordances));
  add(to.placements, std::move(from.placements), stated, accepted,
      [](const Placement& p) { return std::pair(FactKind::Placements, std::string_view(p.object)); });
  add(to.aliases, std::move(from.aliases), stated, accepted,
      [](const Alias& a) { return std::pair(kind_of(a), std::string_view(a.category)); });
}

std::size_t count_of(const CompletedFacts& facts) {
  return facts.sizes.size() + facts.masses.size() + facts.synsets.size() + facts.affordances.size() +
         facts.placements.size() + facts.aliases.size();
}

/// Facts that a laying adds to the tables, or fills in.
int count_used(const CompletedFacts& facts, const Tables& tables) {
  Tables laid = tables;
  lay_under(facts, stated_by(tables), laid);
  int used = static_cast<int>(laid.affordances.size() - tables.affordances.size() + laid.placements.size() -
                              tables.placements.size() + laid.aliases.size() - tables.aliases.size());
  const auto from_model = [](const Source& source) { return source.source.starts_with("llm:") ? 1 : 0; };
  for (const auto& c : laid.categories)
    used += from_model(c.size_source) + from_model(c.mass_source) + from_model(c.synset_source);
  return used;
}

}  // namespace

CompletionPlan plan_completion(const std::filesystem::path& tables, const LlmEndpoint& endpoint,
                               const CompletionOptions& options, LlmCache* cache, std::vector<Error>& errors) {
  CompletionPlan plan;
  int left = options.limit.value_or(0);
  const auto stated_tables = read_stated_tables(tables, options.overrides, errors);
  for (const auto simulator : options.simulators) {
    CompletionPlan::Base base;
    base.simulator = simulator;
    base.tables = stated_tables[static_cast<std::size_t>(simulator)];
    base.completed = read_completed(completed_folder(tables, simulator), base.tables, errors);
    const auto stated = stated_by(base.completed);
    const int size = options.limit ? std::min(options.batch, std::max(1, *options.limit)) : options.batch;
    for (auto& batch : completion_batches(base.tables, options.facts, size)) {
      for (const auto kind : batch.facts) {
        plan.lacking[kind] += static_cast<int>(batch.categories.size());
        for (const auto& name : batch.categories) plan.completed[kind] += is_stated(stated, kind, name) ? 1 : 0;
      }
      if (is_filled(batch, stated)) continue;
      auto request = completion_request(base.tables, batch);
      request.temperature = options.temperature;
      request.max_tokens = options.max_tokens;
      const bool cached = cache != nullptr && cache->find(digest_of(endpoint, request));
      if (options.limit && !cached) {
        const int categories = static_cast<int>(batch.categories.size());
        if (categories > left) continue;
        left -= categories;
      }
      plan.requests.push_back(std::move(request));
      plan.batches.push_back(std::move(batch));
      plan.base_of.push_back(plan.bases.size());
    }
    plan.bases.push_back(std::move(base));
  }
  return plan;
}

Result<CompletionReport> complete_knowledge(const std::filesystem::path& tables, const LlmEndpoint& endpoint,
                                            const CompletionOptions& options, LlmCache* cache, CompletionPlan plan) {
  const Source source{"llm:" + endpoint.model, options.confidence};
  if (!well_formed_source(source.source))
    return Error{
        Error::Kind::Usage, "model", {}, "expected a name without spaces, because it becomes a source of facts"};
  const auto wordnet = WordNet::read(options.wordnet);
  CompletionReport report;
  std::vector<std::vector<RejectedFact>> rejected(plan.requests.size());
  std::optional<Error> unwritten;
  const auto write = [&](const CompletionPlan::Base& base) {
    auto written = write_completed(completed_folder(tables, base.simulator), base.completed);
    if (!written && !unwritten) unwritten = written.error();
  };
  LlmOptions ask = options.ask;
  ask.on_answer = [&](std::size_t i, const Result<LlmAnswer>& answer) {
    if (answer) {
      auto& base = plan.bases[plan.base_of[i]];
      auto checked =
          check_completion(answer->text, base.tables, plan.batches[i], source, wordnet ? &*wordnet : nullptr);
      rejected[i] = std::move(checked.rejected);
      add_facts(base.completed, std::move(checked.accepted), report.accepted);
      write(base);
    }
    if (options.ask.on_answer) options.ask.on_answer(i, answer);
  };
  const auto answers = ask_all(endpoint, plan.requests, ask, cache);
  if (unwritten) return *unwritten;

  report.totals = totals_of(answers);
  report.stopped = options.ask.stop != nullptr && *options.ask.stop;
  for (const auto& answer : answers) {
    if (!answer) ++report.failures[format(answer.error())];
  }
  for (auto& some : rejected) {
    for (auto& fact : some) report.rejected.push_back(std::move(fact));
  }
  for (const auto& base : plan.bases)
    report.unused += static_cast<int>(count_of(base.completed)) - count_used(base.completed, base.tables);
  return report;
}

}  // namespace unietp
