#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "expert/window.h"
#include "scene/node_index.h"
#include "scene/trace.h"

namespace unietp {

/// A window whose things keep the names that they were given. In M3, whose pictures tell what is where but not which
/// thing is one that was seen before, it follows things as a person does: one of the same kind, look and size at the
/// same place is the same; what the agent itself moved is where that must have led, or near there; the rest is new, and
/// is called by kind and number, "mug_2" for the second mug, from left to right. In M2 things have ids, which stay.
class Recognition : public Window {
 public:
  /// The window must outlive it.
  Recognition(Window& window, Mode mode);

  const Scene& known_scene() const override { return window_.known_scene(); }
  /// As it was looked at last.
  std::vector<Node> view() const override { return view_; }
  const Agent& body() const override { return body_; }
  /// Does the action. What came of it shows after the next look.
  Outcome act(const Action& action) override;
  /// The agent's last action must have changed this, to who knows what it has seen.
  void expect(const Delta& changes);
  void look();

 private:
  bool may_be(const Node& seen, const Node& known) const;
  void name_in_hand();
  void name_by_place(bool moved, double most_m);
  void name_the_rest();
  void remember(std::size_t seen, std::string name);

  Window& window_;
  bool names_;   // M3
  Scene known_;  // the rooms, and all that was given a name, as it was when it was last seen or moved
  NodeIndex places_;
  std::set<std::string, std::less<>> moved_;                // by the agent, and not seen since
  std::set<std::string, std::less<>> gone_;                 // cut into slices
  std::vector<std::string> held_;                           // by names
  std::map<std::string, std::string, std::less<>> called_;  // in the window, what is in view
  std::string taken_;                                       // by the last action
  // Of the present view.
  std::vector<Node> view_;
  std::vector<std::string> given_;  // "": none yet
  std::set<std::string, std::less<>> used_;
  Agent body_;
};

}  // namespace unietp
