#include "sense/grade_goal.h"

#include <algorithm>
#include <optional>
#include <set>

#include "core/text.h"
#include "sense/action_roles.h"
#include "sense/wants.h"

namespace unietp {
namespace {

bool is_place(const Want& want) {
  return (want.predicate == Predicate::On || want.predicate == Predicate::Inside) && !want.negated;
}

bool turns(const Want& want) {
  return !want.negated && (want.predicate == Predicate::Open || want.predicate == Predicate::Closed ||
                           want.predicate == Predicate::PowerOn || want.predicate == Predicate::PowerOff);
}

/// True for two wants that may say something together which neither says alone.
bool go_together(const Want& a, const Want& b) {
  if (a.thing == b.thing) return true;
  if (is_place(a) && is_place(b) && (a.other == b.other || a.other == b.thing || b.other == a.thing)) return true;
  return (turns(a) && (is_place(b) || turns(b))) || (turns(b) && is_place(a));
}

/// True when `outer` puts somewhere what `inner` puts something on or into.
bool carries(const Want& outer, const Want& inner) {
  return is_place(inner) && is_place(outer) && inner.other == outer.thing;
}

/// The piece of the wants that has these, with the things that they speak of.
Wants piece_of(const Wants& whole, std::vector<Want> wants, std::vector<Want> found) {
  Wants piece;
  std::vector<std::size_t> old;
  const auto moved = [&](std::size_t thing) {
    const auto at = std::find(old.begin(), old.end(), thing);
    if (at != old.end()) return static_cast<std::size_t>(at - old.begin());
    old.push_back(thing);
    piece.things.push_back(whole.things[thing]);
    piece.single.push_back(whole.single[thing]);
    piece.things.back().where.clear();
    return old.size() - 1;
  };
  for (auto* list : {&wants, &found}) {
    for (Want& want : *list) {
      want.thing = moved(want.thing);
      if (want.other) want.other = moved(*want.other);
    }
  }
  piece.wants = std::move(wants);
  piece.found = std::move(found);
  return piece;
}

/// The wants of a piece and what its vessels carry, on which the grade of a vessel's place depends.
std::vector<Want> with_carried(std::vector<Want> piece, const Wants& whole) {
  const std::size_t size = piece.size();
  for (std::size_t i = 0; i < size; ++i) {
    for (const Want& inner : whole.wants) {
      if (carries(piece[i], inner) && std::find(piece.begin(), piece.end(), inner) == piece.end())
        piece.push_back(inner);
    }
  }
  return piece;
}

/// True when what is known of the start bears on the want: dirt of a thing of which, or onto which, something is
/// wanted, that a thing which goes somewhere is clean, and the room of a place where something is to go.
bool concerns(const Want& want, const Want& known) {
  if (known.predicate == Predicate::Clean) return is_place(want) && want.thing == known.thing;
  if (known.predicate == Predicate::Dirty) return want.thing == known.thing || want.other == known.thing;
  return known.predicate == Predicate::InRoom && is_place(want) && want.other == known.thing;
}

/// A want about one category, in words and as a role.
struct RoleQuestion {
  Role role;
  std::string words;
};

class GoalGrader {
 public:
  GoalGrader(const Knowledge& knowledge, const CommonSense& sense, const WordKinds& words, Wants wants)
      : knowledge_(knowledge), sense_(sense), words_(words), wants_(std::move(wants)) {}

  TaskSense grade() {
    for (const auto& want : wants_.wants) part(want);
    std::set<std::size_t> wanted;
    for (const auto& want : wants_.wants) wanted.insert(want.thing);
    for (const std::size_t thing : wanted) alone(thing);
    for (const auto& want : wants_.found) found(want);
    for (const auto& known : wants_.found) {
      for (const auto& want : wants_.wants) {
        if (!concerns(want, known)) continue;
        if (known.predicate == Predicate::Dirty) used_dirty(want, known);
        if (known.predicate == Predicate::Clean) washed_clean(want);
        if (known.predicate == Predicate::InRoom) brought_into(want, known);
      }
    }
    for (std::size_t i = 0; i < wants_.wants.size(); ++i) {
      for (std::size_t j = i + 1; j < wants_.wants.size(); ++j) {
        if (!go_together(wants_.wants[i], wants_.wants[j])) continue;
        pair(wants_.wants[i], wants_.wants[j]);
        apart(wants_.wants[i], wants_.wants[j]);
        apart(wants_.wants[j], wants_.wants[i]);
        strangers(wants_.wants[i], wants_.wants[j]);
      }
    }
    one_name();
    TaskSense task;
    if (parts_.empty()) {
      task.grade = wants_.moves_agent ? Grade::Usual : Grade::Tolerable;
      return task;
    }
    std::stable_sort(parts_.begin(), parts_.end(),
                     [](const PartSense& a, const PartSense& b) { return a.sense.grade < b.sense.grade; });
    task.grade = parts_.front().sense.grade;
    task.parts = std::move(parts_);
    return task;
  }

