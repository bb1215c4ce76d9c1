#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "akb/name_table.h"
#include "akb/row_index.h"
#include "akb/rows.h"
#include "core/result.h"
#include "scene/simulator.h"

namespace unietp {

/// One simulator's affordance knowledge base, in memory. Immutable after loading; queries are in table order, which is
/// sorted by name, so results are deterministic.
class Knowledge {
 public:
  Knowledge(Simulator simulator, std::vector<Category> categories, std::vector<AffordanceFact> affordances,
            std::vector<Placement> placements, std::vector<Effect> effects, std::vector<Alias> aliases,
            std::vector<Asset> assets = {});

  Simulator simulator() const { return simulator_; }  // whose categories these are
  const std::vector<Category>& categories() const { return categories_; }
  /// nullptr for an unknown name. In all queries below, an unknown name gives nothing: nullptr, false or an empty list.
  /// Pointers are valid as long as this value.
  const Category* find(std::string_view name) const;
  bool has(std::string_view category, std::string_view affordance) const;
  /// Names of categories, sorted.
  std::vector<std::string> with_affordance(std::string_view affordance) const;
  std::vector<std::string> affordances_of(std::string_view category) const;
  std::vector<const AffordanceFact*> affordance_facts_of(std::string_view category) const;

  const std::vector<Placement>& placements() const { return placements_; }  // by object, relation and receptacle
  /// Whether and how often an object of one category is on, inside, next to or under one of another.
  const Placement* placement(std::string_view object, Predicate relation, std::string_view receptacle) const;
  std::vector<const Placement*> placements_of(std::string_view object, Predicate relation) const;
  std::vector<const Placement*> placements_at(std::string_view receptacle, Predicate relation) const;

  const std::vector<Effect>& effects() const { return effects_; }  // by tool, effect and target
  /// What the tool does to the target, if it does that at all.
  const Effect* effect(std::string_view tool, Treatment treatment, std::string_view target) const;
  std::vector<const Effect*> effects_on(std::string_view target, Treatment treatment) const;
  std::vector<const Effect*> effects_of(std::string_view tool, Treatment treatment) const;

  /// The names or phrases of one kind.
  std::vector<const Alias*> aliases_of(std::string_view category, AliasKind kind) const;
  /// Models of a category whose boxes a scene may use (`usable` of akb/fit.h), by name; empty when none is known.
  std::vector<const Asset*> assets_of(std::string_view category) const;
  /// All models of a category, also those whose boxes are too far from it.
  std::vector<const Asset*> asset_rows_of(std::string_view category) const;
  /// Any model, also one of an odd size; nullptr when none has that name.
  const Asset* asset(std::string_view name) const;
  const std::vector<Asset>& assets() const { return assets_; }

  const std::vector<AffordanceFact>& affordances() const { return affordances_; }  // by category
  const std::vector<Alias>& aliases() const { return aliases_; }                   // by category

 private:
  Simulator simulator_;
  std::vector<Category> categories_;
  std::vector<AffordanceFact> affordances_;
  std::vector<Placement> placements_;
  std::vector<Effect> effects_;
  std::vector<Alias> aliases_;
  std::vector<Asset> assets_;  // by category, name

  // Numbers instead of names, so that a query compares no texts but those that it was asked with.
  NameTable names_;                       // of categories, and of what rows name without a category
  NameTable words_;                       // affordances
  RowIndex category_of_;                  // name
  RowIndex by_category_, by_affordance_;  // category, affordance; affordance, category
  RowIndex by_object_, by_receptacle_;    // object, relation, receptacle; receptacle, relation, object
  RowIndex by_tool_, by_target_;          // tool, effect, target; target, effect, tool
  RowIndex by_alias_, assets_of_;         // category, kind; category
  NameSlots asset_named_;
};

/// Compiles `<tables>/<simulator>/{category,affordance,relation,effect,alias,asset}.csv` of all four simulators into
/// one SQLite file (written aside, then renamed) that carries the digest of its inputs. `<tables>/override.csv`, where
/// there is one, wins over the tables, and each of `overrides` over what stands before it. Errors: Schema with file,
/// line and column: an unknown or missing column, a bad number, an unknown category, affordance, archetype or relation,
/// a duplicate key, a missing or malformed source. All of them, not only the first.
std::vector<Error> compile_knowledge(const std::filesystem::path& tables, const std::filesystem::path& database,
                                     const std::vector<std::filesystem::path>& overrides = {});

/// SHA-256 over the names and bytes of all tables and overrides, in order.
Result<std::string> digest_of_tables(const std::filesystem::path& tables,
                                     const std::vector<std::filesystem::path>& overrides = {});
/// Digest stored in a compiled file, or an error when it is none.
Result<std::string> digest_of_database(const std::filesystem::path& database);

/// Reads one simulator from a compiled file. Errors: Io, Schema.
Result<Knowledge> load_knowledge(const std::filesystem::path& database, Simulator simulator);

}  // namespace unietp
