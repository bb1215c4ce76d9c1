#include "grounding/enforce.h"

#include <algorithm>
#include <span>
#include <utility>

#include "generator/fixed_start.h"
#include "grounding/likelihood.h"
#include "grounding/numbers.h"

namespace unietp {
namespace {

using Op = Formula::Op;

constexpr int kDeepest = 12;
constexpr int kMostAdded = 40;
constexpr double kStays = 0.7;  // what goes off a place stays in such a room, mostly the one where such things are kept
constexpr double kFar_m = 2.5;  // what is not to be nearest goes at least so far away

bool is_empty(const Formula& body) { return body.op == Op::And && body.children.empty(); }

}  // namespace

Enforcer::Enforcer(SceneEditor& editor, Compared compared, Rng rng)
    : editor_(editor), compared_(std::move(compared)), rng_(rng) {}

const Trace& Enforcer::now() {
  editor_.refresh();
  const Workspace& workspace = editor_.workspace();
  const Trace& plain = workspace.current_state().now();
  if (compared_.none()) return plain;
  if (read_ != workspace.reading()) {
    trace_.entities.follow(plain.entities);
    trace_.states = {
        with_comparisons(plain.states.front(), workspace.scene(), workspace.current_state().reader(), compared_)};
  }
  read_ = workspace.reading();
  return trace_;
}

bool Enforcer::holds(const Formula& formula) { return holds(formula, {}); }

Assignment Enforcer::assignment(const Trace& trace, const Names& names) const {
  Assignment assignment;
  for (const auto& [variable, id] : names) {
    const auto entity = editor_.workspace().current_state().reader().find(id);
    if (entity && trace.states.front().exists(*entity)) assignment.emplace_back(variable, *entity);
  }
  return assignment;
}

bool Enforcer::holds(const Formula& formula, const Names& names) {
  const Trace& trace = now();
  const Assignment known = assignment(trace, names);
  // A variable whose object has been taken out since makes whatever is said of it false.
  return known.size() == names.size() && holds_in(formula, trace, 0, known);
}

std::vector<std::string> Enforcer::ids_of(const std::vector<EntityIndex>& entities, const Trace& trace) const {
  std::vector<std::string> ids;
  for (const EntityIndex entity : entities) ids.push_back(trace.entities[entity].id);
  if (compared_.none() || ids.size() < 2) return ids;
  const auto place_of = [&](const std::string& id) { return editor_.workspace().places().find(id); };
  if (!std::all_of(ids.begin(), ids.end(), place_of)) return ids;  // rooms keep their order
  std::sort(ids.begin(), ids.end(), [&](const auto& a, const auto& b) { return *place_of(a) < *place_of(b); });
  return ids;
}

std::vector<std::string> Enforcer::members(const Formula& quantifier, const Names& names) {
  const Trace& trace = now();
  const Assignment known = assignment(trace, names);
  // Nothing is in a domain that speaks of what has been taken out.
  if (known.size() != names.size() && !quantifier.domain.where.empty()) return {};
  return ids_of(members_of(quantifier.domain, quantifier.variable, trace, known), trace);
}

std::vector<std::string> Enforcer::satisfying(const Formula& quantifier, const Names& names, bool truth) {
  const Trace& trace = now();
  const Assignment known = assignment(trace, names);
  if (known.size() != names.size()) return truth ? std::vector<std::string>() : members(quantifier, names);
  // One reading for all members: the body is asked as a part of their domain.
  Domain domain = quantifier.domain;
  Formula body = quantifier.children.front();
  if (!truth) body = negation(std::move(body));
  if (!domain.where.empty()) body = conjunction({std::move(domain.where.front()), std::move(body)});
  domain.where = {std::move(body)};
  return ids_of(members_of(domain, quantifier.variable, trace, known), trace);
}

bool Enforcer::make_true(const Formula& formula) {
  if (!make(formula, {}, true, 0)) return false;
  const bool witnesses = formula.op == Op::Exists || formula.op == Op::Count;
  if (!witnesses) return true;
  const int wanted = formula.op == Op::Exists ? 1 : count_range(formula.comparison, formula.number, true).first;
  auto serving = satisfying(formula, {}, true);
  rng_.shuffle(serving);
  // Those that already serve another constraint come last.
  std::stable_partition(serving.begin(), serving.end(),
                        [&](const std::string& id) { return !editor_.reserved().contains(id); });
  for (int i = 0; i < wanted && i < static_cast<int>(serving.size()); ++i) {
    editor_.reserved().insert(serving[static_cast<std::size_t>(i)]);
  }
  return true;
}

bool Enforcer::make_false(const Formula& formula) { return make(formula, {}, false, 0); }

bool Enforcer::make(const Formula& formula, const Names& names, bool truth, int depth) {
  if (holds(formula, names) == truth) return true;
  if (depth > kDeepest) return editor_.fail(RejectionReason::CannotEnforce, to_text(formula) + " is nested too deep");
  bool made = false;
  switch (formula.op) {
    case Op::Atom:
      made = make_atom(formula, names, truth);
      break;
    case Op::Not:
      made = make(formula.children.front(), names, !truth, depth + 1);
      break;
    case Op::And:
      made = truth ? make_all(formula.children, names, true, depth) : make_any(formula.children, names, false, depth);
      break;
    case Op::Or:
      made = truth ? make_any(formula.children, names, true, depth) : make_all(formula.children, names, false, depth);
      break;
    case Op::Imply:
      made = truth ? make(formula.children[1], names, true, depth + 1)
                   : make(formula.children[0], names, true, depth + 1) &&
                         make(formula.children[1], names, false, depth + 1);
      break;
    case Op::Forall:
      made = truth ? make_for_all(formula, names, true, depth) : make_for_some(formula, names, false, depth);
      break;
    case Op::Exists:
      made = truth ? make_for_some(formula, names, true, depth) : make_for_all(formula, names, false, depth);
      break;
    case Op::Count: {
      const auto [low, high] = count_range(formula.comparison, formula.number, truth);
      made = make_number(formula, names, low, high, depth);
      break;
    }
    case Op::AtEnd:
    case Op::Sometime:
      made = make(formula.children.front(), names, truth, depth + 1);
      break;
    default:
      return editor_.fail(RejectionReason::CannotEnforce,
                          "no edit of a scene makes " + to_text(formula) + (truth ? " true" : " false"));
  }
  if (!made) return false;
  if (holds(formula, names) == truth) return true;
  return editor_.fail(RejectionReason::StartNotMet, to_text(formula) + " is still " + (truth ? "false" : "true"));
}

bool Enforcer::make_all(const std::vector<Formula>& parts, const Names& names, bool truth, int depth) {
  return std::all_of(parts.begin(), parts.end(),
                     [&](const Formula& part) { return make(part, names, truth, depth + 1); });
}

bool Enforcer::make_any(const std::vector<Formula>& parts, const Names& names, bool truth, int depth) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const Formula& part) { return make(part, names, truth, depth + 1); });
}

