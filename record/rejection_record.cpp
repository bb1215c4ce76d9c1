#include <nlohmann/json.hpp>

#include "record/record_fields.h"
#include "record/task_record.h"

namespace unietp {

Result<RejectionRecord> read_rejection(std::string_view where, int line, std::string_view text) {
  RejectionRecord rejection;
  const auto read = read_line(where, line, text, "unietp-rejection/1", [&](JsonReader& reader, JsonFields& fields) {
    if (const auto f = fields.required("slot")) rejection.slot = read_whole(reader, *f);
    if (const auto f = fields.required("attempt")) rejection.attempt = read_whole(reader, *f);
    if (const auto f = fields.required("template")) rejection.template_name = reader.plain_name(*f);
    if (const auto f = fields.required("simulator")) rejection.simulator = reader.plain_name(*f);
    if (const auto f = fields.required("split")) rejection.split = reader.plain_name(*f);
    if (const auto f = fields.required("stage")) rejection.stage = reader.text(*f);
    if (const auto f = fields.required("reason")) rejection.reason = reader.text(*f);
    if (const auto f = fields.required("detail")) rejection.detail = text_or_empty(reader, *f);
  });
  if (!read) return read.error();
  return rejection;
}

}  // namespace unietp
