#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "expert/demonstration.h"
#include "expert/window.h"

namespace unietp {

/// What somebody behind a window was shown, and what they did.
struct Witnessed {
  struct Moment {
    std::vector<Node> view;
    Agent body;
    bool operator==(const Moment&) const = default;
  };
  Scene known_scene;
  std::vector<Moment> moments;    // before each action, and after the last
  std::vector<Action> actions;    // also those that failed
  std::vector<Outcome> outcomes;  // of each action
};

/// A window that keeps what passes through another one, which must outlive it.
class WitnessWindow : public Window {
 public:
  explicit WitnessWindow(Window& window);
  const Scene& known_scene() const override { return seen_.known_scene; }
  std::vector<Node> view() const override { return seen_.moments.back().view; }
  const Agent& body() const override { return seen_.moments.back().body; }
  Outcome act(const Action& action) override;
  /// All that passed so far.
  const Witnessed& seen() const { return seen_; }

 private:
  void look();
  Window& window_;
  Witnessed seen_;
};

/// A window with no world behind it: it shows what somebody else was shown, as long as the same is done.
class RecordedWindow : public Window {
 public:
  /// The record must outlive it.
  explicit RecordedWindow(const Witnessed& record) : record_(record) {}
  const Scene& known_scene() const override { return record_.known_scene; }
  std::vector<Node> view() const override { return record_.moments[at_].view; }
  const Agent& body() const override { return record_.moments[at_].body; }
  /// Something else than what was done fails, and from then on everything does.
  Outcome act(const Action& action) override;
  /// Whether all that was done has been done again, and nothing else.
  bool same() const { return !other_ && at_ == record_.actions.size(); }

 private:
  const Witnessed& record_;
  std::size_t at_ = 0;
  bool other_ = false;
};

/// How many moments two were shown in common from the beginning, with the outcomes that led to them.
std::size_t same_moments(const Witnessed& one, const Witnessed& other);
/// Whether they did the same as long as they were shown the same.
bool acted_alike(const Witnessed& one, const Witnessed& other);

/// The same start without the thing that a demonstration uses and sees last of all, and without what rests on it; a
/// world that looks the same until then. nullopt when everything used was in view at the start.
std::optional<Scene> twin_of(const Scene& start, const Demonstration& demonstration);

/// The same start in which furniture of one kind that was not in view at the beginning of a demonstration has each
/// other's colors and materials; a world that looks the same until some of it is seen. nullopt when that is the same.
std::optional<Scene> painted_otherwise(const Scene& start, const Demonstration& demonstration);

}  // namespace unietp