bool Enforcer::make_for_all(const Formula& formula, const Names& names, bool truth, int depth) {
  const Formula& body = formula.children.front();
  const bool negated = body.op == Op::Not;
  const Formula& atom = negated ? body.children.front() : body;
  if (atom.op == Op::Atom) {
    // All at once, and read anew when all are done.
    for (const std::string& id : satisfying(formula, names, !truth)) {
      Names inner = names;
      inner.emplace_back(formula.variable, id);
      make_atom(atom, inner, truth != negated);
    }
  }
  for (const std::string& id : satisfying(formula, names, !truth)) {
    Names inner = names;
    inner.emplace_back(formula.variable, id);
    if (make(formula.children.front(), inner, truth, depth + 1)) continue;
    // What cannot be changed may still be taken away, as long as others are left.
    if (members(formula, names).size() < 2 || !editor_.remove(id)) return false;
  }
  return true;
}

bool Enforcer::has_member_to_change(const Formula& formula, const Names& names, bool truth, int depth) {
  auto candidates = satisfying(formula, names, !truth);
  // Only what a constraint itself speaks of is left unchanged; a table may hold what several constraints put on it.
  // Its size is a thing's own: changing that undoes nothing else that was asked of it.
  const Formula& body = formula.children.front();
  const bool of_size = body.op == Op::Atom && body.predicate == Predicate::Size;
  if (depth == 0 && !of_size)
    std::erase_if(candidates, [&](const std::string& id) { return editor_.reserved().contains(id); });
  rng_.shuffle(candidates);
  if (candidates.size() > 1) order_by_ease(candidates, formula, names, truth);
  constexpr std::size_t kMostTried = 4;
  for (std::size_t i = 0; i < std::min(candidates.size(), kMostTried); ++i) {
    Names inner = names;
    inner.emplace_back(formula.variable, candidates[i]);
    if (make(formula.children.front(), inner, truth, depth + 1)) return true;
  }
  return false;
}

