#include "json_mutator.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/text.h"

namespace unietp::fuzz {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<Json>& extreme_numbers() {
  using Double = std::numeric_limits<double>;
  constexpr std::int64_t kDoubleExact = std::int64_t{1} << 53;
  static const std::vector<Json> numbers{0,
                                         -0.0,
                                         1,
                                         -1,
                                         0.5,
                                         64,
                                         255,
                                         65536,
                                         std::numeric_limits<int>::max(),
                                         std::numeric_limits<int>::min(),
                                         std::int64_t{1} << 32,
                                         kDoubleExact,
                                         kDoubleExact + 1,
                                         std::numeric_limits<std::int64_t>::max(),
                                         std::numeric_limits<std::int64_t>::min(),
                                         std::numeric_limits<std::uint64_t>::max(),
                                         Double::max(),
                                         Double::lowest(),
                                         Double::min(),
                                         Double::denorm_min(),
                                         Double::epsilon(),
                                         1e-9,
                                         1e9};
  return numbers;
}

const std::vector<std::string>& odd_texts() {
  static const std::vector<std::string> texts{"",
                                              " ",
                                              ".",
                                              "..",
                                              "../../x",
                                              "/",
                                              "-",
                                              "a/b",
                                              std::string(1, '\0'),
                                              "\n",
                                              "\x1b",
                                              "null",
                                              "true",
                                              "0",
                                              "-1",
                                              "1e999",
                                              "NaN",
                                              "?x",
                                              "(and)",
                                              "{}",
                                              "[]",
                                              "%s%n",
                                              "\u00e4",
                                              "\u202e",
                                              "Mug",
                                              "ai2thor-",
                                              "mug_1 (2)",
                                              "_1",
                                              std::string(300, 'a')};
  return texts;
}

/// The values of a tree, the root first.
void collect(Json& value, std::vector<Json*>& into) {
  into.push_back(&value);
  if (!value.is_structured()) return;
  for (Json& child : value) collect(child, into);
}

class JsonChange {
 public:
  JsonChange(Json& tree, const Json& donor, Rng& rng) : tree_(tree), donor_(donor), rng_(rng) {}

  void make() {
    std::vector<Json*> all;
    collect(tree_, all);
    Json& value = *rng_.pick(all);
    std::vector<Json*> lists;
    for (Json* one : all) {
      if (one->is_structured() && !one->empty()) lists.push_back(one);
    }
    constexpr std::uint64_t kOfLists = 5;
    switch (rng_.below(lists.empty() ? kOfLists : 2 * kOfLists)) {
      case 0:
        return replace_number(value);
      case 1:
        return replace_text(value);
      case 2:
        return replace_from(tree_, value);
      case 3:
        return replace_from(donor_, value);
      case 4:
        return wrap(value);
      case 5:
        return drop(*rng_.pick(lists));
      case 6:
        return repeat(*rng_.pick(lists));
      case 7:
        return swap(*rng_.pick(lists));
      case 8:
        return rename(*rng_.pick(lists), *rng_.pick(lists));
      default:
        return lengthen(*rng_.pick(lists));
    }
  }

 private:
  void replace_number(Json& value) {
    if (!value.is_number() || rng_.chance(0.5)) {
      value = rng_.pick(extreme_numbers());
      return;
    }
    const double number = value.get<double>();
    const std::array<double, 6> near{-number,    number + 1,   number - 1,
                                     number * 2, number * 1e3, std::nextafter(number, number + 1)};
    const double changed = rng_.pick(near);
    value = std::isfinite(changed) ? Json(changed) : Json(0);
  }

  void replace_text(Json& value) {
    if (!value.is_string() || rng_.chance(0.5)) {
      value = rng_.pick(odd_texts());
      return;
    }
    const std::string text = value.get<std::string>() + rng_.pick(odd_texts());
    value = rng_.chance(0.5) ? text : text.substr(rng_.below(text.size() + 1));
  }

