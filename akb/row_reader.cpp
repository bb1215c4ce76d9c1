#include "akb/row_reader.h"

#include <algorithm>
#include <charconv>

#include "core/text.h"

namespace unietp {
namespace {

/// "; did you mean 'fridge'?" or nothing.
std::string hint(std::string_view name, const std::vector<std::string>& candidates) {
  const auto near = nearest_name(name, candidates);
  return near.empty() ? std::string() : "; did you mean '" + near + "'?";
}

std::string accepted(std::string_view noun, const std::vector<std::string>& names) {
  if (names.size() > 30) return "; expected a " + std::string(noun) + " of the category table";
  return "; expected one of " + join(names, ", ");
}

}  // namespace

RowReader::RowReader(std::string where, std::string_view text, const std::vector<std::string>& columns,
                     std::vector<Error>& errors)
    : where_(std::move(where)), file_(read_csv(where_, text)), errors_(errors) {
  errors_.insert(errors_.end(), file_.errors.begin(), file_.errors.end());
  for (std::size_t i = 0; i < file_.header.size(); ++i) {
    const auto& cell = file_.header[i];
    header_.push_back(cell.text);
    if (std::find(columns.begin(), columns.end(), cell.text) == columns.end()) {
      errors_.push_back(
          {Error::Kind::Schema, where_, cell.pos,
           "unknown column '" + cell.text + "'; expected " + join(columns, ", ") + hint(cell.text, columns)});
    }
  }
  bool complete = true;
  for (const auto& column : columns) {
    if (std::find(header_.begin(), header_.end(), column) != header_.end()) continue;
    complete = false;
    if (!file_.header.empty()) {
      errors_.push_back(
          {Error::Kind::Schema, where_, {1, 1}, "missing column '" + column + "'; expected " + join(columns, ", ")});
    }
  }
  if (!complete) file_.rows.clear();
}

void RowReader::at(const CsvRow& row) {
  row_ = &row;
  sound_ = true;
}

const CsvCell& RowReader::cell(std::string_view column) const {
  std::size_t at = next_;
  while (header_[at] != column) at = (at + 1) % header_.size();
  next_ = (at + 1) % header_.size();
  return (*row_)[at];
}
const std::string& RowReader::text(std::string_view column) const { return cell(column).text; }

void RowReader::fail(std::string_view column, std::string message) {
  errors_.push_back({Error::Kind::Schema, where_, cell(column).pos, std::move(message)});
  sound_ = false;
}

std::string RowReader::required(std::string_view column) {
  if (text(column).empty()) fail(column, "empty " + std::string(column) + "; expected a text");
  return text(column);
}

bool RowReader::flag(std::string_view column) {
  const auto& value = text(column);
  if (value != "true" && value != "false") {
    fail(column, "bad " + std::string(column) + " '" + value + "'; expected true or false");
  }
  return value == "true";
}

double RowReader::number(std::string_view column, double low, double high, bool low_allowed) {
  const auto& value = text(column);
  double number = 0;
  const auto [end, code] = std::from_chars(value.data(), value.data() + value.size(), number);
  const bool reads = code == std::errc() && end == value.data() + value.size();
  if (!reads || !(low_allowed ? number >= low : number > low) || !(number <= high)) {
    fail(column, "bad " + std::string(column) + " '" + value + "'; expected a number " + (low_allowed ? ">= " : "> ") +
                     number_text(low) + " and <= " + number_text(high));
  }
  return number;
}

int RowReader::integer(std::string_view column, int low) {
  const auto& value = text(column);
  int number = 0;
  const auto [end, code] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (code != std::errc() || end != value.data() + value.size() || number < low) {
    fail(column, "bad " + std::string(column) + " '" + value + "'; expected a whole number >= " + std::to_string(low));
  }
  return number;
}

std::vector<std::string> RowReader::list(std::string_view column) {
  if (text(column).empty()) return {};
  auto items = split(text(column), '|');
  for (const auto& item : items) {
    if (item.empty() || trim(item) != item) {
      fail(column, "bad " + std::string(column) + " '" + text(column) + "'; expected words joined by |");
      break;
    }
  }
  return items;
}

std::string RowReader::one_of(std::string_view column, const std::vector<std::string>& names, std::string_view noun) {
  const auto& value = text(column);
  if (std::find(names.begin(), names.end(), value) == names.end()) {
    fail(column, "unknown " + std::string(noun) + " '" + value + "'" + accepted(noun, names) + hint(value, names));
  }
  return value;
}

std::string RowReader::one_of(std::string_view column, const NameTable& names, std::string_view noun) {
  const auto& value = text(column);
  return names.contains(value) ? value : one_of(column, names.names(), noun);
}

std::vector<std::string> RowReader::all_of(std::string_view column, const std::vector<std::string>& names,
                                           std::string_view noun) {
  auto items = list(column);
  for (const auto& item : items) {
    if (std::find(names.begin(), names.end(), item) == names.end()) {
      fail(column, "unknown " + std::string(noun) + " '" + item + "'" + accepted(noun, names) + hint(item, names));
    }
  }
  return items;
}

Source RowReader::source(std::string_view source_column, std::string_view confidence_column) {
  Source source{text(source_column), 1};
  if (!well_formed_source(source.source)) {
    fail(source_column, (source.source.empty() ? "missing source" : "bad source '" + source.source + "'") +
                            "; expected metadata:<file>, derived:<rule>, llm:<model>, override:<file> or curated");
  }
  source.confidence = number(confidence_column, 0, 1, false);
  return source;
}

}  // namespace unietp
