#include "logic/monitor.h"

#include <algorithm>
#include <cassert>

#include "logic/membership.h"
#include "logic/monitor_parts.h"
#include "logic/monitor_report.h"

namespace unietp {

using namespace monitoring;

struct Monitor::Impl {
  Program program;
  Residuals residuals;
  Part root;
  KnownEntities known;
  EntityList entities;    // as last given, so that reports can name them
  std::vector<bool> met;  // by entity: it has existed
  std::size_t live = 0;   // residuals kept by the last clearing out
  bool started = false;

  void take_in(const EntityList& given, const Facts& facts);
  void clear_out();
};

/// Sorts the entities that exist for the first time into the domains of the goal.
void Monitor::Impl::take_in(const EntityList& given, const Facts& facts) {
  assert(given.size() >= entities.size());
  entities.follow(given);
  met.resize(entities.size());
  known.members.resize(program.quantifiers.size());
  known.fresh_from.clear();
  for (const auto& members : known.members) known.fresh_from.push_back(members.size());
  for (EntityIndex e; e.index() < entities.size(); ++e) {
    if (entities[e].kind == Entity::Kind::Agent) known.agent = std::min(known.agent.value_or(e), e);
    if (met[e.index()] || !facts.exists(e)) continue;
    met[e.index()] = true;
    for (Slot slot = 0; slot < program.quantifiers.size(); ++slot) {
      const Quantifier& quantifier = program.quantifiers[slot];
      if (quantifier.first_state_only && started) continue;
      if (is_of(entities[e], quantifier.domain)) known.members[slot].push_back(e);
    }
  }
  if (!started) known.first = facts;
  known.last = facts;
  started = true;
}

namespace {

void import_part(Part& part, const Residuals& from, Residuals& to, std::vector<Ref>& known) {
  part.origin = to.import(from, part.origin, known);
  part.residual = to.import(from, part.residual, known);
  for (auto& group : part.groups) {
    for (auto& inner : group.parts) import_part(inner, from, to, known);
    for (auto& inner : group.waiting) import_part(inner, from, to, known);
  }
}

}  // namespace

/// Drops residuals that are no longer used once they outnumber the others.
void Monitor::Impl::clear_out() {
  constexpr std::size_t kFew = 1024;
  if (residuals.size() < 2 * live + kFew) return;
  Residuals kept;
  std::vector<Ref> known_refs(residuals.size(), kFalse);
  import_part(root, residuals, kept, known_refs);
  residuals = std::move(kept);
  live = residuals.size();
}

Monitor::Monitor(const Formula& goal) : impl_(std::make_unique<Impl>()) {
  impl_->program = compile(goal);
  impl_->root = build_part(impl_->program, impl_->program.root, impl_->residuals);
}
Monitor::Monitor(const Monitor& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
Monitor::Monitor(Monitor&&) noexcept = default;
Monitor& Monitor::operator=(const Monitor& other) {
  if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
  return *this;
}
Monitor& Monitor::operator=(Monitor&&) noexcept = default;
Monitor::~Monitor() = default;

void Monitor::observe(const EntityList& entities, const Facts& facts) {
  impl_->take_in(entities, facts);
  impl_->clear_out();
  Progression step(impl_->program, impl_->known, impl_->residuals);
  update_part(impl_->root, impl_->program, impl_->known, impl_->residuals, step);
}

bool Monitor::satisfied() const { return impl_->started && impl_->root.now; }

bool Monitor::hopeless() const {
  return impl_->started && !impl_->root.now && verdict_of(impl_->root, impl_->program) == PartVerdict::Violated;
}

double Monitor::progress() const {
  if (!impl_->started) return 0;
  Residuals scratch = impl_->residuals;
  return Report(impl_->program, impl_->known, impl_->entities, scratch).progress(impl_->root);
}

std::string Monitor::missing() const {
  if (!impl_->started) return "no state has been observed yet";
  if (impl_->root.now) return "";
  Residuals scratch = impl_->residuals;
  return Report(impl_->program, impl_->known, impl_->entities, scratch).missing(impl_->root);
}

}  // namespace unietp
