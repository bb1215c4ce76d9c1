#pragma once

#include <array>
#include <span>
#include <vector>

#include "symbolic/goal.h"
#include "symbolic/perform.h"

namespace unietp::symbolic {

/// A few different steps; what does not fit in any more is left out. In place, since a search makes many.
class FewSteps {
 public:
  void add(const Step& step);
  void add(const FewSteps& more);
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  std::span<const Step> all() const { return {steps_.data(), size_}; }

 private:
  std::array<Step, 16> steps_;
  std::size_t size_ = 0;
};

/// How far it is to a truth, and what to do next.
struct Wish {
  static constexpr int kImpossible = 1000000;
  int cost = 0;    // actions other than going somewhere, as if parts did not get in each other's way
  FewSteps steps;  // first steps of ways to it, each worth a try; empty when it holds or cannot be
  bool possible() const { return cost < kImpossible; }
};
inline const Wish kNever{Wish::kImpossible, {}};

/// Reads off from a world what has to be done next for a truth: the step that brings it about, or, where that step
/// needs something first, the step towards that. An estimate that guides a search: what it says may fail or take more.
class Guide {
 public:
  Guide(const Setting& setting, const Goal& goal) : setting_(setting), goal_(goal) {}

  /// Towards the goal's holding if the trace ends soon after `world`.
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

/// Towards one truth of one world, or, with `wanted` false, away from it.
Wish towards(const Setting& setting, const World& world, const Atom& atom, bool wanted);

/// What one needs after another: costs add up, and what is still to be done of any of them may be done now.
Wish together(Wish first, const Wish& second);
/// One of several ways: the cheapest decides, the two next stay open.
class Choice {
 public:
  void add(const Wish& way);
  std::size_t size() const { return size_; }  // ways that are possible, at most three
  Wish wish() const;

 private:
  std::array<Wish, 3> ways_;  // the cheapest first, of equal ones the first that came
  std::size_t size_ = 0;
};

}  // namespace unietp::symbolic
