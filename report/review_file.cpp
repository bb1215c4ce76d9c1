#include "report/review_file.h"

#include <array>
#include <set>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "scene/json_parse.h"
#include "scene/json_reader.h"

namespace unietp {
namespace {

Review read_one(JsonReader& reader, const JsonAt& at) {
  JsonFields fields(reader, at);
  Review review;
  if (const auto f = fields.required("task")) review.task = reader.plain_name(*f);
  if (const auto f = fields.required("verdict")) review.judgment = read_judgment(reader, *f);
  if (const auto f = fields.required("instruction")) review.instruction = reader.text(*f);
  const auto text = fields.optional("text");
  if (text) review.text = trim(reader.text(*text));
  const bool edit = review.judgment == Judgment::Edit;
  if (!reader.error() && edit == review.text.empty())
    reader.fail(at, edit ? "an edit needs a text" : "has a text, but the verdict is not an edit");
  if (const auto f = fields.required("comment")) {
    const auto* comment = f->json.get_ptr<const nlohmann::ordered_json::string_t*>();
    if (comment != nullptr)
      review.comment = *comment;
    else
      reader.fail(*f, "expected a text");
  }
  fields.finish();
  return review;
}

}  // namespace

Result<std::vector<Review>> read_reviews(std::string_view where, std::string_view text) {
  const auto json = parse_json(where, text);
  if (!json) return json.error();
  JsonReader reader(where);
  const JsonAt root{*json};
  JsonFields fields(reader, root);
  if (const auto f = fields.required("format")) {
    if (const auto format = reader.text(*f); format != "unietp-review/1")
      reader.fail(*f, "expected the format \"unietp-review/1\", not " + in_quotes(format));
  }
  if (const auto f = fields.required("set")) (void)reader.text(*f);
  if (const auto f = fields.required("tasks_sha256")) (void)reader.text(*f);
  std::vector<Review> reviews;
  std::set<std::string> seen;
  if (const auto f = fields.required("reviews")) {
    const std::size_t count = reader.items(*f);
    for (std::size_t i = 0; i < count && !reader.error(); ++i) {
      const JsonAt item = reader.item(*f, i);
      reviews.push_back(read_one(reader, item));
      if (!seen.insert(reviews.back().task).second && !reader.error())
        reader.fail(item, "the task " + in_quotes(reviews.back().task) + " occurs twice");
    }
  }
  fields.finish();
  if (reader.error()) return *reader.error();
  return reviews;
}

}  // namespace unietp
