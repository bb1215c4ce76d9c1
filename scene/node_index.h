#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "scene/scene.h"

namespace unietp {

/// Index of Scene::nodes by id and by category. A copy shares what was known when it was made and stores only its own
/// changes, so a candidate costs what it changes, not what the home holds.
class NodeIndex {
 public:
  using Places = std::vector<std::size_t>;

  NodeIndex();
  explicit NodeIndex(const SharedList<Node>& nodes);

  /// Place of the node with this id; nullopt when there is none.
  std::optional<std::size_t> find(std::string_view id) const;
  /// Ascending.
  const Places& of(std::string_view category) const;
  /// The categories of all nodes, sorted.
  std::vector<std::string_view> categories() const;

  /// Tells the index that a node was put at a place, or removed from it.
  void add(std::size_t place, const Node& node);
  void remove(std::size_t place, const Node& node);

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
  };
  template <class Value>
  using ByText = std::unordered_map<std::string, Value, Hash, std::equal_to<>>;  // never iterated
  struct Common {
    ByText<std::size_t> by_id;
    ByText<Places> by_category;
    std::vector<std::string> categories;  // sorted
  };

  Places& own(const std::string& category);

  std::shared_ptr<const Common> common_;  // shared by all that grew out of one scene; never changed
  ByText<std::optional<std::size_t>> by_id_;
  ByText<Places> by_category_;
};

}  // namespace unietp
