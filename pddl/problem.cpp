#include "pddl/problem.h"

#include <algorithm>
#include <set>

#include "pddl/domain.h"
#include "pddl/monitors.h"
#include "pddl/names.h"
#include "scene/states.h"
#include "symbolic/perform.h"

namespace unietp::pddl {
namespace {

using symbolic::Id;
using symbolic::kNobody;
using symbolic::PlaceKind;

/// The facts of one world.
class FactWriter {
 public:
  FactWriter(const symbolic::Setting& setting, const symbolic::World& world, const Problem& names)
      : setting_(setting), rules_(*setting.rules), start_(world), names_(names) {}

  std::set<std::string> write() {
    write_things();
    write_relations();
    write_reactions();
    if (start_.room != kNobody) add("(agent-in " + name(start_.room) + ")");
    if (start_.held == kNobody) add("(hand-empty)");
    if (start_.seat != kNobody) add("(seated)");
    return std::move(facts_);
  }

 private:
  void add(std::string fact) { facts_.insert(std::move(fact)); }
  const std::string& name(Id id) const { return id.is_room() ? names_.rooms[id.index()] : names_.things[id.index()]; }
  std::size_t number() const { return start_.things.size(); }

  void write_things() {
    const auto affordances = affordances_for(rules_.capabilities().actions);
    for (std::size_t i = 0; i < number(); ++i) {
      const auto id = Id::thing(i);
      const auto& thing = start_[id];
      const auto& kind = setting_.kind_of(id);
      const auto of = " " + name(id) + ")";
      if (kind.pickupable) add("(pickupable" + of);
      if (kind.openable) add("(openable" + of);
      if (kind.fillable) add("(fillable" + of);
      if (kind.allows(ActionType::UseUp)) add("(consumable" + of);
      if (kind.shuts_to_run && rules_.capabilities().power_needs_closed) add("(shuts-to-run" + of);
      for (const auto affordance : affordances) {
        const auto& actions = extension_actions();
        if (std::any_of(actions.begin(), actions.end(), [&](const ActionInfo& action) {
              return affordance_for(action) == affordance && kind.allows(action.type);
            }))
          add("(" + std::string(affordance) + of);
      }
      add("(rests " + name(id) + of);
      const Id whole = setting_.objects.things[i].whole;
      if (whole != kNobody) write_piece(id, whole);
      if (!thing.exists) continue;
      add("(present" + of);
      if (thing.where == PlaceKind::Floor) add("(standing" + of);
      for (const auto& group : state_groups()) {
        for (const auto state : group.predicates) {
          if (thing.has(state)) add("(" + std::string(info(state).name) + of);
        }
      }
      for (const auto& action : extension_actions()) {  // states of no group
        if (action.changes.empty()) continue;
        const auto state = action.changes.front().state;
        if (info(state).group.empty() && thing.has(state)) add("(" + std::string(info(state).name) + of);
      }
      if (thing.has(Predicate::Filled))
        add("(filled-with " + name(id) + " " + names_.substances[thing.filling.index()] + ")");
      for (std::size_t s = 0; s < names_.substances.size(); ++s) {
        if (!thing.coats.contains(symbolic::SubstanceId(s))) continue;
        add("(covered-with " + name(id) + " " + names_.substances[s] + ")");
        if (rules_.symbols()[s] != "dust") add("(stained" + of);
      }
      if (start_.held == id) add("(held" + of);
      if (start_.by != kNobody && root_of(start_, id) == start_.by) add("(near" + of);
    }
    for (std::size_t s = 0; s < names_.substances.size(); ++s) {
      if (rules_.symbols()[s] != "dust") add("(staining " + names_.substances[s] + ")");
    }
  }

  void write_piece(Id piece, Id whole) {
    add("(piece-of " + name(piece) + " " + name(whole) + ")");
    int place = 0;  // among the pieces of its whole
    for (std::size_t i = 0; i < piece.index(); ++i) {
      if (setting_.objects.things[i].whole == whole) ++place;
    }
    for (std::size_t k = 0; k < number(); ++k) {
      const auto knife = Id::thing(k);
      const auto* cut = rules_.reaction(setting_.kind_number(knife), Treatment::Slices, setting_.kind_number(whole));
      if (cut != nullptr && cut->piece == setting_.kind_number(piece) && place < cut->pieces)
        add("(piece-by " + name(piece) + " " + name(knife) + ")");
    }
  }

