#include "validator/key_list.h"

#include <algorithm>

namespace unietp {

void KeyList::sort() {
  if (!sorted_) std::sort(entries_.begin(), entries_.end());
  sorted_ = true;
}

std::vector<Repeat> KeyList::repeats() {
  sort();
  std::vector<Repeat> repeats;
  std::size_t first = 0;
  for (std::size_t i = 1; i < entries_.size(); ++i) {
    if (entries_[i].key == entries_[first].key) {
      repeats.push_back({entries_[i].place, entries_[first].place});
    } else {
      first = i;
    }
  }
  std::sort(repeats.begin(), repeats.end());
  return repeats;
}

std::vector<std::size_t> KeyList::places(std::string_view text) {
  sort();
  const Entry least{Digester().add(text).digest(), 0};
  std::vector<std::size_t> places;
  for (auto at = std::lower_bound(entries_.begin(), entries_.end(), least);
       at != entries_.end() && at->key == least.key; ++at)
    places.push_back(at->place);
  return places;
}

void TaskNames::add(const std::string& name) {
  keys_.add(name, ends_.size());
  names_ += name;
  ends_.push_back(names_.size());
}

std::string TaskNames::name(std::size_t place) const {
  const std::size_t begin = place == 0 ? 0 : ends_[place - 1];
  return names_.substr(begin, ends_[place] - begin);
}

}  // namespace unietp
