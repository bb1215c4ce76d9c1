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

/// At which places of Scene::nodes things stand: by id and by category. Copies have what was there when it was made in
/// common and own only what changed since, so that a candidate costs what it changes and not what the home holds.
class NodeIndex {
 public:
  using Places = std::vector<std::size_t>;

  NodeIndex();
  explicit NodeIndex(const SharedList<Node>& nodes);

  std::optional<std::size_t> find(std::string_view id) const;
  /// Ascending.
  const Places& of(std::string_view category) const;
  /// All that something is of, sorted.
  std::vector<std::string_view> categories() const;

  /// A node came to a place, or left it.
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