  void write_relations() {
    for (std::size_t i = 0; i < number(); ++i) {
      const auto id = Id::thing(i);
      const auto& thing = start_[id];
      if (!thing.exists) continue;
      const auto me = " " + name(id) + " ";
      if (thing.where == PlaceKind::On) add("(on" + me + name(thing.at) + ")");
      if (thing.where == PlaceKind::Floor && thing.at != kNobody) add("(on_floor" + me + name(thing.at) + ")");
      if (const Id room = room_of(start_, id); room != kNobody) add("(in_room" + me + name(room) + ")");
      Id innermost = kNobody;
      for (Id step = id; start_[step].where == PlaceKind::On || start_[step].where == PlaceKind::Inside;) {
        const bool inside = start_[step].where == PlaceKind::Inside;
        step = start_[step].at;
        add("(rests" + me + name(step) + ")");
        if (!inside) continue;
        const bool shut = setting_.kind_of(step).openable && !start_[step].has(Predicate::Open);
        if (shut && innermost == kNobody) innermost = step;
      }
      for (std::size_t k = 0; k < number(); ++k) {
        if (is_inside(start_, id, Id::thing(k))) add("(inside" + me + names_.things[k] + ")");
      }
      add(innermost == kNobody ? "(free " + name(id) + ")" : "(shut" + me + name(innermost) + ")");
    }
  }

  void write_reactions() {
    for (std::size_t t = 0; t < number(); ++t) {
      const auto tool = Id::thing(t);
      for (std::size_t i = 0; i < number(); ++i) {
        const auto id = Id::thing(i);
        if (id == tool) continue;
        const auto& rules = rules_;
        const auto own = setting_.kind_number(id), other = setting_.kind_number(tool);
        const auto both = " " + name(id) + " " + name(tool) + ")", reversed = " " + name(tool) + " " + name(id);
        if (rules.capacity(own, Predicate::On, other) > 0) add("(fits-on" + both);
        if (rules.capacity(own, Predicate::Inside, other) > 0) add("(fits-in" + both);
        if (setting_.kind_of(tool).drain || rules.reaction(other, Treatment::Drains, own) != nullptr) {
          if (setting_.kind_of(id).fillable) add("(drains" + reversed + ")");
        }
        for (const auto& reaction : rules.reactions(other, own)) {
          if (reaction.treatment == Treatment::Slices && setting_.kind_of(id).sliceable) add("(cuts" + reversed + ")");
          if (reaction.treatment == Treatment::Wipes) add("(wipes" + reversed + ")");
          if (reaction.treatment == Treatment::Cools) add("(can-cool" + reversed + ")");
          if (reaction.treatment == Treatment::Dispenses)
            add("(dispenses" + reversed + " " + names_.substances[reaction.symbol.index()] + ")");
          const auto process = class_of(setting_, tool, reaction);
          if (!process || !setting_.kind_of(id).movable) continue;
          const bool fills = reaction.treatment == Treatment::Fills;
          add("(" + name_of(*process) + reversed + (fills ? " " + names_.substances[reaction.symbol.index()] : "") +
              ")");
        }
      }
    }
  }

  const symbolic::Setting& setting_;
  const symbolic::Rules& rules_;
  const symbolic::World& start_;
  const Problem& names_;
  std::set<std::string> facts_;
};

class ProblemWriter {
 public:
  ProblemWriter(const symbolic::Setting& setting, const symbolic::World& start) : setting_(setting), start_(start) {
    std::vector<std::string> all;
    for (const auto& role : setting_.objects.things) all.push_back(role.id);
    for (const auto& room : setting_.objects.rooms) all.push_back(room.id);
    for (const auto& symbol : setting_.rules->symbols()) all.push_back(symbol);
    const auto names = names_for(all);
    const auto things = static_cast<std::ptrdiff_t>(setting_.objects.things.size());
    const auto rooms = static_cast<std::ptrdiff_t>(setting_.objects.rooms.size());
    made_.things.assign(names.begin(), names.begin() + things);
    made_.rooms.assign(names.begin() + things, names.begin() + things + rooms);
    made_.substances.assign(names.begin() + things + rooms, names.end());
  }

