#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sense/category_kinds.h"
#include "sense/companions.h"
#include "sense/evidence.h"
#include "sense/generic_words.h"
#include "sense/kinds.h"
#include "sense/place_uses.h"
#include "sense/special_places.h"
#include "sense/word_kinds.h"

namespace unietp {

/// An answer with what it rests on, each a sentence for people.
struct Sense {
  Grade grade = Grade::Tolerable;
  double score = 0;  // what the grade was read from: at least 0.5 usual, below 0.12 senseless
  std::vector<std::string> reasons;
  std::string why = {};  // the same in a word: one of kWhys, or "rule:" and the rule's name
};
/// Of a grade that rests on nothing.
inline constexpr std::string_view kUnspoken = "unspoken";
/// What a grade rests on: a person's judgment of the kind or a wider one, what people wrote of it, that two things have
/// a place in common, that two wants have nothing to do with one another, that a thing is dirty, that something is
/// taken away from where it is, that the names of two things may mean the same one, or nothing.
inline constexpr std::array<std::string_view, 8> kWhys{"judged", "written", "shared",   "apart",
                                                       "dirty",  "cleared", "one_name", kUnspoken};
/// The worse of two; the reasons of both when they are equal.
Sense worse_of(Sense a, Sense b);

/// A thing that is asked about: its kind, and what else rules look at.
struct Thing {
  std::string kind;
  std::string words;                   // for reasons: "mug"
  std::vector<std::string> materials;  // that it comes in
};

/// What people do with household things: judgments of kinds, corrected by what people wrote. Read only after loading.
///
/// The score of a kind in a role starts from the judgment (usual 1, tolerable 0.3, senseless 0.02), or, when nobody
/// judged it, from the score of the wider kind (0.05 at the root). It is moved toward the share that the role has in
/// all that people wrote of the kind in roles of the same family, where a share of 8 % counts as usual:
/// score = (n * e + 20 * start) / (n + 20), where n is what was written in all, at most 15, and e is share / 0.08, at
/// most 0.9 for places and 0.75 for what is done. Of a rise from below 0.12, 0.6 are kept, and 0.5 against a judgment.
/// That a role was not written of a kind counts only against a judgment of that very kind, and only when the sources
/// speak of that role at all. What a person judged tolerable of the kind, or of the nearest wider one that was judged,
/// is never usual: that people wrote of a thing somewhere does not make it the place where one expects it. A place of a
/// wide kind, such as a cabinet in any room, is as good for a thing as the best of its narrower kinds. docs/sense.md
/// says where the numbers come from.
class CommonSense {
 public:
  CommonSense(Kinds kinds, CategoryKinds categories, Judgments judgments, std::vector<SenseRule> rules,
              const std::vector<Evidence>& evidence, SpecialPlaces special = {}, Companions companions = {},
              PlaceUses uses = {}, GenericWords generic = {});

  const Kinds& kinds() const { return kinds_; }  // those that the tables speak of
  /// Shelves and the like that are for some kinds only, and what goes along with what: as in their tables.
  const SpecialPlaces& special_places() const { return special_; }
  const Companions& companions() const { return companions_; }
  const PlaceUses& place_uses() const { return uses_; }
  /// True for a kind of place that has this use.
  bool used_for(std::string_view place, PlaceUse use) const { return uses_.has(place, use, kinds_); }
  /// nullptr for a category that has none.
  const KindFact* kind_of(Simulator simulator, const std::string& category) const;

  /// Grades one role of a thing.
  Sense grade(const Thing& thing, const Role& role) const;
  /// The rules on where a thing may be found before a task: roles such as `found:in:trash_can`. Usual when none speaks.
  Sense found(const Thing& thing, const Role& place) const;
  /// The rules on things of which nobody asks for a single one (the role `single`). Usual when none speaks.
  Sense alone(const Thing& thing) const;
  /// Whether people would tell a thing by what it is near: usual where both are usual in one type of room.
  Sense near(const Thing& thing, const Thing& landmark) const;
  /// True when the thing is at home on or in a place or machine, so that opening this one may be for its sake.
  bool belongs(const Thing& thing, const std::string& place) const;
  /// The narrower kind that a place of this kind is in such a room: a cabinet in a kitchen is a kitchen cabinet. ""
  /// when none of the narrower ones is usual there.
  std::string place_in_room(std::string_view place, std::string_view room) const;
  /// Whether the name of one may mean the other, too: "the piece of fruit or the apple".
  bool may_mean(const Thing& name, const Thing& thing) const;
  /// True when some rule looks at this material, or speaks of things of this name, or the name is a generic word.
  bool has_rule_on(std::string_view material) const;
  bool has_rule_on_name(std::string_view words) const;
  /// The kinds that a rule keeps apart, in the order of the rules: nothing of the first is at one place with something
  /// of the second.
  std::vector<std::pair<std::string, std::string>> kept_apart() const;
  /// The rules on what is in one closed place, by their numbers: those that speak of the thing as the one or as the
  /// other of two. Nobody keeps two things in one cabinet that a rule speaks of as one and as the other.
  struct StoredApart {
    std::vector<std::size_t> one, other;
  };
  StoredApart stored_apart(const Thing& thing) const;
  /// The rules on two things at one place, or next to one another.
  Sense together(const Thing& a, const Thing& b) const;

 private:
  struct Count {
    double weight = 0;
    std::size_t best = 0;  // in evidence_: the row of most weight
  };
  double score(const std::string& kind, const Role& role) const;
  Role best_place(const std::string& kind, const Role& role) const;
  double moved(const std::string& kind, const Role& role, double start, const Grade* judged) const;
  bool is_judged_tolerable(const std::string& kind, const Role& role) const;
  Sense graded(const Thing& thing, const Role& role) const;
  Sense beside(const Thing& thing, const Role& role, const std::string& other) const;
  std::vector<std::string> reasons_for(const Thing& thing, const Role& role) const;
  std::string_view why(const Thing& thing, const Role& role) const;
  bool meets(const SenseRule& rule, const Thing& thing) const;
  const SenseRule* broken(const Thing& thing, const Role& role) const;
  Role known_role(const Thing& thing, const Role& role) const;

  Kinds kinds_;
  CategoryKinds categories_;
  Judgments judgments_;
  std::vector<SenseRule> rules_;
  std::vector<Evidence> evidence_;
  SpecialPlaces special_;
  Companions companions_;
  PlaceUses uses_;
  GenericWords generic_;
  std::set<Role> in_rooms_;                                       // all roles of being in a room that are judged
  std::map<std::pair<std::string, Role>, Count> counts_;          // of a kind and all narrower ones
  std::map<std::pair<std::string, std::string>, double> totals_;  // of a kind and a family
};

/// Reads data/sense/: kinds, categories, judged, counts, rules, special places, companions, uses of places, generic
/// words. Errors are appended.
CommonSense read_common_sense(const std::filesystem::path& folder, std::vector<Error>& errors);

}  // namespace unietp