 private:
  std::vector<Thing> things_of(std::size_t variable) const {
    std::vector<Thing> all;
    const Domain& domain = wants_.things[variable];
    for (const auto& member : domain.members) {
      const auto* fact = sense_.kind_of(knowledge_.simulator(), member.category);
      const auto* category = knowledge_.find(member.category);
      Thing thing{fact == nullptr ? "" : fact->kind, category == nullptr ? member.category : category->display, {}};
      if (category != nullptr) thing.materials = category->materials;
      if (member.slice) {
        thing.kind = sense_.kinds().piece_of(thing.kind);
        thing.words = "slice of " + thing.words;
      }
      all.push_back(std::move(thing));
    }
    return all;
  }

  /// The kind of a substance; the substance itself for the liquids that have roles of their own.
  std::string substance(const std::string& symbol) const {
    if (std::find(kLiquids.begin(), kLiquids.end(), symbol) != kLiquids.end()) return symbol;
    return words_.of_word(symbol).value_or("");
  }

  std::optional<RoleQuestion> with_substance(const Want& want, const std::string& thing) const {
    if (want.predicate == Predicate::Filled) {
      if (want.negated) return RoleQuestion{"empty", "empty " + thing};
      const auto kind = substance(want.symbol);
      if (kind.empty()) return std::nullopt;
      return RoleQuestion{"fill:" + kind, "fill " + thing + " with " + want.symbol};
    }
    if (want.symbol == "dust")
      return want.negated ? RoleQuestion{"dust", "dust " + thing} : RoleQuestion{"soil", "spread dust on " + thing};
    const auto kind = words_.of_word(want.symbol);
    if (!kind) return std::nullopt;
    return want.negated ? RoleQuestion{"uncover:" + *kind, "wipe " + want.symbol + " off " + thing}
                        : RoleQuestion{"cover:" + *kind, "spread " + want.symbol + " over " + thing};
  }

  std::optional<RoleQuestion> with_other(const Want& want, const std::string& thing, const Thing& other) const {
    const auto& kinds = sense_.kinds();
    const auto known = [&](Role role, const std::string& between) -> std::optional<RoleQuestion> {
      if (other.kind.empty()) return std::nullopt;
      return RoleQuestion{std::move(role), thing + " " + between + " " + other.words};
    };
    switch (want.predicate) {
      case Predicate::On:
        return known(kinds.place_role("on", other.kind), "on");
      case Predicate::Inside:
        return known(kinds.place_role("in", other.kind), "in");
      case Predicate::NextTo:
        return known("next_to:" + other.kind, "next to");
      case Predicate::Under:
        return known("under:" + other.kind, "under");
      case Predicate::Attached:
        return known("attach:" + other.kind, "attached to");
      case Predicate::OnFloor:
        return RoleQuestion{"on:floor", thing + " on the floor"};
      case Predicate::InRoom:
        return in_room(thing, other);
      default:
        return std::nullopt;
    }
  }

  static RoleQuestion in_room(const std::string& thing, const Thing& room) {
    return {"in_room:" + room.words, thing + " in the " + replace_all(room.words, "_", " ")};
  }

  /// All that a want asks of a thing: several where the other one is one of several categories.
  std::vector<RoleQuestion> asked(const Want& want, const Thing& thing) const {
    std::vector<RoleQuestion> all;
    const auto add = [&](std::optional<RoleQuestion> one) {
      if (one) all.push_back(std::move(*one));
    };
    if (want.predicate == Predicate::Filled || want.predicate == Predicate::Covered) {
      add(with_substance(want, thing.words));
    } else if (want.negated) {
      return all;
    } else if (want.other) {
      for (const auto& other : things_of(*want.other)) {
        add(with_other(want, thing.words, other));
        if (want.predicate == Predicate::OnFloor) add(in_room(thing.words, other));
      }
    } else if (const auto action = action_of(want.predicate); !action.empty()) {
      add(RoleQuestion{std::string(action), replace_all(std::string(action), "_", " ") + " " + thing.words});
    }
    return all;
  }

