#include "scene/json_parse.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/limits.h"
#include "scene/json_pointer.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kFewFields = 64;  // up to so many, names are compared one by one

/// "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error …" from the library without what
/// our own position says already.
std::string reason_of(std::string_view what) {
  if (const auto bracket = what.find("] "); bracket != std::string_view::npos) what.remove_prefix(bracket + 2);
  if (const auto column = what.find("column "); column != std::string_view::npos) {
    if (const auto colon = what.find(": ", column); colon != std::string_view::npos) what.remove_prefix(colon + 2);
  }
  return printable(what, 200);
}

/// Builds the value from the parser's events. The library's own builder lets the last of two equal fields win and
/// copies the values of an object whenever its list of fields grows.
class Builder {
 public:
  Builder(std::string_view where, std::string_view text, std::size_t max_fields,
          std::span<const std::string_view> left_out)
      : where_(where), text_(text), max_fields_(max_fields), left_out_(left_out) {}

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(std::int64_t value) { return add(value); }
  bool number_unsigned(std::uint64_t value) { return add(value); }
  bool number_float(double value, const std::string&) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Json::object()); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    if (unkept_depth_ > 0) return true;
    if (std::find(left_out_.begin(), left_out_.end(), name) != left_out_.end()) {
      next_is_unkept_ = true;
      return true;
    }
    const auto& fields = *stack_.back()->get_ptr<const Json::object_t*>();
    if (fields.size() == max_fields_) {
      return fail("more than " + std::to_string(max_fields_) + " fields in one object");
    }
    if (has_field(fields, name)) return fail("the field " + in_quotes(name) + " occurs twice in one object");
    key_ = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) {
    error_ = Error{Error::Kind::Parse, std::string(where_), locate(text_, position > 0 ? position - 1 : 0),
                   reason_of(error.what())};
    return false;
  }

  Result<Json> result(bool complete) {
    if (complete && !error_) return std::move(root_);
    return error_ ? *error_ : Error{Error::Kind::Parse, std::string(where_), {}, "expected one JSON value"};
  }

 private:
  /// Linear while the object is small; then by a set of its names, kept while the object is open.
  bool has_field(const Json::object_t& fields, const std::string& name) {
    if (fields.size() < kFewFields) {
      return std::any_of(fields.begin(), fields.end(), [&](const auto& field) { return field.first == name; });
    }
    names_.resize(stack_.size());
    auto& names = names_.back();
    if (names.empty()) {
      for (const auto& [other, value] : fields) names.insert(other);
    }
    return !names.insert(name).second;
  }

  template <class Value>
  bool add(Value&& value) {
    if (unkept_depth_ > 0 || std::exchange(next_is_unkept_, false)) return true;
    if (values_ == limits::kJsonValues) return too_many();
    put(Json(std::forward<Value>(value)));
    return true;
  }

  bool open(Json value) {
    if (unkept_depth_ > 0 || std::exchange(next_is_unkept_, false)) {
      ++unkept_depth_;
      return true;
    }
    if (stack_.size() == std::size_t{limits::kJsonDepth})
      return fail("nested deeper than " + std::to_string(limits::kJsonDepth) + " levels");
    if (values_ == limits::kJsonValues) return too_many();
    stack_.push_back(put(std::move(value)));
    return true;
  }

  bool too_many() {
    error_ = Error{Error::Kind::Schema,
                   std::string(where_),
                   {},
                   "has more than " + std::to_string(limits::kJsonValues) + " JSON values, the most that is read"};
    return false;
  }

  bool close() {
    if (unkept_depth_ > 0) {
      --unkept_depth_;
      return true;
    }
    if (names_.size() == stack_.size()) names_.pop_back();
    stack_.pop_back();
    return true;
  }

  Json* put(Json value) {
    ++values_;
    if (stack_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    if (auto* items = stack_.back()->get_ptr<Json::array_t*>()) return &items->emplace_back(std::move(value));
    auto& fields = *stack_.back()->get_ptr<Json::object_t*>();
    if (fields.size() == fields.capacity()) {
      Json::object_t wider;
      wider.reserve(std::max<std::size_t>(4, 2 * fields.size()));
      for (auto& [name, old] : fields) wider.emplace_back(name, std::move(old));
      fields.swap(wider);
    }
    return &fields.emplace_back(std::move(key_), std::move(value)).second;
  }

  bool fail(std::string message) {
    std::string pointer;
    for (const Json* open : stack_) {
      if (open == stack_.back()) break;
      pointer += '/';
      if (const auto* items = open->get_ptr<const Json::array_t*>()) {
        pointer += std::to_string(items->size() - 1);
      } else {
        pointer += pointer_token(open->get_ptr<const Json::object_t*>()->back().first);
      }
    }
    error_ = Error{Error::Kind::Schema, at_pointer(where_, pointer), {}, std::move(message)};
    return false;
  }

  std::string_view where_, text_;
  std::size_t max_fields_;
  std::span<const std::string_view> left_out_;  // names of fields
  bool next_is_unkept_ = false;                 // the value that comes now is of such a field
  std::size_t unkept_depth_ = 0;                // open arrays and objects of such a field
  std::size_t values_ = 0;
  Json root_;
  std::vector<Json*> stack_;  // the open arrays and objects; only the innermost one grows, so the others stay in place
  std::vector<std::unordered_set<std::string>> names_;  // of the open objects with many fields, by depth
  std::string key_;
  std::optional<Error> error_;
};

Result<Json> built(Builder builder, std::string_view text) {
  const bool complete = Json::sax_parse(text.data(), text.data() + text.size(), &builder);
  return builder.result(complete);
}

}  // namespace

Result<Json> parse_json(std::string_view where, std::string_view text, std::size_t max_fields) {
  return built(Builder(where, text, max_fields, {}), text);
}

Result<Json> parse_json_without(std::span<const std::string_view> names, std::string_view where,
                                std::string_view text) {
  return built(Builder(where, text, limits::kJsonFields, names), text);
}

}  // namespace unietp
