#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "akb/tables.h"
#include "scene/simulator.h"

namespace unietp {

/// What a language model may be asked about a category.
enum class FactKind : std::uint8_t { Size, Mass, Synset, Aliases, Function, Context, Placements, Affordances };
/// In the order of the enum, which is that of the requests.
std::span<const FactKind> all_fact_kinds();
std::string_view name_of(FactKind kind);  // "size"
std::optional<FactKind> fact_kind_named(std::string_view name);
/// Aliases for a synonym, else Function or Context.
FactKind kind_of(const Alias& alias);

/// Facts that language models completed for one simulator, as they stand in `data/akb/completed/<simulator>/`:
/// size.csv, mass.csv and synset.csv of their own, affordance.csv, relation.csv and alias.csv with the columns of the
/// tables. Likelihoods are weights, and capacities are bounded by what fits when the facts are used.
struct CompletedFacts {
  struct Size {
    std::string category;
    Vec3 size = Vec3::Zero();  // meters, as Category::size
    Source source;
  };
  struct Mass {
    std::string category;
    double mass = 0;  // kilograms
    Source source;
  };
  struct Synset {
    std::string category, synset;
    Source source;
  };
  std::vector<Size> sizes;
  std::vector<Mass> masses;
  std::vector<Synset> synsets;
  std::vector<AffordanceFact> affordances;
  std::vector<Placement> placements;
  std::vector<Alias> aliases;
};

/// The categories about which the tables have a fact of a kind.
using StatedFacts = std::map<FactKind, std::set<std::string, std::less<>>>;
/// A size or mass that a rule derived with less than this confidence is a default: no source states one.
inline constexpr double kLeastConfidence = 0.5;
/// What tables state: a size or mass that is no default, a synset, one synonym or more, one function phrase, one
/// context, one place on or in something (furniture needs none), one affordance.
StatedFacts stated_by(const Tables& tables);
StatedFacts stated_by(const CompletedFacts& facts);
/// Whether the category has a fact of this kind.
bool is_stated(const StatedFacts& stated, FactKind kind, std::string_view category);

/// The folder of one simulator below that of the tables.
std::filesystem::path completed_folder(const std::filesystem::path& tables, Simulator simulator);
/// Where facts are taken back by hand: `<tables>/curated/<simulator>/removed.csv`.
std::filesystem::path removed_file(const std::filesystem::path& tables, Simulator simulator);
/// The files that lay_completed reads, in a fixed order, without those that are not there; part of the tables' digest.
std::vector<std::filesystem::path> completed_files(const std::filesystem::path& tables, Simulator simulator);

/// Reads what is there (no file is no fact); `known` names the categories. Appends every problem to `errors`.
CompletedFacts read_completed(const std::filesystem::path& folder, const Tables& known, std::vector<Error>& errors);
/// Writes the files, each aside and then renamed, sorted by key; a kind without facts has no file. Equal facts give
/// equal bytes. Errors: Io.
Result<Done> write_completed(const std::filesystem::path& folder, CompletedFacts facts);

/// Lays completed facts under the tables: each counts only where nothing of its kind is stated about its category,
/// whoever came first. Left out besides: synonyms that name something else too, places in which a thing does not fit or
/// that do not hold things. Places are made to sum to one.
void lay_under(const CompletedFacts& facts, const StatedFacts& stated, Tables& tables);

/// What a compilation does with the completed facts of a simulator: reads and lays them under its tables, but for those
/// that removed_file takes back. `stated` also knows what overrides tell. Errors are appended, as read_tables does.
void lay_completed(const std::filesystem::path& tables_folder, Simulator simulator, const StatedFacts& stated,
                   Tables& tables, std::vector<Error>& errors);

/// True when the relation (on, inside) can hold between the two by their bodies and affordances.
bool can_be_kept(const Category& object, Predicate relation, const Category& receptacle,
                 const std::set<std::string, std::less<>>& receptacle_affordances);

}  // namespace unietp
