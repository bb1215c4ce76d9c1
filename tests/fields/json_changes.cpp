#include "json_changes.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

class Changes {
 public:
  explicit Changes(const KnownValues& values) : values_(values) {}

  void visit(const Json& json, const std::string& field, const Pointer& place) {
    if (json.is_object()) return visit_object(json, field, place);
    if (json.is_array()) return visit_list(json, field, place);
    if (json.is_number()) visit_number(json, field, place);
    if (json.is_boolean()) replace(field, "turned round", place, !json.get<bool>());
    if (json.is_string()) visit_text(json, field, place);
  }

  std::vector<JsonChange> take() { return std::move(changes_); }

 private:
  void add(const std::string& field, const char* how, const Pointer& place, std::function<void(Json&)> apply) {
    changes_.push_back({field, how, place, std::move(apply)});
  }

  void replace(const std::string& field, const char* how, const Pointer& place, Json value) {
    add(field, how, place, [place, value = std::move(value)](Json& json) { json[place] = value; });
  }

  void visit_object(const Json& json, const std::string& field, const Pointer& place) {
    for (const auto& [name, value] : json.items()) {
      const std::string own = field.empty() ? name : field + "." + name;
      visit(value, own, place / name);
      add(own, "dropped", place / name, [place, name = name](Json& whole) { whole[place].erase(name); });
    }
    add(field, "a field more", place, [place](Json& whole) { whole[place]["surprise"] = 1; });
  }

  void visit_list(const Json& json, const std::string& field, const Pointer& place) {
    const std::string own = field + "[]";
    for (std::size_t i = 0; i < json.size(); ++i) {
      visit(json[i], own, place / i);
      add(own, "dropped", place / i, [place, i](Json& whole) { whole[place].erase(i); });
      add(own, "doubled", place / i, [place, i](Json& whole) {
        auto& list = whole[place];
        list.insert(list.begin() + static_cast<std::ptrdiff_t>(i), Json(list[i]));
      });
      if (i + 1 < json.size() && json[i] != json[i + 1])
        add(own, "swapped", place / i, [place, i](Json& whole) { std::swap(whole[place][i], whole[place][i + 1]); });
    }
  }

  void visit_number(const Json& json, const std::string& field, const Pointer& place) {
    const auto set = [&](const char* how, auto value) { replace(field, how, place, value); };
    if (json.is_number_integer()) {
      const auto value = json.get<std::int64_t>();
      set("plus one", value + 1);
      if (value != 0) set("twice", value * 2);
      if (value != 0) set("other sign", -value);
      return;
    }
    const auto value = json.get<double>();
    set("plus one", value + 1);
    if (value != 0) set("twice", value * 2);
    if (value != 0) set("other sign", -value);
  }

  void visit_text(const Json& json, const std::string& field, const Pointer& place) {
    replace(field, "a letter more", place, json.get<std::string>() + "x");
    const auto known = values_.find(field);
    if (known == values_.end()) return;
    // Another one each time, so that the values of a field are all put somewhere.
    const auto& all = known->second;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Json& other = all[(next_ + i) % all.size()];
      if (other == json) continue;
      replace(field, "another value", place, other);
      next_ += i + 1;
      return;
    }
  }

  const KnownValues& values_;
  std::size_t next_ = 0;
  std::vector<JsonChange> changes_;
};

}  // namespace

void collect_values(const Json& json, const std::string& field, KnownValues& values) {
  if (json.is_object()) {
    for (const auto& [name, value] : json.items())
      collect_values(value, field.empty() ? name : field + "." + name, values);
  } else if (json.is_array()) {
    for (const Json& item : json) collect_values(item, field + "[]", values);
  } else if (json.is_string()) {
    auto& own = values[field];
    if (own.size() < 200 && std::find(own.begin(), own.end(), json) == own.end()) own.push_back(json);
  }
}

std::vector<JsonChange> changes_of_json(const Json& json, const KnownValues& values) {
  Changes changes(values);
  changes.visit(json, "", Pointer());
  return changes.take();
}

}  // namespace unietp
