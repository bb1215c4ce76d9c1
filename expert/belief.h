#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "expert/search_needs.h"
#include "scene/node_index.h"
#include "scene/scene.h"
#include "scene/trace.h"

namespace unietp {

/// What an agent holds true of a home: what it knew at the start, what it has seen since, each thing as it looked last,
/// and what its own actions must have changed. Furniture that it has not seen yet is taken to be in the state that the
/// goal presupposes: a lamp that is to be switched off is on, until it is seen to be off. How it looks is not known.
class Belief {
 public:
  /// `relevant`: categories of which news matters.
  Belief(const Scene& known_scene, const SearchNeeds& needs, std::set<std::string> relevant);

  /// Takes in what is in view and in the hand, and where the agent is.
  void see(const std::vector<Node>& view, const Agent& body);
  /// Takes in what an action changed as it was foreseen.
  void foresee(const Delta& changes);

  const Scene& scene() const { return scene_; }  // without relations
  const NodeIndex& places() const { return places_; }
  /// nullptr when it knows of none.
  const Node* find(std::string_view id) const;
  bool has_seen(std::string_view id) const { return seen_.contains(id); }
  /// Of the category, known so far to be of a color or material.
  bool knows_of_look(const std::string& category, const State& look) const;
  /// Whether the goal tells things of the category apart by color or material.
  bool told_by_look(const std::string& category) const { return told_by_look_.contains(category); }
  /// How many things of the category it knows of.
  int count(const std::string& category) const { return static_cast<int>(places_.of(category).size()); }
  /// Grows whenever something relevant is seen for the first time or looks otherwise than believed.
  int news() const { return news_; }
  /// What was last such news.
  const std::string& last_news() const { return last_news_; }
  /// What the last view showed for the first time, or elsewhere than believed.
  const std::vector<std::string>& moved() const { return moved_; }
  /// Whether the last view showed anything in another way than believed.
  bool differed() const { return differed_; }

 private:
  /// Whether it was not so already.
  bool put(const Node& node);

  Scene scene_;
  NodeIndex places_;
  std::set<std::string, std::less<>> seen_;
  std::set<std::string> relevant_, told_by_look_;
  int news_ = 0;
  std::string last_news_;
  std::vector<std::string> moved_;
  bool differed_ = false;
};

}  // namespace unietp
