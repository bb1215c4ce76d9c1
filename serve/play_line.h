#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace unietp {

/// Something that a person may name in a line, as the terminal listed it: by number or by id.
struct ListedThing {
  std::string id, category;
  bool operator==(const ListedThing&) const = default;
};

/// What a person typed, as the JSON of an action (environment/answer.h).
///  - the action by its name or the beginning of it, with blanks or underscores: "pick up", "pick_u";
///  - then what it is done to: a number of `listed`, counted from 1, or an id; in modes without ids a point "x,y" or a
///    box "x0,y0,x1,y1" of the picture;
///  - or pick_up(mug_1), as actions are written in texts.
/// `actions`: the names of those that are offered. Errors: Usage, for a person, when no action or more than one begins
/// so, when it is given too much or too little, or when there is no such number.
Result<std::string> typed_action(std::string_view line, const std::vector<std::string>& actions,
                                 const std::vector<ListedThing>& listed);

}  // namespace unietp
