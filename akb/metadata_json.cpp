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

Result<NameTexts> read_name_texts(const std::filesystem::path& path) {
  const auto file = read_metadata_csv(path);
  if (!file) return file.error();
  NameTexts texts;
  for (const auto& row : file->rows) {
    const bool complete = row.size() >= 2 && !row.front().text.empty();
    if (!complete || !texts.emplace(row[0].text, row[1].text).second)
      return Error{Error::Kind::Schema, path.string(), row.front().pos, "expected a name of its own and what it means"};
  }
  return texts;
}

}  // namespace unietp
