#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "sense/kinds.h"

namespace unietp {

/// How much sense something makes in a home. Ordered from worst to best.
enum class Grade : std::uint8_t { Senseless, Tolerable, Usual };
inline constexpr std::array kGrades{Grade::Senseless, Grade::Tolerable, Grade::Usual};
std::string_view name_of(Grade grade);  // "usual"
/// nullopt for another word.
std::optional<Grade> grade_named(std::string_view name);

/// What is done with a thing, or where it is put, as one word:
/// `on:counter`, `in:fridge`, `next_to:cup`, `under:bed`, `attach:lamp`: where it is;
/// `in_room:kitchen`; `heat`, `wash`, `open`, `switch_on`, ...: what is done with it or what state it is brought into;
/// `fill:water`, `cover:spice`, `uncover:food`: with what, a liquid or the kind of a substance;
/// `cook>on:plate`: the first, then the second, with one and the same thing.
using Role = std::string;
/// The roles that a role is compared with: "place" for those of places, "do" for what is done, else the part before the
/// mark: "fill", "cook>".
std::string family_of(std::string_view role);

/// What people wrote or said about a thing of a kind in a role, all places of one source together.
struct Evidence {
  std::string thing;  // kind
  Role role;
  double weight = 0;    // > 0; a description of an activity counts 1
  std::string example;  // "setting_the_table"
  std::string source;   // "metadata:activity_definitions"
  bool operator==(const Evidence&) const = default;
};
/// Reads counts.csv (thing,role,weight,example,source). Errors are appended.
std::vector<Evidence> read_evidence(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors);
/// The same table as text; weights are rounded to three decimals.
std::string csv_of(const std::vector<Evidence>& evidence);

/// What a person judged of a kind, and so of all narrower ones that nobody judged: a row of judged.csv.
using Judgments = std::map<std::pair<std::string, Role>, Grade>;
/// Reads judged.csv (thing,role,grade,source). Errors are appended.
Judgments read_judgments(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors);

/// A rule of sense or safety, which no evidence overrides: a row of rules.csv.
struct SenseRule {
  std::string name;
  bool together = false;  // true: `thing` and `other` at one place; false: `thing` in the role `other`, or `stored`
  std::string thing;      // a kind, `material:metal`, or `words:` with names of things as in words.csv, split by |
  std::vector<std::string> except;
  std::string other;  // a kind; or a role, where a final * stands for any ending
  std::string reason;
  std::set<std::string, std::less<>> words = {};  // of `words:`
  bool stored = false;                            // `thing` and `other` in one closed place
};
/// Reads rules.csv (name,form,thing,except,other,reason,source). Errors are appended.
std::vector<SenseRule> read_sense_rules(const std::filesystem::path& path, const Kinds& kinds,
                                        std::vector<Error>& errors);

}  // namespace unietp
