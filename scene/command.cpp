#include "scene/command.h"

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "scene/json_reader.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

std::string to_text(const Argument& argument) {
  if (!argument.box) return argument.id;
  std::vector<std::string> ends;
  for (const int end : *argument.box) ends.push_back(std::to_string(end));
  return "[" + join(ends, ", ") + "]";
}

PixelBox box_from_json(JsonReader& reader, const JsonAt& at) {
  PixelBox box{};
  if (reader.items(at) != box.size()) reader.fail(at, "expected [x0, y0, x1, y1]");
  for (std::size_t i = 0; i < box.size() && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    const double pixel = reader.number(item);
    constexpr double kMost = std::numeric_limits<int>::max();
    const bool fits = std::abs(pixel) <= kMost && pixel == std::floor(pixel);
    if (!fits && !reader.error()) reader.fail(item, "expected a whole number of pixels");
    if (fits) box[i] = static_cast<int>(pixel);
  }
  return box;
}

Argument argument_from_json(JsonReader& reader, const JsonAt& at) {
  if (!at.json.is_object()) return {reader.text(at), std::nullopt};
  Argument argument;
  JsonFields fields(reader, at);
  if (const auto f = fields.required("bbox")) argument.box = box_from_json(reader, *f);
  fields.finish();
  return argument;
}

}  // namespace

Command by_ids(const Action& action) {
  Command command{std::string(info(action.type).name), {}};
  for (const std::string& id : action.args) command.args.push_back({id, std::nullopt});
  return command;
}

std::string to_text(const Command& command) {
  std::vector<std::string> args;
  for (const Argument& argument : command.args) args.push_back(to_text(argument));
  return args.empty() ? command.action : command.action + "(" + join(args, ", ") + ")";
}

Json command_to_json(const Command& command) {
  Json args = Json::array();
  for (const Argument& argument : command.args) {
    if (argument.box) {
      args.push_back({{"bbox", *argument.box}});
    } else {
      args.push_back(argument.id);
    }
  }
  return {{"action", command.action}, {"args", std::move(args)}};
}

Result<Command> command_from_json(std::string_view where, const Json& json) {
  JsonReader reader(where);
  const JsonAt root{json};
  JsonFields fields(reader, root);
  Command command;
  if (const auto f = fields.required("action")) command.action = reader.text(*f);
  if (const auto f = fields.required("args")) {
    const std::size_t count = reader.items(*f);
    for (std::size_t i = 0; i < count && !reader.error(); ++i)
      command.args.push_back(argument_from_json(reader, reader.item(*f, i)));
  }
  fields.finish();
  if (reader.error()) return *reader.error();
  return command;
}

}  // namespace unietp