  void keep(std::string words, Sense sense) { parts_.push_back({std::move(words), std::move(sense)}); }

  void part(const Want& want) {
    for (const auto& thing : things_of(want.thing)) {
      if (thing.kind.empty()) continue;
      for (auto& each : asked(want, thing)) {
        auto sense = sense_.grade(thing, each.role);
        if (auto carried = carried_there(want, each.role); carried && sense.grade == Grade::Tolerable)
          sense = std::move(*carried);
        keep(std::move(each.words), std::move(sense));
      }
      const bool beside = want.predicate == Predicate::NextTo && want.other && !want.negated;
      if (beside) company(want.thing, *want.other);
      if (want.negated && want.other) taken_away(want, thing);
    }
  }

  /// One of what nobody asks for one of: an olive, a shoe. Where other things would do as well, these are only some of
  /// what may be brought.
  void alone(std::size_t variable) {
    if (!wants_.single[variable]) return;
    std::optional<Sense> best;
    std::string words;
    for (const auto& thing : things_of(variable)) {
      Sense sense = sense_.alone(thing);
      if (best && best->grade >= sense.grade) continue;
      best = std::move(sense);
      words = "a single " + thing.words;
    }
    if (best && best->grade != Grade::Usual) keep(std::move(words), std::move(*best));
  }

  /// What the grade of a thing on or in a vessel is where the vessel goes: a plate of potatoes goes into a fridge for
  /// the sake of the potatoes. Nothing when that is not usual, or the vessel carries nothing.
  std::optional<Sense> carried_there(const Want& outer, const Role& role) const {
    std::optional<Sense> worst;
    for (const Want& inner : wants_.wants) {
      if (!carries(outer, inner)) continue;
      for (const auto& thing : things_of(inner.thing)) {
        if (thing.kind.empty()) continue;
        auto sense = sense_.grade(thing, role);
        if (sense.grade != Grade::Usual) return std::nullopt;
        worst = worst ? worse_of(std::move(*worst), std::move(sense)) : std::move(sense);
      }
    }
    return worst;
  }

  /// Taking a thing away from where it is: a surface or a floor is cleared, but what is where it is kept stays there.
  void taken_away(const Want& want, const Thing& thing) {
    if (want.predicate == Predicate::OnFloor)
      return keep("no " + thing.words + " on the floor", {Grade::Usual, 1, {"floors are cleared"}, "cleared"});
    if (want.predicate != Predicate::On && want.predicate != Predicate::Inside) return;
    const std::string relation = want.predicate == Predicate::On ? "on" : "in";
    for (const auto& place : things_of(*want.other)) {
      const auto& kinds = sense_.kinds();
      if (place.kind.empty()) continue;
      const bool kept = relation == "in" && sense_.used_for(place.kind, PlaceUse::Storage) &&
                        sense_.grade(thing, kinds.place_role(relation, place.kind)).grade == Grade::Usual;
      keep("no " + thing.words + " " + relation + " " + place.words,
           kept ? Sense{Grade::Tolerable, 0.3, {"it is where it is kept"}, "cleared"}
                : Sense{Grade::Usual, 1, {"surfaces are cleared"}, "cleared"});
    }
  }

  /// Two things of which one has a name that may mean the other, too: nobody tells "the piece of fruit" from the apple.
  void one_name() {
    std::set<std::size_t> wanted;
    for (const Want& want : wants_.wants) wanted.insert(want.thing);
    for (const auto a : wanted) {
      for (const auto b : wanted) {
        if (a == b || wants_.things[a].members == wants_.things[b].members) continue;
        for (const auto& name : things_of(a)) {
          for (const auto& thing : things_of(b)) {
            if (sense_.may_mean(name, thing))
              keep(name.words + " and " + thing.words,
                   {Grade::Tolerable, 0.3, {"the one name may mean the other thing"}, "one_name"});
          }
        }
      }
    }
  }

  void company(std::size_t a, std::size_t b) {
    for (const auto& first : things_of(a)) {
      for (const auto& second : things_of(b)) {
        for (auto sense : {sense_.together(first, second), spilled(a, second), spilled(b, first)})
          if (sense.grade != Grade::Usual) keep(first.words + " with " + second.words, std::move(sense));
      }
    }
  }

