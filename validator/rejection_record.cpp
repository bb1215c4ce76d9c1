#include <nlohmann/json.hpp>

#include "validator/record_fields.h"
#include "validator/task_record.h"

namespace unietp {

Result<RejectionRecord> read_rejection(std::string_view where, int line, std::string_view text) {
  const auto json = parse_json_line(where, line, text);
  if (!json) return json.error();
  const auto name = line_name(where, line);
  JsonReader reader(name);
  const JsonAt root{*json};
  JsonFields fields(reader, root);
  RejectionRecord rejection;
  read_format(reader, fields, "unietp-rejection/1");
  if (const auto f = fields.required("slot")) rejection.slot = read_whole(reader, *f);
  if (const auto f = fields.required("attempt")) rejection.attempt = read_whole(reader, *f);
  if (const auto f = fields.required("template")) rejection.template_name = reader.text(*f);
  if (const auto f = fields.required("simulator")) rejection.simulator = reader.text(*f);
  if (const auto f = fields.required("split")) rejection.split = reader.text(*f);
  if (const auto f = fields.required("stage")) rejection.stage = reader.text(*f);
  if (const auto f = fields.required("reason")) rejection.reason = reader.text(*f);
  if (const auto f = fields.required("detail")) rejection.detail = text_or_empty(reader, *f);
  fields.finish();
  if (reader.error()) return *reader.error();
  return rejection;
}

}  // namespace unietp
