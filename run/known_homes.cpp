#include "run/known_homes.h"

#include "akb/csv.h"
#include "core/files.h"

namespace unietp {

Result<KnownHomes> read_known_homes(const std::filesystem::path& folder) {
  const auto file = folder / "benchmark-homes.csv";
  const auto text = read_file(file);
  if (!text) return text.error();
  const auto csv = read_csv(file.string(), *text);
  if (!csv.errors.empty()) return csv.errors.front();
  if (csv.header.size() != 2 || csv.header[0].text != "home" || csv.header[1].text != "sha256")
    return Error{Error::Kind::Schema, file.string(), {1, 1}, "expected the columns home,sha256"};
  KnownHomes homes;
  for (const CsvRow& row : csv.rows) {
    if (!homes.emplace(row[0].text, row[1].text).second)
      return Error{Error::Kind::Schema, file.string(), row[0].pos, "has the home " + row[0].text + " twice"};
  }
  return homes;
}

}  // namespace unietp
