#include "akb/metadata_json.h"

#include <nlohmann/json.hpp>

#include "core/files.h"

namespace unietp {

Result<nlohmann::json> read_metadata_json(const std::filesystem::path& path) {
  const auto text = read_maybe_gzip(path);
  if (!text) return text.error();
  try {
    return nlohmann::json::parse(*text);
  } catch (const nlohmann::json::parse_error& failure) {
    const std::size_t offset = failure.byte == 0 ? 0 : failure.byte - 1;
    return Error{Error::Kind::Parse, path.string(), locate(*text, std::min(offset, text->size())),
                 "not JSON; expected the file as the simulator's project publishes it"};
  } catch (const nlohmann::json::out_of_range&) {
    return Error{Error::Kind::Parse, path.string(), {}, "a number is too large for a double"};
  }
}

Result<CsvFile> read_metadata_csv(const std::filesystem::path& path) {
  const auto text = read_maybe_gzip(path);
  if (!text) return text.error();
  auto file = read_csv(path.string(), *text);
  if (!file.errors.empty()) return file.errors.front();
  return file;
}

}  // namespace unietp