  /// With one of its own kind more often than not, so that names and references of one place come to another.
  void replace_from(const Json& source, Json& value) {
    Json copy = source;
    std::vector<Json*> all, alike;
    collect(copy, all);
    for (Json* one : all) {
      if (one->type() == value.type()) alike.push_back(one);
    }
    value = Json(*rng_.pick(alike.empty() || rng_.chance(0.2) ? all : alike));
  }

  void wrap(Json& value) {
    switch (rng_.below(4)) {
      case 0:
        value = nullptr;
        return;
      case 1:
        value = rng_.chance(0.5) ? Json::array() : Json::object();
        return;
      case 2:
        value = !(value.is_boolean() && value.get<bool>());
        return;
      default:
        for (std::uint64_t depth = rng_.chance(0.2) ? 70 : 1; depth > 0; --depth) {
          Json inner = std::move(value);
          value = Json::array();
          value.push_back(std::move(inner));
        }
    }
  }

  void drop(Json& list) {
    const auto at = static_cast<std::ptrdiff_t>(rng_.below(list.size()));
    list.erase(std::next(list.begin(), at));
  }

  /// Also a field of the same name twice, which a JSON text can have.
  void repeat(Json& list) {
    if (auto* fields = list.get_ptr<Json::object_t*>()) {
      const Json::object_t::value_type field =
          *std::next(fields->begin(), static_cast<std::ptrdiff_t>(rng_.below(fields->size())));
      fields->push_back(field);
    } else {
      list.push_back(Json(list[rng_.below(list.size())]));
    }
  }

  void swap(Json& list) {
    Json& one = *std::next(list.begin(), static_cast<std::ptrdiff_t>(rng_.below(list.size())));
    Json& other = *std::next(list.begin(), static_cast<std::ptrdiff_t>(rng_.below(list.size())));
    if (&one != &other) one.swap(other);
  }

  void rename(Json& list, const Json& other) {
    if (!list.is_object()) return;
    const auto at = std::next(list.begin(), static_cast<std::ptrdiff_t>(rng_.below(list.size())));
    Json value = *at;
    const bool borrow = other.is_object() && rng_.chance(0.7);
    const std::string name = borrow
                                 ? std::next(other.begin(), static_cast<std::ptrdiff_t>(rng_.below(other.size()))).key()
                                 : rng_.pick(odd_texts());
    list.erase(at);
    list[name] = std::move(value);
  }

  void lengthen(Json& list) {
    constexpr std::size_t kItems = 100;
    if (!list.is_array()) return;
    const std::size_t before = list.size();
    while (list.size() < before + kItems) list.push_back(Json(list[rng_.below(before)]));
  }

  Json& tree_;
  const Json& donor_;
  Rng& rng_;
};

std::optional<std::string> changed(std::string_view text, const Json& donor, Rng& rng) {
  Json tree = Json::parse(text, nullptr, false);
  if (tree.is_discarded()) return std::nullopt;
  for (std::uint64_t changes = 1 + rng.below(4); changes > 0; --changes) JsonChange(tree, donor, rng).make();
  return tree.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The text as a value, or one of its lines that is one; null when there is none.
Json donated(std::string_view text, Rng& rng) {
  Json whole = Json::parse(text, nullptr, false);
  if (!whole.is_discarded()) return whole;
  const auto lines = split(text, '\n');
  Json line = Json::parse(rng.pick(lines), nullptr, false);
  return line.is_discarded() ? Json() : line;
}

}  // namespace

std::optional<std::string> mutate_json(std::string_view text, std::string_view donor, Rng rng) {
  const Json other = donated(donor, rng);
  if (auto whole = changed(text, other, rng)) return whole;
  auto lines = split(text, '\n');
  const std::size_t first = rng.below(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::string& line = lines[(first + i) % lines.size()];
    auto again = line.empty() ? std::nullopt : changed(line, other, rng);
    if (!again) continue;
    line = std::move(*again);
    return join(lines, "\n");
  }
  return std::nullopt;
}

}  // namespace unietp::fuzz
