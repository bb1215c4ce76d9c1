#include "annotator/everyday_names.h"

#include <algorithm>
#include <array>

#include "akb/row_reader.h"
#include "core/files.h"

namespace unietp {
namespace {

/// In the order of the enum.
constexpr std::array<std::string_view, 5> kNameUses{"has_lid", "plant", "heats_food", "puts_away", "has_top"};

/// The rows of a table by name, of which a row may have several. `cells_of` reads what else stands in a row.
template <class Row, class CellsOf>
std::map<std::string, Row, std::less<>> rows_by_name(const std::filesystem::path& path,
                                                     const std::vector<std::string>& columns, const CellsOf& cells_of,
                                                     std::vector<Error>& errors) {
  std::map<std::string, Row, std::less<>> rows;
  const auto text = read_file(path);
  if (!text) {
    errors.push_back(text.error());
    return rows;
  }
  RowReader row(path.string(), *text, columns, errors);
  for (const auto& cells : row.rows()) {
    row.at(cells);
    row.required("name");
    const auto names = row.list("name");
    const Row read = cells_of(row);
    row.required("source");
    for (const std::string& name : names)
      if (row.sound() && !rows.emplace(name, read).second) row.fail("name", "'" + name + "' stands twice");
  }
  return rows;
}

}  // namespace

EverydayNames::EverydayNames(std::map<std::string, Forms, std::less<>> names,
                             std::map<std::string, Use, std::less<>> rare,
                             std::map<std::string, Others, std::less<>> look_alikes,
                             std::map<std::string, Uses, std::less<>> uses)
    : names_(std::move(names)), rare_(std::move(rare)), look_alikes_(std::move(look_alikes)), uses_(std::move(uses)) {}

std::string_view EverydayNames::of(std::string_view name, English english) const {
  const auto found = names_.find(name);
  if (found == names_.end()) return "";
  return english == English::Us ? found->second.us : found->second.gb;
}

bool EverydayNames::is_said(std::string_view synonym, English english) const {
  const auto found = rare_.find(synonym);
  if (found == rare_.end()) return true;
  return english == English::Us ? found->second.us : found->second.gb;
}

std::span<const std::string> EverydayNames::look_alikes(std::string_view name) const {
  const auto found = look_alikes_.find(name);
  return found == look_alikes_.end() ? std::span<const std::string>() : found->second;
}

bool EverydayNames::is_word_for(std::string_view word, NameUse use) const {
  const auto found = uses_.find(word);
  return found != uses_.end() && std::find(found->second.begin(), found->second.end(), use) != found->second.end();
}

bool EverydayNames::ends_as(std::string_view name, NameUse use) const {
  return std::any_of(uses_.begin(), uses_.end(), [&](const auto& row) {
    return name.ends_with(row.first) && std::find(row.second.begin(), row.second.end(), use) != row.second.end();
  });
}

EverydayNames read_everyday_names(const std::filesystem::path& folder, std::vector<Error>& errors) {
  auto names = rows_by_name<EverydayNames::Forms>(
      folder / "everyday_names.csv", {"name", "us", "gb", "source"},
      [](RowReader& row) {
        return EverydayNames::Forms{row.required("us"), row.required("gb")};
      },
      errors);
  auto rare = rows_by_name<EverydayNames::Use>(
      folder / "rare_names.csv", {"name", "us", "gb", "source"},
      [](RowReader& row) {
        return EverydayNames::Use{row.flag("us"), row.flag("gb")};
      },
      errors);
  auto look_alikes = rows_by_name<EverydayNames::Others>(
      folder / "look_alikes.csv", {"name", "others", "source"}, [](RowReader& row) { return row.list("others"); },
      errors);
  auto uses = rows_by_name<EverydayNames::Uses>(
      folder / "name_uses.csv", {"name", "uses", "source"},
      [](RowReader& row) {
        static const std::vector<std::string> known(kNameUses.begin(), kNameUses.end());
        EverydayNames::Uses read;
        for (const std::string& word : row.all_of("uses", known, "use"))
          read.push_back(static_cast<NameUse>(std::find(known.begin(), known.end(), word) - known.begin()));
        return read;
      },
      errors);
  return {std::move(names), std::move(rare), std::move(look_alikes), std::move(uses)};
}

}  // namespace unietp
