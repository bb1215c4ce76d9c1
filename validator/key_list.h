#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "simulation/digest.h"

namespace unietp {

/// A task that comes again, and the first one with the same key; both by place in tasks.jsonl, from 0.
struct Repeat {
  std::size_t place = 0, first = 0;
  auto operator<=>(const Repeat&) const = default;
};

/// Keys of many tasks, of 128 bits each, among which equal ones are found: 24 bytes a task, whatever the keys stand
/// for.
class KeyList {
 public:
  /// Adds the key of a task, by its place in tasks.jsonl. A text counts by its digest.
  void add(const Digest& key, std::size_t place) {
    entries_.push_back({key, place});
    sorted_ = false;
  }
  /// The same by a text.
  void add(std::string_view text, std::size_t place) { add(Digester().add(text).digest(), place); }

  /// In order of place.
  std::vector<Repeat> repeats();
  /// The places of a key, rising.
  std::vector<std::size_t> places(std::string_view text);

 private:
  struct Entry {
    Digest key;
    std::size_t place = 0;
    bool operator<(const Entry& other) const {
      return std::tuple(key.a, key.b, place) < std::tuple(other.key.a, other.key.b, other.place);
    }
  };
  void sort();

  std::vector<Entry> entries_;
  bool sorted_ = false;
};

/// The names of a data set's tasks, by place: some 50 bytes a task.
class TaskNames {
 public:
  void add(const std::string& name);  // of the next task
  std::size_t size() const { return ends_.size(); }
  std::string name(std::size_t place) const;  // of the task at that place, from 0
  /// Tasks whose name an earlier one has.
  std::vector<Repeat> repeats() { return keys_.repeats(); }
  /// The places of the tasks with a name, rising.
  std::vector<std::size_t> places(const std::string& name) { return keys_.places(name); }

 private:
  std::string names_;              // one after the other
  std::vector<std::size_t> ends_;  // of each
  KeyList keys_;
};

}  // namespace unietp
