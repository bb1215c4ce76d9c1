#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "scene/states.h"
#include "sense/evidence.h"
#include "sense/kinds.h"

namespace unietp {

/// Of the things of a kind at a place, the share that is in a state in a home by day: a row of start_states.csv.
struct LikelyState {
  State state;               // `filled` and `covered` with their substance
  double share = 0;          // 0 to 1
  std::string thing, place;  // the kind and the role of the row; place "" for anywhere
  std::string source;        // `curated` when a person judged it
};

/// How likely things are in states before a task: a plate in a cabinet is clean, one in the sink is dirty, curtains are
/// open by day, lamps and stoves are off, fridges closed. Read only after loading.
class StartStates {
 public:
  StartStates(const Kinds& kinds, std::vector<LikelyState> rows);

  /// Each state that is spoken of for such a thing there, with its share; sorted by state. Of several rows for a state
  /// one of its place decides, of the narrowest kind of place and then of thing; otherwise one without a place.
  /// `place`: "in:sink" (role_of of usual_places.h), "" when it is not known. Whether the thing can be in the state at
  /// all is for the caller to know. The shares of states that exclude one another sum to at most one.
  std::vector<LikelyState> of(std::string_view kind, const Role& place) const;
  /// The share of one state; nullopt when nobody spoke of it, and the thing is then as it is by default.
  std::optional<double> share(std::string_view kind, const Role& place, const State& state) const;

 private:
  Kinds kinds_;
  std::vector<LikelyState> rows_;  // by thing, place
};

/// Reads start_states.csv (thing,place,state,substance,share,source). Errors are appended: an unknown kind or state, a
/// place that is no role of places, a substance where there can be none, a row that stands twice.
StartStates read_start_states(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors);

}  // namespace unietp
