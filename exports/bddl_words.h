#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "akb/knowledge.h"
#include "core/result.h"
#include "scene/scene.h"

namespace unietp {

/// OmniGibson's synset of each of its categories, or of each substance.
using BddlSynsets = std::map<std::string, std::string, std::less<>>;

/// What BEHAVIOR calls our categories and substances.
struct BddlWords {
  BddlSynsets categories;  // data/bddl/synsets.csv
  BddlSynsets substances;  // data/bddl/substances.csv
};
/// A table with a column of ours, `category` or `substance`, and one of synsets. Errors: Io; those of a table that is
/// none.
Result<BddlSynsets> read_bddl_synsets(const std::filesystem::path& file);
/// Both tables of a folder. Errors: as above.
Result<BddlWords> read_bddl_words(const std::filesystem::path& folder);

/// What a vessel of the scene may hold at some time: what it holds at the start, and what can be filled in.
std::set<std::string> liquids_of(const Scene& start, const Knowledge& knowledge);

/// The agent and substances are objects of a problem, one of each: "agent.n.01_1", "water.n.06_1".
inline constexpr const char* kBddlAgent = "agent.n.01_1";

/// The BDDL formula of a state of an object, such as "(not (covered mug.n.04_1 stain.n.01_1))"; "" for what BDDL has no
/// word for. `object` is its name in the problem, or a variable with `?`; then what else the formula names has a `?`
/// before it, too. `liquids`: ours, that a vessel may hold. Synsets of the substances that it names are added to
/// `used`.
std::string bddl_state(const State& state, const std::string& object, const BddlWords& words,
                       const std::set<std::string>& liquids, std::set<std::string>& used);
/// "ontop"; "" for what BDDL has no word for.
std::string_view bddl_relation(Predicate predicate);

}  // namespace unietp
