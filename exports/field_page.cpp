#include "exports/field_page.h"

#include <algorithm>
#include <set>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/text.h"
#include "scene/json_parse.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kHead =
    "# Fields\n"
    "\n"
    "Written by `unietp schemas --page` from `data/schemas/`; a test holds it to them, and others hold real files to "
    "the\n"
    "schemas. [files.md](files.md) and [exports.md](exports.md) say what the files are for. `?` marks a field that may "
    "be\n"
    "left out, `[]` an item of a list, `*` a field whose name is free.\n";

std::string in_a_cell(const std::string& text) { return replace_all(replace_all(text, "|", "\\|"), "\n", " "); }

/// A part of a schema; an empty object when it is not there.
const Json& part_of(const Json& schema, const char* name) {
  static const Json kNone = Json::object();
  const auto found = schema.find(name);
  return found == schema.end() ? kNone : *found;
}

std::string code(const std::string& text) { return "`" + text + "`"; }

/// "an action's #argument": where a reference leads.
std::string target_name(const std::string& reference) {
  const auto hash = reference.find('#');
  const std::string file = replace_all(reference.substr(0, hash), ".schema.json", "");
  const std::string definition = reference.substr(reference.rfind('/') + 1);
  if (definition.starts_with(file) && hash + 1 == reference.size()) return "[" + file + "](#" + file + ")";
  return file.empty() ? "*" + definition + "*" : "*" + definition + "* of [" + file + "](#" + file + ")";
}

std::string values(const Json& list) {
  std::vector<std::string> texts;
  for (const Json& value : list) texts.push_back(code(value.is_string() ? value.get<std::string>() : value.dump()));
  return join(texts, ", ");
}

std::string type_of(const Json& schema) {
  if (schema.contains("$ref")) return target_name(schema["$ref"]);
  if (schema.contains("const")) return values(Json::array({schema["const"]}));
  if (schema.contains("enum")) return values(schema["enum"]);
  if (schema.contains("anyOf")) {
    std::vector<std::string> kinds;
    for (const Json& one : schema["anyOf"]) kinds.push_back(type_of(one));
    return join(kinds, " or ");
  }
  const std::string type = schema.value("type", "anything");
  if (type != "array") return type == "string" ? "text" : type;
  std::string size;
  if (schema.contains("maxItems") && schema.value("minItems", 0) == schema["maxItems"])
    size = std::to_string(schema["maxItems"].get<int>()) + " of ";
  return "list of " + size + (schema.contains("items") ? type_of(schema["items"]) : "anything");
}

void add_fields(const Json& schema, const std::string& path, std::string& rows);

void add_row(const std::string& name, const Json& schema, bool required, std::string& rows) {
  rows += "| " + code(name) + (required ? "" : " ?") + " | " + in_a_cell(type_of(schema)) + " | " +
          in_a_cell(schema.value("description", "")) + " |\n";
  add_fields(schema, name, rows);
}

void add_fields(const Json& schema, const std::string& path, std::string& rows) {
  const Json required = schema.value("required", Json::array());
  const std::string before = path.empty() ? "" : path + ".";
  for (const auto& [name, field] : part_of(schema, "properties").items())
    add_row(before + name, field, std::find(required.begin(), required.end(), name) != required.end(), rows);
  if (schema.contains("additionalProperties") && schema["additionalProperties"].is_object())
    add_row(before + "*", schema["additionalProperties"], false, rows);
  if (schema.contains("items") && schema["items"].is_object()) add_fields(schema["items"], path + "[]", rows);
}

/// The fields of what has some, the type of what has none.
std::string table(const Json& schema) {
  std::string rows;
  add_fields(schema, "", rows);
  return rows.empty() ? "\n" + type_of(schema) + "\n" : "\n| field | type | meaning |\n|---|---|---|\n" + rows;
}

std::string section(const std::string& name, const Json& schema) {
  std::string text =
      "\n## " + name + "\n\n" + schema.value("title", "") + ". " + schema.value("description", "") + "\n";
  text += table(schema);
  for (const auto& [definition, part] : part_of(schema, "$defs").items()) {
    text += "\n### " + name + ": " + definition + "\n";
    const auto about = part.value("description", "");
    if (!about.empty()) text += "\n" + about + "\n";
    text += table(part);
  }
  return text;
}

}  // namespace

Result<std::string> field_page(const fs::path& schemas) {
  constexpr std::string_view kEnd = ".schema.json";
  std::set<fs::path> files;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(schemas, failed)) {
    if (entry.path().filename().string().ends_with(kEnd)) files.insert(entry.path());
  }
  if (failed) return Error{Error::Kind::Io, schemas.string(), {}, "cannot be read: " + failed.message()};
  std::string page(kHead);
  for (const auto& file : files) {
    const auto text = read_file(file);
    if (!text) return text.error();
    const auto schema = parse_json(file.string(), *text);
    if (!schema) return schema.error();
    const std::string name = file.filename().string();
    page += section(name.substr(0, name.size() - kEnd.size()), *schema);
  }
  return page;
}

}  // namespace unietp
