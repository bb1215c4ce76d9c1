#include "run/candidate_planner.h"

#include "dataset/candidate_number.h"

#include <algorithm>
#include <utility>

#include "generator/domain_constraints.h"
#include "generator/weighted_binding.h"
#include "run/category_weights.h"
#include "run/fit_of_home.h"
#include "run/new_uses.h"
#include "run/styles_of_slots.h"

namespace unietp {
namespace {

constexpr int kHomesTried = 24;  // for a slot, until one offers a binding

std::string key(Simulator simulator, const std::string& name) { return std::string(name_of(simulator)) + "/" + name; }

bool offers_all(const Layout& layout, const Binding& fixed) {
  return std::all_of(fixed.begin(), fixed.end(), [&](const auto& one) {
    return std::binary_search(layout.offer.categories.begin(), layout.offer.categories.end(), one.second);
  });
}

}  // namespace

CandidatePlanner::CandidatePlanner(const RunConfiguration& configuration, const Resources& resources,
                                   LayoutPool& layouts, const std::vector<TaskSlot>& slots)
    : configuration_(configuration),
      resources_(resources),
      layouts_(layouts),
      slots_(slots),
      styles_(styles_of_templates(resources.templates)),
      turns_(slots.size()) {}

std::vector<CandidatePlan> CandidatePlanner::round(const std::vector<int>& open, int attempt,
                                                   const Frequencies& taken) {
  counts_ = taken;
  auto& counts = counts_;
  const auto position = [&](int slot) { return static_cast<std::size_t>(slot - slots_.front().index); };
  for (const int slot : open) {  // slots that keep a template count before any is drawn
    if (turn_of(slot).left > 0) counts.add({Dimension::Template, resources_.templates[turn_of(slot).source].name});
  }
  std::vector<CandidatePlan> plans;
  for (const int number : open) {
    const auto& slot = slots_[position(number)];
    const std::size_t looks = resources_.homes.empty() ? 1 : slot.templates.size();
    CandidatePlan plan;
    for (std::size_t look = 0; look < looks && !plan.binding; ++look) plan = next_candidate(slot, attempt, look);
    count(plan, slot, counts);
    plans.push_back(std::move(plan));
  }
  for (const auto& plan : plans) ++tried_[{slots_[position(plan.slot)].simulator, plan.home}];
  return plans;
}

CandidatePlan CandidatePlanner::next_candidate(const TaskSlot& slot, int attempt, std::size_t look) {
  auto& turn = turn_of(slot.index);
  const Rng rng = Rng(configuration_.seed).fork("plan", candidate_number(slot.index, attempt));
  const auto name = [&] { return resources_.templates[turn.source].name; };
  if (turn.left == 0) {
    if (turn.more > 0 && counts_.count(Dimension::Template, name()) == 0) {
      turn.left = std::exchange(turn.more, 0);
    } else {
      turn.source = next_template(slot, turn, counts_, rng.fork("template", look));
      turn.left = kAttemptsPerTemplate;
      turn.more = turn.drawn == 1 ? kAttemptsForUnused : 0;
    }
    counts_.add({Dimension::Template, name()});
  }
  --turn.left;
  CandidatePlan plan{slot.index,
                     attempt,
                     turn.source,
                     0,
                     std::nullopt,
                     least_of(slot, turn.source, attempt),
                     style_of(slot, turn.drawn - 1)};
  choose_home(plan, slot, counts_, rng);
  if (!plan.binding) turn.left = turn.more = 0;
  return plan;
}

Grade CandidatePlanner::least_of(const TaskSlot& slot, std::size_t source, int attempt) const {
  const auto at = std::find(slot.templates.begin(), slot.templates.end(), source) - slot.templates.begin();
  const Grade least = slot.least[static_cast<std::size_t>(at)];
  const bool late = attempt >= static_cast<int>(kPatience * configuration_.attempts);
  return late ? std::min(least, Grade::Tolerable) : least;
}

/// The phenomenon of a slot when its template number `drawn` is tried.
std::optional<Style> CandidatePlanner::style_of(const TaskSlot& slot, int drawn) {
  const auto at = static_cast<std::size_t>(drawn / kTemplatesPerStyle);
  return at < slot.styles.size() ? std::optional(slot.styles[at]) : std::nullopt;
}

std::size_t CandidatePlanner::next_template(const TaskSlot& slot, Turn& turn, const Frequencies& counts,
                                            Rng rng) const {
  const auto style = style_of(slot, turn.drawn++);
  if (turn.tried.empty()) {
    turn.tried.push_back(slot.templates[slot.first_template]);
    return turn.tried.back();
  }
  std::vector<std::size_t> fresh;
  const auto find_fresh = [&] {
    for (const auto source : slot.templates) {
      if (style && !is_among(*style, styles_[source])) continue;
      if (std::find(turn.tried.begin(), turn.tried.end(), source) == turn.tried.end()) fresh.push_back(source);
    }
  };
  find_fresh();
  if (fresh.empty()) turn.tried.clear(), find_fresh();
  const auto uses = [&](std::size_t source) {
    return counts.count(Dimension::Template, resources_.templates[source].name);
  };
  if (std::any_of(fresh.begin(), fresh.end(), [&](std::size_t source) { return uses(source) == 0; }))
    std::erase_if(fresh, [&](std::size_t source) { return uses(source) > 0; });
  std::vector<double> weights;
  for (const auto source : fresh)
    weights.push_back(counts.weight(Dimension::Template, resources_.templates[source].name));
  turn.tried.push_back(fresh[rng.weighted(weights)]);
  return turn.tried.back();
}

void CandidatePlanner::choose_home(CandidatePlan& plan, const TaskSlot& slot, Frequencies& counts, const Rng& rng) {
  std::vector<int> homes;
  std::vector<double> weights;
  for (int home = 0; home < layouts_.size(slot.simulator); ++home) {
    const auto& layout = layouts_.layout(slot.simulator, home);
    if (!layout) continue;
    if (barren_.contains({plan.source, slot.simulator, home, plan.least, plan.style})) {
      plan.home = home;
      continue;
    }
    homes.push_back(home);
    // A home that lacks the fixed categories is tried last.
    const double fit = offers_all(*layout, configuration_.binding) ? 1 : 1e-9;
    // Homes without a task are preferred, so that each gets one; homes with failed candidates are tried less often.
    const auto tried = tried_.find({slot.simulator, home});
    const double patience = 1.0 / (1 + (tried == tried_.end() ? 0 : tried->second));
    const double wanted = counts.weight(Dimension::Scene, layout->home.scene.id), wanted_more = wanted * wanted;
    weights.push_back(fit * wanted_more * wanted_more * wanted * patience * patience);
  }
  Rng draw = rng.fork("home", 0);
  for (int look = 0; look < kHomesTried && !homes.empty(); ++look) {
    const auto drawn = draw.weighted(weights);
    plan.home = homes[drawn];
    plan.binding = draw_binding(plan, slot, counts, rng.fork("binding", static_cast<std::uint64_t>(look)));
    if (plan.binding) return;
    barren_.insert({plan.source, slot.simulator, plan.home, plan.least, plan.style});
    homes.erase(homes.begin() + static_cast<std::ptrdiff_t>(drawn));
    weights.erase(weights.begin() + static_cast<std::ptrdiff_t>(drawn));
  }
}

std::optional<Binding> CandidatePlanner::draw_binding(const CandidatePlan& plan, const TaskSlot& slot,
                                                      const Frequencies& counts, Rng rng) {
  const auto& layout = *layouts_.layout(slot.simulator, plan.home);
  const auto& rooms = rooms_of(slot.simulator, plan.home, layout);
  const auto& source = resources_.templates[plan.source];
  const Knowledge& knowledge = resources_.backend(slot.simulator).knowledge;
  const CategoryWeight weight =
      with_new_uses(weight_in(layout, source, slot.split, counts, &rooms),
                    {plan.style, configuration_.seed, slot.index / configuration_.block}, source, knowledge, counts);
  const BindingWishes wishes{configuration_.binding, weight,
                             fits_home(configuration_, resources_, source, layout, plan.least, plan.style)};
  return sample_binding(source, knowledge, layout.offer.categories, wishes, rng);
}

void CandidatePlanner::count(const CandidatePlan& plan, const TaskSlot& slot, Frequencies& counts) {
  if (!plan.binding) return;
  const auto& layout = *layouts_.layout(slot.simulator, plan.home);
  const auto& source = resources_.templates[plan.source];
  const auto& rooms = rooms_of(slot.simulator, plan.home, layout);
  counts.add({Dimension::Scene, layout.home.scene.id});
  counts.add(uses_of(source, *plan.binding, plan.style, resources_.backend(slot.simulator).knowledge));
  for (std::size_t i = 0; i < plan.binding->size(); ++i) {
    if (is_value(source.parameters[i])) continue;
    const auto& category = (*plan.binding)[i].second;
    counts.add({dimension_of(source.parameters[i], source), key(slot.simulator, category)});
    const auto stands = rooms.find(category);
    if (stands == rooms.end()) continue;
    for (const auto& [type, share] : stands->second) counts.add({Dimension::Room, type}, share);
  }
}

const RoomTypes& CandidatePlanner::rooms_of(Simulator simulator, int home, const Layout& layout) {
  const auto [at, fresh] = rooms_.try_emplace({simulator, home});
  if (fresh) at->second = room_types_in(layout);
  return at->second;
}

}  // namespace unietp
