#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "akb/knowledge.h"
#include "core/least_first.h"
#include "scene/action.h"
#include "simulation/world.h"

namespace unietp {

/// Furniture that takes a thing out of the hand, best first: what the goal does not speak of, what is usual for the
/// thing, what is in reach, what is near. By how things are when it is made, whenever the next one is asked for.
class PutDownOptions {
 public:
  struct Request {
    std::string thing;                   // id
    std::string room;                    // id; "" for any
    std::string except;                  // id of furniture; may be ""
    std::vector<std::string> spoken_of;  // categories
  };
  /// The knowledge must outlive it.
  PutDownOptions(const World& world, const Knowledge& knowledge, Request request);

  /// `place_on` or, where a room was asked for, also `place_in`; nullopt when there are no more, or enough were given.
  std::optional<Action> next();

 private:
  /// A home has a thousand pieces that would take a mug, and most mugs go to one where mugs usually are.
  struct Class {
    bool spoken_of, usual;
  };
  using Rank = std::tuple<bool, double, std::string, ActionType>;  // out of reach, meters to walk, id
  struct Spot {
    std::size_t place;  // of furniture among the nodes
    ActionType action;
  };
  void add_all_of(Class wanted);
  void add_all_of(std::string_view category, bool usual);

  World world_;
  const Knowledge* knowledge_;
  Request request_;
  std::size_t classes_ = 0;  // that were added, the best first
  LeastFirst<Spot, Rank> spots_;
};

}  // namespace unietp
