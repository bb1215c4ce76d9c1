#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/action.h"
#include "scene/simulator.h"

namespace unietp {

/// What a policy has to name. A list that several modes tell is played in the mode that tells the least else.
enum class GuessChoice : std::uint8_t {
  SmallThing,   // of the list of small things in M1: one that the goal needs
  Furniture,    // of the list of furniture in M2: a piece that the goal needs
  OfKind,       // of the things of the kinds that a phrase names: the one that it means; M1, of furniture M2
  Room,         // of the list of rooms in M3: one with a small thing that the goal needs
  InView,       // of what the camera shows before the first step: something that the goal needs
  FirstObject,  // of all that the mode lists: what the demonstration's first action is done to
};

/// One thing or room that may be named, with all that a policy may know of it. Keys are hashes of words. The numbers
/// from `place` on are what may leak; ranks are in [0, 1] and say how unusual the thing is among those of its kind in
/// other homes: 1 when none of them is so, 0.5 on average.
struct GuessOption {
  std::uint64_t kind = 0;                                // key of simulator and category; of a room, of its type
  std::uint64_t states = 0, support = 0, room_type = 0;  // keys; of the states that the goal does not speak of
  int room = -1;                                         // place in the home's list of rooms; -1: in none
  bool has_asset = false;
  bool is_named = false;  // the instruction has the words of its category
  bool is_where_asked =
      false;  // it is on or in a thing of a kind that the goal names, or on the floor and the goal is about that
  // Of other homes, for the same kind: the share of tasks, in which it was there, whose goal needs it; how often goals
  // of this template need it; how often demonstrations of this split and mode begin with it.
  float goal_share = 0, template_share = 0, first_share = 0;
  float expected_rank = 0, expected_place = 0,
        text_rank = 0;  // what instructions of other homes suggest (audit/text_rank.h)

  float place = 0;                      // in its list: 0 the first, 1 the last
  float number = 0;                     // at the end of its id; 0: none
  float number_rank = 0;                // among the options of its kind: 0 the lowest, 1 the highest; 0.5 alone
  float of_kind = 1;                    // options of its kind
  float elsewhere = 0;                  // share of the other homes that have its kind
  float odd_count = 0.5F, more = 0.5F;  // rank of of_kind; share of other homes with fewer of its kind
  float odd_states = 0.5F;              // rank of its states
  float odd_support = 0.5F;             // rank of what it is on or in
  float odd_room = 0.5F;                // rank of its room's type
  float odd_asset = 0.5F;               // rank of having, or not having, a model of the simulator
  float alike = 1;                      // options of its kind with the same states
  float distance = 0;                   // from where the agent starts, meters, as the crow flies
  float area = 0, low_edge = 0;         // of its box in the picture: pixels, and the row of its lower side
};

/// A choice in one task. At least one option is right, and at least one is wrong.
struct GuessQuestion {
  GuessChoice choice = GuessChoice::SmallThing;
  Mode mode = Mode::M1;
  std::vector<GuessOption> options;
  std::vector<bool> right;  // by option
};

/// A task as the policies see it.
struct AuditedTask {
  std::string id, split, template_name, home;
  Simulator simulator = Simulator::Ai2thor;
  std::vector<std::string> words;   // of the instruction, lower case
  std::vector<GuessOption> things;  // all of the start, in the order of the scene
  std::vector<bool> needed;         // by thing: the goal needs it
  std::vector<GuessQuestion> questions;
};

}  // namespace unietp