  Result<Problem> write(const std::string& id, Simulator simulator, const symbolic::Goal& goal) {
    symbolic::Progress progress(goal);
    progress.observe(goal, setting_, start_);
    if (holds(goal, goal.root(), setting_, start_, progress))
      return Error{Error::Kind::Unsatisfiable, "goal", {}, "it holds at the start"};
    auto text = goal_text(goal, made_);
    if (!text) return text.error();
    made_.watching = !text->monitors.empty();
    facts_ = FactWriter(setting_, start_, made_).write();
    write_monitors(*text);
    add("(ready)");
    std::string init;
    for (const auto& fact : facts_) init += "    " + fact + "\n";
    made_.text = "(define (problem " + name_for(id) + ")\n  (:domain " + domain_name(simulator) + ")\n  (:objects\n" +
                 objects(*text) + "  )\n  (:init\n" + init + "  )\n  (:goal (and " +
                 (made_.watching ? "(ready) " : "") + text->goal + "))\n)\n";
    return std::move(made_);
  }

 private:
  void add(std::string fact) { facts_.insert(std::move(fact)); }

  std::string objects(const GoalText& goal) const {
    std::string movables, others;
    for (std::size_t i = 0; i < start_.things.size(); ++i) {
      const auto& kind = setting_.kind_of(Id::thing(i));
      (kind.movable ? movables : others) += " " + made_.things[i];
    }
    const auto line = [](const std::string& names, const char* type) {
      return names.empty() ? "" : "   " + names + " - " + type + "\n";
    };
    std::string rooms, substances, monitors;
    for (const auto& room : made_.rooms) rooms += " " + room;
    for (const auto& substance : made_.substances) substances += " " + substance;
    for (const auto& monitor : goal.monitors) monitors += " " + monitor.name;
    return line(movables, "movable") + line(others, "thing") + line(rooms, "room") + line(substances, "substance") +
           line(monitors, "monitor");
  }

  void write_monitors(const GoalText& goal) {
    if (!made_.watching) return;
    add("(watching)");
    for (const auto& monitor : goal.monitors) {
      auto fact = *fact_of(monitor.atom, made_);  // "(on a b)" -> "(watches-on m1 a b)"
      const auto blank = fact.find(' ');
      const auto watched = fact.substr(1, blank - 1);
      add("(watches-" + std::string(monitor.negative ? "not-" : "") + watched + " " + monitor.name +
          fact.substr(blank));
      const auto& atom = monitor.atom;
      const bool now =
          holds(setting_, start_, atom.predicate, atom.first, atom.second, atom.symbol) != monitor.negative;
      add("(" + std::string(now ? "seen " : "missed ") + monitor.name + ")");
      if (now) add("(now " + monitor.name + ")");
    }
    const auto both = [&](const auto& pair) {
      return " " + goal.monitors[pair.first].name + " " + goal.monitors[pair.second].name + ")";
    };
    const auto now = [&](std::size_t monitor) { return facts_.count("(now " + goal.monitors[monitor].name + ")") > 0; };
    for (const auto& pair : goal.ordered) add("(ordered" + both(pair));
    for (const auto& pair : goal.kept) {
      add("(kept-until" + both(pair));
      if (!now(pair.first) && !now(pair.second)) add("(not-kept" + both(pair));
    }
  }

  const symbolic::Setting& setting_;
  const symbolic::World& start_;
  Problem made_;
  std::set<std::string> facts_;
};

}  // namespace

Result<Problem> problem_for(const std::string& id, Simulator simulator, const symbolic::Setting& setting,
                            const symbolic::World& start, const symbolic::Goal& goal) {
  return ProblemWriter(setting, start).write(id, simulator, goal);
}

std::vector<std::string> facts_of(const symbolic::Setting& setting, const symbolic::World& world,
                                  const Problem& names) {
  const auto facts = FactWriter(setting, world, names).write();
  return {facts.begin(), facts.end()};
}

}  // namespace unietp::pddl