void Enforcer::order_by_ease(std::vector<std::string>& candidates, const Formula& formula, const Names& names,
                             bool truth) {
  std::vector<double> eases;
  for (const std::string& id : candidates) {
    Names inner = names;
    inner.emplace_back(formula.variable, id);
    eases.push_back(ease_of(formula.children.front(), inner, truth));
  }
  for (std::size_t i = 0; i + 1 < candidates.size(); ++i) {
    const std::size_t drawn = i + rng_.weighted(std::span(eases).subspan(i));
    std::swap(candidates[i], candidates[drawn]);
    std::swap(eases[i], eases[drawn]);
  }
}

double Enforcer::ease_of(const Formula& formula, const Names& names, bool truth) {
  constexpr double kChange = 0.05;  // of a start that leaves the home as it is
  if (holds(formula, names) == truth) return 1;
  if (formula.op == Op::Not) return ease_of(formula.children.front(), names, !truth);
  if (formula.op == Op::And && truth) {
    double ease = 1;
    for (const Formula& part : formula.children) ease *= ease_of(part, names, true);
    return ease;
  }
  if (formula.op != Op::Atom || !truth) return kChange;
  const Workspace& workspace = editor_.workspace();
  const auto place_of = [&](const Term& term) { return workspace.places().find(id_of(term, names)); };
  const auto subject = place_of(formula.terms.front());
  if (!subject || !workspace.scene().nodes[*subject].movable) return kChange;
  const Node& node = workspace.scene().nodes[*subject];
  if (formula.terms.size() == 2 && formula.terms[1].kind != Term::Kind::Symbol) {
    const auto other = place_of(formula.terms[1]);
    const bool hosts = formula.predicate == Predicate::On || formula.predicate == Predicate::Inside;
    return other && hosts ? kChange * likelihood_of_place(workspace, node, formula.predicate, *other) : kChange;
  }
  const std::string symbol = formula.terms.size() == 2 ? formula.terms[1].name : "";
  return kChange * share_in_state(workspace, node, {formula.predicate, symbol});
}

bool Enforcer::make_for_some(const Formula& formula, const Names& names, bool truth, int depth) {
  if (has_member_to_change(formula, names, truth, depth)) return true;
  const bool had_some = !members(formula, names).empty();
  const GroundingFailure why = editor_.failure();
  if (add_member(formula, names, truth, depth)) return true;
  // Why those that are there would not do says more than that no other could be had.
  if (had_some && !why.detail.empty()) editor_.fail(why.reason, why.detail);
  return false;
}

