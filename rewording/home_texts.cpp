#include "rewording/home_texts.h"

#include "dataset/candidate.h"

namespace unietp {

bool HomeTexts::add(const std::string& layout, const std::string& text) {
  return homes_[layout].texts.insert(normalized_text(text)).second;
}

bool HomeTexts::contains(const std::string& layout, const std::string& text) const {
  const auto home = homes_.find(layout);
  return home != homes_.end() && home->second.texts.contains(normalized_text(text));
}

void HomeTexts::pass(const std::string& layout) {
  const auto home = homes_.find(layout);
  if (home != homes_.end() && --home->second.tasks_left <= 0) homes_.erase(home);
}

}  // namespace unietp
