#pragma once

#include <optional>
#include <vector>

#include "logic/formula.h"
#include "symbolic/perform.h"
#include "symbolic/world.h"

namespace unietp::symbolic {

/// A truth that can be asked of one world.
struct Atom {
  Predicate predicate = Predicate::Open;
  Id first = kNobody, second = kNobody;
  std::optional<SubstanceId> symbol;  // of filled and covered; nullopt: any
};

/// The facts from which each `:where` is read when they come from a physical scene rather than a symbolic world: such a
/// scene also shows what is next to and nearest to what. `ids` maps entities to ids; kNobody for what the world lacks.
struct SeenStart {
  const Trace* trace = nullptr;
  const std::vector<Id>* ids = nullptr;
};

/// A goal with its quantifiers expanded over a cast: `exists` becomes a disjunction over the members, `forall` a
/// conjunction, a count a list of members. Made for one start, in which each `:where` is read. Pieces that do not exist
/// yet are members too; they have to be made first.
class Goal {
 public:
  enum class Op : std::uint8_t { Atom, And, Or, Not, Count, Compare, AtEnd, Sometime, Always, Until, Before };
  struct Node {
    Op op = Op::And;
    symbolic::Atom atom;
    int least = 0, most = 0;                    // Count: how many children hold
    Comparison comparison = Comparison::Equal;  // Compare: the first `split` children against the rest
    std::size_t split = 0;
    std::size_t memory = 0;  // Sometime to Before: place in Progress
    std::vector<std::size_t> children;
  };

  /// A goal or a state formula.
  Goal(const Formula& goal, const Setting& setting, const World& start, const SeenStart& seen = {});

  /// A node by its position; `root` is that of the whole goal.
  const Node& node(std::size_t index) const { return nodes_[index]; }
  std::size_t root() const { return root_; }
  /// Number of temporal parts, each with its place in Progress.
  std::size_t memories() const { return memories_; }
  /// False when a temporal operator stands inside another: then truths here are only a guess.
  bool understood() const { return understood_; }

 private:
  friend class GoalWriter;
  std::vector<Node> nodes_;
  std::size_t root_ = 0, memories_ = 0;
  bool understood_ = true;
};

/// What has happened so far of each temporal part.
class Progress {
 public:
  enum class Part : std::uint8_t { Open, FirstDone, Done, Broken };
  explicit Progress(const Goal& goal) : parts_(goal.memories(), Part::Open) {}
  /// Takes in the next state of the trace, the start first.
  void observe(const Goal& goal, const Setting& setting, const World& world);
  /// Performs a step and takes in all worlds that it leads through. A failed one changes nothing.
  Failure perform(const Goal& goal, const Setting& setting, World& world, const Step& step);
  /// What has happened of one temporal part (Goal::Node::memory), and of all.
  Part part(std::size_t memory) const { return parts_[memory]; }
  bool operator==(const Progress&) const = default;
  const std::vector<Part>& parts() const { return parts_; }

 private:
  std::vector<Part> parts_;
};

/// Whether a node holds if the trace ends with `world`.
bool holds(const Goal& goal, std::size_t node, const Setting& setting, const World& world, const Progress& progress);

}  // namespace unietp::symbolic
