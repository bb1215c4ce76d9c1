#include <nlohmann/json.hpp>

#include "evaluation/episode_fields.h"
#include "evaluation/episode_record.h"
#include "record/record_fields.h"

namespace unietp {

std::string timing_line(const TimingRecord& timing) {
  nlohmann::ordered_json json{{"format", "unietp-timing/1"}};
  write_key(json, timing.key);
  json["reply_s"] = timing.reply_s;
  json["attempts"] = timing.attempts;
  json["environment_s"] = timing.environment_s;
  json["error_attempts"] = timing.error_attempts;
  return json.dump();
}

Result<TimingRecord> read_timing(std::string_view where, int line, std::string_view text) {
  TimingRecord timing;
  const auto read = read_line(where, line, text, "unietp-timing/1", [&](JsonReader& reader, JsonFields& fields) {
    timing.key = read_key(reader, fields);
    if (const auto f = fields.required("reply_s")) {
      const std::size_t count = reader.items(*f);
      for (std::size_t i = 0; i < count && !reader.error(); ++i)
        timing.reply_s.push_back(read_not_negative(reader, reader.item(*f, i)));
    }
    if (const auto f = fields.required("attempts")) {
      const std::size_t count = reader.items(*f);
      for (std::size_t i = 0; i < count && !reader.error(); ++i)
        timing.attempts.push_back(read_whole(reader, reader.item(*f, i)));
      if (timing.attempts.size() != timing.reply_s.size()) reader.fail(*f, "expected as many as in \"reply_s\"");
    }
    if (const auto f = fields.required("environment_s")) timing.environment_s = read_not_negative(reader, *f);
    if (const auto f = fields.required("error_attempts")) timing.error_attempts = read_whole(reader, *f);
  });
  if (!read) return read.error();
  return timing;
}

}  // namespace unietp
