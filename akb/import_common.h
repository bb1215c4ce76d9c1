#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "akb/absurd_place.h"
#include "akb/kind_groups.h"
#include "akb/lexicon.h"
#include "akb/placement_rules.h"
#include "akb/tables.h"
#include "core/result.h"
#include "scene/simulator.h"

namespace unietp {

/// What a simulator's metadata says about one category, before our own words are added.
struct RawCategory {
  std::string name;
  std::string display;  // empty: taken from the name
  bool movable = false;
  std::optional<Vec3> extents;  // full extents, meters: width, depth, height where upstream is sure of them
  std::string extents_source;
  std::optional<double> mass;
  std::string mass_source;
  std::vector<std::string> materials;  // sorted, in place of the word's; empty: the word's
  Source source;
  std::optional<Word> word;  // made from metadata; used in place of the lexicon's
};

/// One simulator's tables while they are being made. The steps are called in the order in which they stand here.
class TableBuilder {
 public:
  TableBuilder(Simulator simulator, std::filesystem::path curated);

  /// Placements that are absurd are dropped, whatever says them.
  void refuse(AbsurdPlace absurd) { absurd_ = std::move(absurd); }

  /// Names that curated/<simulator>/category.csv lists, in its order.
  std::vector<std::string> curated_names() const;
  /// The curated cell of a category, "" when there is none.
  std::string curated(const std::string& name, const std::string& column) const;

  /// Adds a category: metadata first, the word of the same display name for what it lacks, curated cells over both.
  /// Extents must be within a factor 1.4 of the word's along each axis, as they are or else laid along the axes in the
  /// order of the word's own (rule `word-axes`), since upstream boxes are rotated now and then; a mass within 3.
  void add(const RawCategory& raw);

  /// Adds an affordance; of two sources for one, the first stays. Ignored for a category that was not added, and for
  /// `openable` where the archetype has no joint.
  void afford(const std::string& category, std::string_view affordance, const std::string& source, double confidence);
  /// Whether the category has the affordance so far.
  bool has(const std::string& category, std::string_view affordance) const;
  /// Lays curated/<simulator>/affordance.csv over, then adds receptacle and container from the archetype (rule
  /// `archetype`) where nothing says so yet.
  void afford_by_archetype();

  /// A placement seen in metadata; weights of one pair add up.
  void seen(const std::string& object, Predicate relation, const std::string& receptacle, double weight,
            const std::string& source);
  /// Placements of placement_rules.csv (rule `kind`) for every pair that metadata does not name; `scale` says how much
  /// they weigh against metadata. All four relations; `next_to` is of things that can stand on one support.
  void place_by_kind(double scale);
  /// Receptacles that homes usually have: rules prefer them to others, and those least that no home has.
  void prefer(std::set<std::string> receptacles) { preferred_ = std::move(receptacles); }
  /// Kinds that are kept in the same places as another, besides their own rules.
  void kept_like(std::map<std::string, std::string> kinds) { like_ = std::move(kinds); }
  /// At most so many derived placements of one object for a relation are kept: the likeliest, where each further
  /// receptacle of a kind counts less than the one before.
  void keep_best(std::map<Predicate, std::size_t> most) { most_ = std::move(most); }
  /// Object, relation and receptacle of every placement that place_by_kind would add.
  std::set<std::tuple<std::string, Predicate, std::string>> sensible_placements();

  /// A model of a category with its own box, width x, depth y and height z in the model's frame. Every model is kept,
  /// for scenes that have it; `usable` of akb/fit.h says which ones serve in scenes of ours. Ignored when the category
  /// is none or the box is empty or longer than 20 m. Call it after `add`.
  void model(Asset asset);

  /// Adds what a tool does. Ignored when it names a category that was not added, or repeats an effect.
  void effect(Effect effect);
  /// A further name or phrase; curated ones of the same kind come first (see curated/aliases*.csv).
  void alias(Alias alias);
  /// Adds the aliases, then lays curated tables over, drops what does not fit (rule `footprint` gives capacities) and
  /// normalizes likelihoods. Errors: everything wrong in a curated file, the first one reported.
  Result<Tables> finish();
  /// To append to: `finish` reports them.
  std::vector<Error>& errors() { return errors_; }

  /// A category that was added; nullptr when none has the name.
  const Category* find(const std::string& name) const;
  /// What kind of thing the category is (Word::kind); "" when no word says.
  std::string kind(const std::string& name) const;
  bool is_kind(const std::string& name, KindGroup group) const { return groups_.at(group).contains(kind(name)); }
  /// All categories that were added, sorted.
  std::vector<std::string> names() const;

 private:
  template <class Read>
  void with_curated(const std::string& table, const Read& read);
  void overlay_affordances();
  void overlay_curated();
  void drop_removed();
  void place_by_rule(const PlacementRule& rule, const Category& object, const Category& receptacle, double scale);
  void drop_unfit();
  void drop_unfit_placements();
  void drop_all_but_best(bool beside);
  int room_beside(const Placement& p) const;
  void normalize();
  void add_aliases();
  void add_aliases_of(const std::filesystem::path& path);
  void drop_ambiguous_aliases();
  std::filesystem::path folder() const;

  bool is_absurd(const std::string& object, Predicate relation, const std::string& receptacle) const;

  Simulator simulator_;
  std::filesystem::path curated_;
  AbsurdPlace absurd_;
  std::vector<Error> errors_;
  Lexicon lexicon_;
  KindGroups groups_;
  std::vector<std::string> curated_names_;
  std::map<std::string, std::map<std::string, std::string>> cells_;  // curated category cells, by name and column
  std::map<std::string, Category> categories_;
  std::map<std::string, std::string> kinds_;
  std::map<std::pair<std::string, std::string>, AffordanceFact> affordances_;
  // By the keys of the tables, in their order; the second part is the name of an enum's value.
  std::map<std::tuple<std::string, std::string_view, std::string>, Placement> placements_;
  std::map<std::tuple<std::string, std::string_view, std::string, std::string>, Effect> effects_;
  std::map<std::tuple<std::string, std::string_view, std::string>, Alias> aliases_;
  std::set<std::string> preferred_;
  std::map<std::string, std::string> like_;
  std::map<Predicate, std::size_t> most_;  // relation -> placements of an object
  std::map<std::string, Asset> assets_;    // by name
};

/// "CoffeeMachine" -> "coffee machine", "coffee_table" -> "coffee table".
std::string words_of(std::string_view name);
/// The middle of the values, or of each coordinate; the lower of the two middles for an even count.
double median(std::vector<double> values);
Vec3 median(const std::vector<Vec3>& values);
/// The box that is nearest to the median of all along each axis: one that a model really has.
Vec3 middle_box(const std::vector<Vec3>& boxes);

}  // namespace unietp
