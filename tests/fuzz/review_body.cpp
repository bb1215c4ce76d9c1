#include <set>

#include "bodies.h"
#include "fuzz_bodies.h"
#include "report/review_file.h"
#include "support.h"

namespace unietp::fuzz {

bool review_body(std::string_view text) {
  const auto reviews = read_reviews("fuzz", text);
  if (!reviews) {
    check_error(reviews.error());
    return false;
  }
  std::set<std::string> judged;
  for (const Review& review : *reviews) {
    require(!review.instruction.empty() && judged.insert(review.task).second);
    require((review.judgment == Judgment::Edit) == !review.text.empty());
  }
  return true;
}

}  // namespace unietp::fuzz