bool Enforcer::make_number(const Formula& formula, const Names& names, int at_least, int at_most, int depth) {
  const Formula& body = formula.children.front();
  // To make room for one, another may have to go: where there is room for fewer than asked, that never ends.
  const int most_tries = 2 * at_least + 8;
  for (int tries = 0; static_cast<int>(satisfying(formula, names, true).size()) < at_least; ++tries) {
    if (tries == most_tries)
      return editor_.fail(RejectionReason::NoFreePlace, to_text(formula) + " has no room for so many");
    if (!make_for_some(formula, names, true, depth)) return false;
  }
  for (std::size_t before = 0;;) {
    auto extra = satisfying(formula, names, true);
    std::size_t left = extra.size();
    if (left <= static_cast<std::size_t>(at_most)) return true;
    if (before > 0 && left >= before) return false;
    before = left;
    rng_.shuffle(extra);  // which of them stays is not to be told from its id
    std::stable_partition(extra.begin(), extra.end(),
                          [&](const std::string& id) { return editor_.reserved().contains(id); });
    for (; !extra.empty() && left > static_cast<std::size_t>(at_most); extra.pop_back()) {
      Names inner = names;
      inner.emplace_back(formula.variable, extra.back());
      if ((!is_empty(body) && make(body, inner, false, depth + 1)) || editor_.remove(extra.back())) --left;
    }
  }
}

bool Enforcer::add_member(const Formula& formula, const Names& names, bool truth, int depth) {
  std::vector<std::string> categories;
  for (const auto& member : formula.domain.members) {
    if (!member.slice) categories.push_back(member.category);
  }
  if (formula.domain.kind != Domain::Kind::Categories || categories.empty()) {
    return editor_.fail(RejectionReason::CannotEnforce,
                        "nothing can be added to the domain " + to_text(formula.domain));
  }
  const std::string& category = rng_.pick(categories);
  const auto accept = [&](const std::string& id) {
    Names inner = names;
    inner.emplace_back(formula.variable, id);
    return make(formula.children.front(), inner, truth, depth + 1);
  };
  const Category* known = editor_.workspace().knowledge().find(category);
  if (known == nullptr)
    return editor_.fail(lack_of(category, editor_.workspace().knowledge()), "the home has no " + category);
  if (++added_ > kMostAdded) {
    return editor_.fail(RejectionReason::StartNotMet,
                        "more than " + std::to_string(kMostAdded) + " objects would be added");
  }
  if (known->movable) {
    const auto id = editor_.add_object(category);
    if (!id) return false;
    if (accept(*id)) return true;
    const GroundingFailure why = editor_.failure();
    editor_.remove(*id);
    return editor_.fail(why.reason, why.detail);
  }
  // A home gets what it lacks altogether, where such a thing usually stands, but no second fridge.
  if (!editor_.workspace().places().of(category).empty())
    return editor_.fail(RejectionReason::LacksFurniture, "the home has no other " + category);
  for (const std::size_t room : rooms_for(*known)) {
    const auto id = editor_.add_furniture(category, room);
    if (!id) continue;
    // The walk through the whole home is looked at last: mostly it is something else that is wrong.
    if (accept(*id) && editor_.leaves_rooms_open()) return true;
    editor_.remove(*id);
  }
  return editor_.fail(RejectionReason::LacksFurniture, "the home lacks a " + category + " and has no place for one");
}

std::vector<std::size_t> Enforcer::rooms_for(const Category& category) {
  constexpr std::size_t kMost = 4;
  const auto& rooms = editor_.workspace().scene().rooms;
  std::vector<std::size_t> usual;
  for (std::size_t room = 0; room < rooms.size(); ++room) {
    const auto& types = category.rooms;
    if (std::find(types.begin(), types.end(), rooms[room].type) != types.end()) usual.push_back(room);
  }
  rng_.shuffle(usual);
  if (usual.size() > kMost) usual.resize(kMost);
  return usual;
}