  /// What is filled stands beside a thing as a drink does.
  Sense spilled(std::size_t vessel, const Thing& other) const {
    const bool full = std::any_of(wants_.wants.begin(), wants_.wants.end(), [&](const Want& want) {
      return want.thing == vessel && want.predicate == Predicate::Filled && !want.negated;
    });
    return full ? sense_.together({"drink", "drink", {}}, other) : Sense{Grade::Usual, 1, {}, ""};
  }

  /// Where a thing is found before the task, and what tells it from others.
  void found(const Want& want) {
    if (!want.other || want.predicate == Predicate::InRoom) return;
    const bool near = want.predicate == Predicate::Nearest || want.predicate == Predicate::NextTo;
    const auto* relation = near ? "near" : want.predicate == Predicate::On ? "on" : "in";
    for (const auto& thing : things_of(want.thing)) {
      for (const auto& place : things_of(*want.other)) {
        if (thing.kind.empty() || place.kind.empty()) continue;
        auto sense =
            near ? sense_.near(thing, place) : sense_.found(thing, sense_.kinds().place_role(relation, place.kind));
        if (want.predicate == Predicate::Inside) sense = worse_of(std::move(sense), shut_up_in(thing, place));
        if (sense.grade != Grade::Usual) keep(thing.words + " found " + relation + " " + place.words, std::move(sense));
      }
    }
  }

  /// What lies about may lie anywhere, but nobody shuts a thing up in a place where it makes no sense.
  Sense shut_up_in(const Thing& thing, const Thing& place) const {
    const Sense kept = sense_.grade(thing, sense_.kinds().place_role("in", place.kind));
    if (kept.grade == Grade::Senseless) return {Grade::Tolerable, 0.3, {"nobody keeps it in there"}, kept.why};
    return {Grade::Usual, 1, {}, ""};
  }

  /// A thing that goes to a place in a room comes into that room, and the place is what people have there: a cabinet in
  /// a kitchen is for dishes.
  void brought_into(const Want& want, const Want& known) {
    for (const auto& thing : things_of(want.thing)) {
      for (const auto& room : things_of(*known.other)) {
        if (thing.kind.empty()) continue;
        auto asked = in_room(thing.words, room);
        auto sense = sense_.grade(thing, asked.role);
        if (sense.grade == Grade::Senseless) keep(std::move(asked.words), std::move(sense));
        for (auto place : things_of(known.thing)) {
          place.kind = sense_.place_in_room(place.kind, room.words);
          const auto there = with_other(want, thing.words, place);
          if (!there) continue;
          sense = sense_.grade(thing, there->role);
          if (sense.grade != Grade::Usual) keep(there->words + " in the " + room.words, std::move(sense));
        }
      }
    }
  }

  /// What is dirty is washed, wiped or carried to where that is done; nobody eats from it or puts it away.
  void used_dirty(const Want& want, const Want& dirt) {
    const bool itself = want.other == dirt.thing;  // a dirty counter is no place for anything
    const auto use = itself ? PlaceUse::DirtyOrNot : PlaceUse::DirtyThings;
    const auto for_dirt = [&](const Thing& place) { return sense_.used_for(place.kind, use); };
    const bool uses = want.predicate == Predicate::Filled || want.predicate == Predicate::Hot;
    if (!uses && !is_place(want)) return;
    if (is_place(want)) {
      const auto places = things_of(*want.other);
      if (std::all_of(places.begin(), places.end(), for_dirt)) return;
    }
    for (const auto& thing : things_of(dirt.thing))
      keep("use dirty " + thing.words, {Grade::Tolerable, 0.3, {"nobody is to wash it first"}, "dirty"});
  }

  /// What is told by being clean goes to no hamper and no dishwasher.
  void washed_clean(const Want& want) {
    const auto places = things_of(*want.other);
    const auto washes = [&](const Thing& place) { return sense_.used_for(place.kind, PlaceUse::DirtyOrNot); };
    if (std::none_of(places.begin(), places.end(), washes)) return;
    for (const auto& thing : things_of(want.thing))
      keep("wash clean " + thing.words, {Grade::Tolerable, 0.3, {"it is clean already"}, "dirty"});
  }

