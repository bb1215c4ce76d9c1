#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace unietp {

/// A kind of household things, a row of data/sense/kinds.csv: "cup", to drink something hot from.
struct Kind {
  std::string name, singular, plural;
  std::string parent;  // the wider kind; "" for the root alone
  std::string purpose;
  /// How things are at it: "on", "in", or "" when nothing is. "on|in" and "in|on" when a thing on it is elsewhere than
  /// a thing in it, the usual one first; otherwise both relations mean the same.
  std::string relation;
  std::string piece;      // the kind of its slices; "" when they are of the same kind
  bool personal = false;  // each belongs to somebody: nobody asks for just any of several
  bool several = false;   // homes have several alike: spoons, apples, books
};

/// The taxonomy: a tree of kinds. Read only.
class Kinds {
 public:
  Kinds() = default;
  /// `kinds` in any order, sound (read_kinds checks that).
  explicit Kinds(std::vector<Kind> kinds);

  /// In the order of the table.
  const std::vector<Kind>& all() const { return kinds_; }
  /// nullptr for an unknown name.
  const Kind* find(std::string_view name) const;
  /// The kind and all wider ones, narrowest first; empty for an unknown name.
  std::vector<const Kind*> lineage(std::string_view name) const;
  /// The kinds right below it, in the order of the table; empty for an unknown name.
  std::vector<const Kind*> narrower(std::string_view name) const;
  /// True when `wider` is the kind itself or one above it.
  bool is_a(std::string_view kind, std::string_view wider) const;
  /// The kind of what slicing a thing of this kind makes.
  std::string piece_of(const std::string& kind) const;
  /// "on" or "in", as people say it of the place; "on" for a kind that is no place.
  std::string usual_relation(std::string_view place) const;
  /// The role of being there: "on:counter". Where the relation makes no difference, it is the usual one.
  std::string place_role(std::string_view relation, std::string_view place) const;

 private:
  static constexpr std::size_t kNone = -1;
  std::size_t number_of(std::string_view name) const;

  std::vector<Kind> kinds_;
  std::vector<std::size_t> parents_;  // by kind; kNone for the root
  std::map<std::string, std::size_t, std::less<>> by_name_;
};

/// Reads kinds.csv. Errors are appended, with line and column: a name that stands twice, an unknown parent or piece,
/// another relation, a circle (then there are no kinds), or more than one root.
Kinds read_kinds(const std::filesystem::path& path, std::vector<Error>& errors);

}  // namespace unietp
