#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "serve/play_line.h"

namespace unietp {

// What a person reads in a terminal, from the answers of the protocol. Every text of a data set is made safe for it.

/// "Step 3, 47 left; 9 failures left. In the hand: mug_1."
std::string standing_text(const nlohmann::ordered_json& observation);
/// A line for each action since the observation before: "pick_up(mug_1): done".
std::string results_text(const nlohmann::ordered_json& observation);
/// The things of a list of an observation, such as "boxes"; those whose id or category has `word` in it.
std::vector<ListedThing> things_of(const nlohmann::ordered_json& observation, const std::string& list,
                                   const std::string& word = "");
/// A title and the things in columns, numbered from `first`; "" for none.
std::string listing_text(const std::string& title, const std::vector<ListedThing>& things, std::size_t first);
/// The actions by class, each with its effect.
std::string actions_text(const nlohmann::ordered_json& actions);
/// How to play.
std::string play_help();

}  // namespace unietp
