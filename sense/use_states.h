#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "logic/vocabulary.h"
#include "sense/evidence.h"
#include "sense/kinds.h"

namespace unietp {

/// What state things of some kinds are in when people use them so: a row of use_states.csv.
struct UseState {
  Role use;  // a role; `carry:food` for what such things are put on or in; a final * stands for any ending
  std::vector<std::string> things;  // kinds
  Predicate state = Predicate::Clean;
};

/// In which states people find what they use: what is set on a table is clean, what goes into a dishwasher is dirty,
/// what is warmed up is cooked. Read only after loading.
class UseStates {
 public:
  UseStates() = default;
  /// Rows of the same state group that come first are stronger.
  explicit UseStates(std::vector<UseState> rows) : rows_(std::move(rows)) {}

  /// The states of a thing of the kind that is used so, at most one of a group, in the order of the table. `use`: a
  /// role such as "on:dining_table"; of "carry:", the kind of what is carried.
  std::vector<Predicate> of(std::string_view kind, const Role& use, const Kinds& kinds) const;

 private:
  std::vector<UseState> rows_;
};

/// Reads use_states.csv (use,things,state,source). Errors are appended: Io, Parse; Schema for an unknown kind, and for
/// a state that is none or needs a substance.
UseStates read_use_states(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors);

}  // namespace unietp