  /// Opening or switching on something in a task that puts a thing elsewhere which never goes there.
  void apart(const Want& part, const Want& moved) {
    if (!turns(part) || !is_place(moved) || moved.thing == part.thing || moved.other == part.thing) return;
    for (const auto& machine : things_of(part.thing)) {
      for (const auto& thing : things_of(moved.thing)) {
        const auto& kinds = sense_.kinds();
        const bool stays = kinds.is_a(machine.kind, "place") || kinds.is_a(machine.kind, "fixture");
        if (!stays || thing.kind.empty() || sense_.belongs(thing, machine.kind)) continue;
        keep(std::string(action_of(part.predicate)) + " " + machine.words + ", and " + thing.words + " elsewhere",
             {Grade::Tolerable, 0.3, {"the two have nothing to do with one another"}, "apart"});
      }
    }
  }

  /// Opening or switching on one thing and doing something with another that nobody needs for the same activity.
  void strangers(const Want& a, const Want& b) {
    if ((!turns(a) && !turns(b)) || a.thing == b.thing || a.other == b.thing || b.other == a.thing) return;
    for (const auto& first : things_of(a.thing)) {
      for (const auto& second : things_of(b.thing)) {
        if (!sense_.companions().strangers(first.kind, second.kind)) continue;
        keep(first.words + " and " + second.words,
             {Grade::Tolerable, 0.3, {"people seldom need the two for one activity"}, "apart"});
      }
    }
  }

  /// A thing on or in another that is put somewhere comes along: an apple on a plate goes into the dishwasher with it.
  void along(const Want& inner, const Want& outer) {
    if (!carries(outer, inner)) return;
    for (const auto& thing : things_of(inner.thing)) {
      if (thing.kind.empty()) continue;
      for (auto& there : asked(outer, thing)) {
        auto sense = sense_.grade(thing, there.role);
        if (sense.grade == Grade::Senseless) keep(there.words + ", with what it is on or in", std::move(sense));
      }
    }
  }

  void pair(const Want& a, const Want& b) {
    along(a, b);
    along(b, a);
    if (is_place(a) && is_place(b) && a.thing != b.thing && a.other == b.other) company(a.thing, b.thing);
    if (a.thing != b.thing) return;
    const bool turned = a.other && !b.other;  // in one state, the change comes before the place
    const Want& first = turned ? b : a;
    const Want& second = turned ? a : b;
    if (first.other) return;
    for (const auto& thing : things_of(a.thing)) {
      for (const auto& before : asked(first, thing)) {
        for (const auto& after : asked(second, thing)) {
          auto sense = sense_.grade(thing, before.role + ">" + after.role);
          if (sense.grade == Grade::Senseless) keep(before.words + ", then " + after.words, std::move(sense));
        }
      }
    }
  }

  const Knowledge& knowledge_;
  const CommonSense& sense_;
  const WordKinds& words_;
  Wants wants_;
  std::vector<PartSense> parts_;
};

}  // namespace

std::vector<Wants> pieces_of(const Wants& wants) {
  std::vector<Wants> pieces;
  for (const Want& want : wants.wants) pieces.push_back(piece_of(wants, with_carried({want}, wants), {}));
  for (const Want& found : wants.found) {
    if (found.other && found.predicate != Predicate::InRoom) pieces.push_back(piece_of(wants, {}, {found}));
    for (const Want& want : wants.wants) {
      if (concerns(want, found)) pieces.push_back(piece_of(wants, {want}, {found}));
    }
  }
  for (std::size_t i = 0; i < wants.wants.size(); ++i) {
    for (std::size_t j = i + 1; j < wants.wants.size(); ++j) {
      if (go_together(wants.wants[i], wants.wants[j]))
        pieces.push_back(piece_of(wants, with_carried({wants.wants[i], wants.wants[j]}, wants), {}));
    }
  }
  return pieces;
}

std::optional<Grade> grade_piece(const Wants& piece, const Knowledge& knowledge, const CommonSense& sense,
                                 const WordKinds& words) {
  const TaskSense task = GoalGrader(knowledge, sense, words, piece).grade();
  return task.parts.empty() ? std::nullopt : std::optional(task.grade);
}

TaskSense grade_goal(const Formula& goal, const Knowledge& knowledge, const CommonSense& sense,
                     const WordKinds& words) {
  return GoalGrader(knowledge, sense, words, wants_of(goal)).grade();
}

}  // namespace unietp
