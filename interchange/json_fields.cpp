#include "interchange/json_fields.h"

#include <nlohmann/json.hpp>

#include "core/limits.h"
#include "scene/json_parse.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::optional<JsonAt> LooseFields::find(std::string_view name) const {
  const auto* fields = at_->json.get_ptr<const Json::object_t*>();
  if (fields == nullptr) {
    reader_->fail(*at_, "expected an object with the field " + std::string(name));
    return std::nullopt;
  }
  for (const auto& [key, value] : *fields) {
    if (key == name && !value.is_null()) return JsonAt{value, at_, key, 0};
  }
  return std::nullopt;
}

std::optional<JsonAt> LooseFields::need(std::string_view name) const {
  auto field = find(name);
  if (!field) reader_->fail(*at_, "the field \"" + std::string(name) + "\" is missing");
  return field;
}

std::string LooseFields::text(std::string_view name) const {
  const auto field = find(name);
  if (!field) return {};
  const auto* value = field->json.get_ptr<const Json::string_t*>();
  if (value != nullptr) return *value;
  reader_->fail(*field, "expected a string");
  return {};
}

double LooseFields::number(std::string_view name, double absent) const {
  const auto field = find(name);
  return field ? reader_->number(*field) : absent;
}

bool LooseFields::flag(std::string_view name) const {
  const auto field = find(name);
  return field && reader_->boolean(*field);
}

std::vector<std::string> LooseFields::texts(std::string_view name) const {
  const auto field = find(name);
  return field ? reader_->texts(*field) : std::vector<std::string>{};
}

Vec3 vector_at(JsonReader& reader, const JsonAt& at) {
  if (!at.json.is_object()) return reader.vec3(at);
  const LooseFields fields(reader, at);
  Vec3 value = Vec3::Zero();
  int axis = 0;
  for (const char* name : {"x", "y", "z"}) {
    if (const auto field = fields.need(name)) value[axis] = reader.number(*field);
    ++axis;
  }
  return value;
}

Result<Done> each_json_value(std::string_view where, std::string_view text,
                             const std::function<std::optional<Error>(const JsonAt&, int line)>& take) {
  const auto first = text.find_first_not_of(" \t\r\n");
  {
    const auto whole = parse_json(where, text, limits::kJsonTableFields);
    if (whole) {
      if (auto error = take(JsonAt{*whole}, 0)) return *std::move(error);
      return Done{};
    }
    const auto end_of_first = text.find('\n', first == std::string_view::npos ? 0 : first);
    const auto line = end_of_first == std::string_view::npos ? std::string_view() : text.substr(0, end_of_first);
    if (line.empty() || !parse_json(where, line, limits::kJsonTableFields)) return whole.error();
  }
  int line = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view one = text.substr(at, end - at);
    at = end + 1;
    ++line;
    if (one.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    const auto value = parse_json(where, one, limits::kJsonTableFields);
    if (!value) {
      Error error = value.error();
      if (error.pos.line > 0) error.pos.line = line;
      return error;
    }
    if (auto error = take(JsonAt{*value}, line)) return *std::move(error);
  }
  return Done{};
}

void keep_to_a_file(JsonReader& reader, const JsonAt& home, const std::vector<SourceScene>& scenes) {
  if (scenes.size() > limits::kHomesInFile)
    reader.fail(home, "more than " + std::to_string(limits::kHomesInFile) + " homes in one file");
  std::size_t objects = 0;
  for (const SourceScene& scene : scenes) objects += scene.objects.size();
  if (objects > limits::kObjectsInFile)
    reader.fail(home, "more than " + std::to_string(limits::kObjectsInFile) + " objects in one file");
}

}  // namespace unietp
