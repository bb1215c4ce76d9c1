#pragma once

#include <string>
#include <utility>
#include <vector>

#include "grounding/scene_editor.h"
#include "logic/evaluate.h"
#include "logic/formula.h"
#include "logic/trace.h"
#include "scene/comparisons.h"

namespace unietp {

/// Makes state formulas true of a scene, one after the other, by edits: what already holds is left unchanged; otherwise
/// the formula is taken apart (a count lacks objects: change some or add one; has too many: change or remove one; a
/// relation is missing: move the object there) down to single edits. Objects that serve one constraint as its witnesses
/// are reserved, so that the next does not undo them but takes or adds others.
class Enforcer {
 public:
  /// `compared`: all that the formulas compare which it will be asked for.
  Enforcer(SceneEditor& editor, Compared compared, Rng rng);

  /// Tries to make a closed state formula true; false when it is not afterwards (SceneEditor::failure says why).
  bool make_true(const Formula& formula);
  /// The same for a formula that must not hold.
  bool make_false(const Formula& formula);
  /// Truth of a closed state formula in the scene as it is.
  bool holds(const Formula& formula);
  /// The present state as a trace of length one.
  const Trace& now();

 private:
  using Names = std::vector<std::pair<std::string, std::string>>;  // variable, id

  bool make(const Formula& formula, const Names& names, bool truth, int depth);
  bool make_all(const std::vector<Formula>& parts, const Names& names, bool truth, int depth);
  bool make_any(const std::vector<Formula>& parts, const Names& names, bool truth, int depth);
  bool make_for_all(const Formula& formula, const Names& names, bool truth, int depth);
  bool make_for_some(const Formula& formula, const Names& names, bool truth, int depth);
  bool make_number(const Formula& formula, const Names& names, int at_least, int at_most, int depth);
  /// Puts a thing elsewhere than on or in receptacles of a category.
  bool move_off(const std::string& id, const std::string& category);
  bool make_atom(const Formula& formula, const Names& names, bool truth);
  bool add_member(const Formula& formula, const Names& names, bool truth, int depth);
  /// A few rooms of a type in which such furniture usually stands, in random order.
  std::vector<std::size_t> rooms_for(const Category& category);
  bool has_member_to_change(const Formula& formula, const Names& names, bool truth, int depth);

  /// Puts the candidates into a random order, the likelier the start in which the body would be as wanted of one, the
  /// earlier.
  void order_by_ease(std::vector<std::string>& candidates, const Formula& formula, const Names& names, bool truth);
  /// How likely a start would be that makes a formula true, or false: 1 where it is already, else less for each change,
  /// by how likely a thing is at such a place and in such a state.
  double ease_of(const Formula& formula, const Names& names, bool truth);

  bool holds(const Formula& formula, const Names& names);
  /// The names of things that exist, as the trace numbers them.
  Assignment assignment(const Trace& trace, const Names& names) const;
  /// In the order of the home's list; where things are compared, in that of the scene, which changes when one goes.
  std::vector<std::string> ids_of(const std::vector<EntityIndex>& entities, const Trace& trace) const;
  std::vector<std::string> members(const Formula& quantifier, const Names& names);
  std::vector<std::string> satisfying(const Formula& quantifier, const Names& names, bool truth);
  std::string id_of(const Term& term, const Names& names) const;

  SceneEditor& editor_;
  Compared compared_;
  Rng rng_;
  Trace trace_;  // with comparisons
  int read_ = -1;
  int added_ = 0;
};

}  // namespace unietp