std::string Enforcer::id_of(const Term& term, const Names& names) const {
  if (term.kind == Term::Kind::Agent) return "agent";
  const auto bound =
      std::find_if(names.rbegin(), names.rend(), [&](const auto& one) { return one.first == term.name; });
  return bound == names.rend() ? "" : bound->second;
}

bool Enforcer::move_off(const std::string& id, const std::string& category) {
  const Workspace& workspace = editor_.workspace();
  const auto type_around = [&](const std::string& thing) -> std::string {
    const auto place = workspace.places().find(thing);
    const Room* room = place ? workspace.room_of(*place) : nullptr;
    return room == nullptr ? "" : room->type;
  };
  const std::string type = type_around(id);
  if (!type.empty() && rng_.chance(kStays)) {
    if (editor_.relocate(
            id, [&](const Node& there) { return there.category != category && type_around(there.id) == type; }))
      return true;
  }
  return editor_.relocate(id, [&](const Node& there) { return there.category != category; });
}

bool Enforcer::make_atom(const Formula& formula, const Names& names, bool truth) {
  using enum Predicate;
  const std::string subject = id_of(formula.terms.front(), names);
  const Predicate predicate = formula.predicate;
  const bool relation = formula.terms.size() == 2 && formula.terms[1].kind != Term::Kind::Symbol;
  if (!relation) {
    const std::string symbol = formula.terms.size() == 2 ? formula.terms[1].name : "";
    return editor_.set_state(subject, predicate, symbol, truth);
  }
  const std::string other = id_of(formula.terms[1], names);
  if (subject == "agent" && predicate == InRoom) return editor_.move_agent(other, truth);
  const Scene& scene = editor_.workspace().scene();
  const auto node_of = [&](const std::string& id) {
    const auto place = editor_.workspace().places().find(id);
    return place ? &scene.nodes[*place] : nullptr;
  };
  const Node* host = node_of(other);
  const Room* room = find_room(scene, other);
  if (truth) {
    if (predicate == Nearest && host != nullptr) return editor_.bring_near(subject, other);
    const Node* moved = node_of(subject);
    if (predicate == NextTo && host != nullptr && moved != nullptr && !moved->movable && host->movable) {
      return editor_.put(other, NextTo, subject);
    }
    if ((predicate == On || predicate == Inside || predicate == NextTo || predicate == Under) && host != nullptr) {
      return editor_.put(subject, predicate, other);
    }
    if (predicate == OnFloor && room != nullptr) return editor_.put_on_floor(subject, other);
    if (predicate == InRoom && room != nullptr) {
      const auto polygon = room->polygon;
      return editor_.relocate(subject,
                              [&](const Node& there) { return contains(polygon, there.pose.position.head<2>()); });
    }
  } else if (predicate == On || predicate == Inside) {
    return move_off(subject, host == nullptr ? "" : host->category);
  } else if (predicate == InRoom && room != nullptr) {
    const std::string type = room->type;
    return editor_.relocate(subject, [&](const Node& there) {
      const Room* around = editor_.workspace().room_of(*editor_.workspace().places().find(there.id));
      return around != nullptr && around->type != type;
    });
  } else if (predicate == Nearest && host != nullptr) {
    const Vec3 from = host->pose.position;
    return editor_.relocate(subject, [&](const Node& there) { return (there.pose.position - from).norm() > kFar_m; });
  } else if (predicate == NextTo && host != nullptr && host->movable && node_of(subject) != nullptr &&
             !node_of(subject)->movable) {
    return editor_.relocate(other, [&](const Node& there) { return there.id != subject; });
  } else if (predicate == OnFloor || predicate == NextTo || predicate == Under) {
    return editor_.relocate(subject, [&](const Node& there) { return there.id != other; });
  }
  return editor_.fail(RejectionReason::CannotEnforce,
                      "no edit of a scene makes " + to_text(formula) + (truth ? " true" : " false"));
}

}  // namespace unietp
