#include <algorithm>
#include <cmath>
#include <set>

#include "akb/fit.h"
#include "akb/import_common.h"
#include "akb/placement_rules.h"

// Where things are kept: seen in metadata or by rule, and only where the bodies leave room.
namespace unietp {
namespace {

constexpr int kMostBeside = 4;

/// Places on and in things share a sum; being beside or under something says nothing against them.
std::string share_of(const Placement& p) {
  const bool shares = p.relation == Predicate::On || p.relation == Predicate::Inside;
  return p.object + (shares ? "" : "\x1f" + std::string(info(p.relation).name));
}

}  // namespace

void TableBuilder::seen(const std::string& object, Predicate relation, const std::string& receptacle, double weight,
                        const std::string& source) {
  auto& placement = placements_[{object, info(relation).name, receptacle}];
  if (placement.object.empty()) placement = {object, relation, receptacle, 0, 1, {source, 0.9}};
  placement.likelihood += weight;
}

void TableBuilder::place_by_kind(double scale) {
  std::map<std::string, std::vector<PlacementRule>> rules;  // by kind of the object, in the file's order
  for (auto& rule : read_placement_rules(curated_, errors_)) {
    rules[rule.kind].push_back(std::move(rule));
  }
  std::map<std::string, std::vector<std::string>> of_kind;  // categories
  for (const auto& [name, kind] : kinds_) of_kind[kind].push_back(name);
  for (const auto& [object, c] : categories_) {
    const auto like = like_.find(kinds_[object]);
    for (const auto& own : {kinds_[object], like == like_.end() ? std::string() : like->second}) {
      for (const auto& rule : rules[own]) {
        for (const auto& kind : rule.receptacles) {
          for (const auto& receptacle : of_kind[kind]) place_by_rule(rule, c, categories_.at(receptacle), scale);
        }
      }
    }
  }
}

void TableBuilder::place_by_rule(const PlacementRule& rule, const Category& object, const Category& receptacle,
                                 double scale) {
  if (object.name == receptacle.name) return;
  if (rule.relation == Predicate::Inside && !has(receptacle.name, "container")) return;
  if (rule.relation == Predicate::On && !has(receptacle.name, "receptacle")) return;
  if (rule.relation != Predicate::NextTo && !fits(object, rule.relation, receptacle)) return;
  constexpr double kLessUsual = 0.8, kInNoHome = 0.3;
  const double usual = preferred_.empty() || preferred_.contains(receptacle.name) ? 1
                       : receptacle.rooms.empty()                                 ? kInNoHome
                                                                                  : kLessUsual;
  placements_.try_emplace(
      {object.name, info(rule.relation).name, receptacle.name},
      Placement{object.name, rule.relation, receptacle.name, rule.weight * scale * usual, 1, {"derived:kind", 0.7}});
}

std::set<std::tuple<std::string, Predicate, std::string>> TableBuilder::sensible_placements() {
  auto kept = std::move(placements_);
  placements_.clear();
  place_by_kind(1);
  std::set<std::tuple<std::string, Predicate, std::string>> found;
  for (const auto& [key, p] : placements_) found.emplace(p.object, p.relation, p.receptacle);
  placements_ = std::move(kept);
  return found;
}

/// Keeps the best derived placements of each object (its next_to when `beside`, else the others).
void TableBuilder::drop_all_but_best(bool beside) {
  std::map<std::pair<std::string, Predicate>, std::vector<const Placement*>> derived;
  for (const auto& [key, p] : placements_) {
    if ((p.relation == Predicate::NextTo) == beside && most_.contains(p.relation) &&
        p.source.source == "derived:kind") {
      derived[{p.object, p.relation}].push_back(&p);
    }
  }
  for (auto& [key, rows] : derived) {
    const std::size_t most = most_.find(key.second)->second;
    if (rows.size() <= most) continue;
    std::stable_sort(rows.begin(), rows.end(),
                     [](const Placement* a, const Placement* b) { return a->likelihood > b->likelihood; });
    constexpr double kAnother = 0.6;  // what each further receptacle of one kind counts against the one before
    std::map<std::string, double> of_kind;
    std::vector<std::pair<double, const Placement*>> ranked;
    for (const auto* row : rows) {
      double& share = of_kind.try_emplace(kinds_.at(row->receptacle), 1).first->second;
      ranked.emplace_back(row->likelihood * share, row);
      share *= kAnother;
    }
    std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (std::size_t i = most; i < ranked.size(); ++i) {
      const Placement& p = *ranked[i].second;
      placements_.erase({p.object, info(p.relation).name, p.receptacle});
    }
  }
}

/// How many of the object stand beside the other thing where both are put: on one support that has room for the two.
int TableBuilder::room_beside(const Placement& p) const {
  int most = 0;
  const auto &object = categories_.at(p.object), &other = categories_.at(p.receptacle);
  const std::string_view on = info(Predicate::On).name;
  for (auto at = placements_.lower_bound({p.object, on, ""});
       at != placements_.end() && at->second.object == p.object && at->second.relation == Predicate::On; ++at) {
    const auto& support = at->second.receptacle;
    if (support == p.receptacle || !placements_.contains({p.receptacle, on, support})) continue;
    if (!fit_side_by_side(object, other, categories_.at(support))) continue;
    most = std::max(most, std::clamp(at->second.capacity - 1, 1, kMostBeside));
  }
  return most;
}

bool TableBuilder::is_absurd(const std::string& object, Predicate relation, const std::string& receptacle) const {
  const auto *thing = find(object), *place = find(receptacle);
  return absurd_ && thing != nullptr && place != nullptr && absurd_(*thing, relation, *place);
}

void TableBuilder::drop_unfit_placements() {
  std::erase_if(placements_, [&](const auto& entry) {
    const Placement& p = entry.second;
    return is_absurd(p.object, p.relation, p.receptacle);
  });
  const auto drop = [&](bool beside, const auto& capacity) {
    for (auto& [key, p] : placements_) {
      if ((p.relation == Predicate::NextTo) == beside) p.capacity = capacity(p);
    }
    std::erase_if(placements_, [](const auto& entry) { return entry.second.capacity == 0; });
    drop_all_but_best(beside);
  };
  drop(false, [&](const Placement& p) {
    const auto object = categories_.find(p.object), receptacle = categories_.find(p.receptacle);
    if (object == categories_.end() || receptacle == categories_.end()) return 0;
    const bool shut = p.relation == Predicate::Inside && receptacle->second.archetype == Archetype::Drawers &&
                      !has(p.receptacle, "openable");
    const bool built_in = p.relation != Predicate::On && !object->second.movable;  // a faucet in its sink
    return shut || built_in ? 0 : capacity_of(object->second, p.relation, receptacle->second);
  });
  drop(true, [&](const Placement& p) {
    const auto object = categories_.find(p.object);
    const bool loose = object != categories_.end() && object->second.movable && categories_.contains(p.receptacle);
    return loose ? room_beside(p) : 0;
  });
}

void TableBuilder::drop_unfit() {
  drop_unfit_placements();
  std::erase_if(effects_, [&](const auto& entry) {
    const Effect& e = entry.second;
    const bool inside = has_need(e, EffectNeed::Inside), on = has_need(e, EffectNeed::On);
    const auto &tool = categories_.at(e.tool), &target = categories_.at(e.target);
    return (inside && !fits(target, Predicate::Inside, tool)) || (on && !fits(target, Predicate::On, tool));
  });
  std::set<std::pair<Predicate, std::string>> used;  // relation, receptacle
  for (const auto& [key, p] : placements_) used.emplace(p.relation, p.receptacle);
  // A derived receptacle in or on which nothing of this simulator fits is none.
  std::erase_if(affordances_, [&](const auto& entry) {
    const auto& fact = entry.second;
    const bool holds = fact.affordance == "container" || fact.affordance == "receptacle";
    const Predicate relation = fact.affordance == "container" ? Predicate::Inside : Predicate::On;
    return holds && fact.source.source == "derived:archetype" && !used.contains({relation, fact.category});
  });
}

void TableBuilder::normalize() {
  std::map<std::string, double> sum;
  for (const auto& [key, p] : placements_) sum[share_of(p)] += p.likelihood;
  for (auto& [key, p] : placements_) {
    p.likelihood = std::max(1e-4, std::round(p.likelihood / sum[share_of(p)] * 1e4) / 1e4);
  }
}

}  // namespace unietp
