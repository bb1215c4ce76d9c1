#pragma once

#include <array>
#include <span>
#include <vector>

#include "symbolic/goal.h"
#include "symbolic/perform.h"

namespace unietp::symbolic {

/// A set of at most 16 steps; further ones are dropped. Stored in place, since a search makes many of these.
class FewSteps {
 public:
  /// Ignored when it is there already or there is no room.
  void add(const Step& step);
  void add(const FewSteps& more);
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  std::span<const Step> all() const { return {steps_.data(), size_}; }

 private:
  std::array<Step, 16> steps_;
  std::size_t size_ = 0;
};

/// An estimate of the way to make something true: its cost, and possible next steps.
struct Wish {
  static constexpr int kImpossible = 1000000;
  int cost = 0;    // actions other than going somewhere, as if parts did not get in each other's way
  FewSteps steps;  // first steps of ways to it, each worth a try; empty when it holds or cannot be
  bool possible() const { return cost < kImpossible; }
};
inline const Wish kNever{Wish::kImpossible, {}};

/// Estimates from a world how to make something true: the step that does it or, if that step has unmet needs, a step
/// towards those. A heuristic for a search: its steps may fail, and its costs may be too low.
class Guide {
 public:
  Guide(const Setting& setting, const Goal& goal) : setting_(setting), goal_(goal) {}

  /// The way to a world in which the goal holds, if the trace ends there.
  Wish wish(const World& world, const Progress& progress) const;

 private:
  Wish towards(std::size_t node, bool wanted, const World& world, const Progress& progress) const;
  Wish towards_number(const std::vector<std::size_t>& children, int least, int most, const World& world,
                      const Progress& progress) const;
  Wish towards_comparison(const Goal::Node& node, bool wanted, const World& world, const Progress& progress) const;
  Wish towards_moment(const Goal::Node& node, const World& world, const Progress& progress) const;

  const Setting& setting_;
  const Goal& goal_;
};

/// The way to make one atom true or, with `wanted` false, false.
Wish towards(const Setting& setting, const World& world, const Atom& atom, bool wanted);

/// Both are needed: costs add up, and the next steps of either may come first.
Wish together(Wish first, const Wish& second);
/// One of several ways is enough: the cost is that of the cheapest; the first steps of the next two are kept too.
class Choice {
 public:
  /// Ignored when it is impossible or dearer than three others.
  void add(const Wish& way);
  std::size_t size() const { return size_; }  // ways that are possible, at most three
  /// The cheapest way, with the first steps of the others; kNever when there is none.
  Wish wish() const;

 private:
  std::array<Wish, 3> ways_;  // the cheapest first, of equal ones the first that came
  std::size_t size_ = 0;
};

}  // namespace unietp::symbolic
