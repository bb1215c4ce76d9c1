#include "akb/csv.h"

#include <algorithm>
#include <optional>

namespace unietp {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Walks the bytes once and keeps line and column, so that no position has to be computed afterwards.
class Reader {
 public:
  Reader(std::string_view where, std::string_view text) : where_(where), text_(text) {
    if (text_.starts_with(kByteOrderMark)) fail({1, 1}, "byte order mark; expected UTF-8 without one"), at_ = 3;
  }

  bool done() const { return at_ >= text_.size(); }

  /// One record of probably so many fields, or nothing when it was malformed (reported, and skipped to the next line).
  std::optional<CsvRow> record(std::size_t fields) {
    CsvRow row;
    row.reserve(fields);
    if (at_line_end()) {
      fail(pos(), "empty line; expected a row of fields");
      take_line_end();
      return std::nullopt;
    }
    for (;;) {
      const SourcePos start = pos();
      auto text = peek() == '"' ? quoted(start) : plain();
      if (!text) return skip_line();
      row.push_back({std::move(*text), start});
      if (done() || at_line_end()) break;
      take();  // the comma
    }
    take_line_end();
    return row;
  }

  void fail(SourcePos at, std::string message) {
    errors_.push_back({Error::Kind::Parse, std::string(where_), at, std::move(message)});
  }
  std::vector<Error> take_errors() { return std::move(errors_); }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  SourcePos pos() const { return {line_, column_}; }
  static bool ends_plain_run(char c) { return c == ',' || c == '\n' || c == '\r' || c == '"'; }
  bool at_line_end() const { return !done() && (peek() == '\n' || (peek() == '\r' && peek(1) == '\n')); }
  void take() {
    if (text_[at_++] == '\n') {
      ++line_;
      column_ = 1;
    } else {
      ++column_;
    }
  }
  void take_line_end() {
    if (!done() && peek() == '\r') take();
    if (!done()) take();
  }
  std::optional<CsvRow> skip_line() {
    while (!done() && peek() != '\n') take();
    take_line_end();
    return std::nullopt;
  }

  std::optional<std::string> plain() {
    std::size_t end = at_;
    while (end < text_.size() && !ends_plain_run(text_[end])) ++end;
    const std::string_view field = text_.substr(at_, end - at_);
    at_ = end;
    column_ += static_cast<int>(field.size());
    if (done() || peek() == ',' || at_line_end()) return std::string(field);
    fail(pos(), peek() == '"'
                    ? "quote inside an unquoted field; expected the whole field in quotes and the quote doubled"
                    : "carriage return without line feed; expected LF or CRLF");
    return std::nullopt;
  }

  std::optional<std::string> quoted(SourcePos start) {
    std::string field;
    take();
    while (!done()) {
      if (peek() != '"') {
        field += peek();
        take();
      } else if (peek(1) == '"') {
        field += '"';
        take();
        take();
      } else {
        take();
        if (done() || peek() == ',' || at_line_end()) return field;
        fail(pos(), "text after a closing quote; expected a comma or the end of the line");
        return std::nullopt;
      }
    }
    fail(start, "quoted field without end; expected a closing quote");
    return std::nullopt;
  }

  std::string_view where_, text_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
  std::vector<Error> errors_;
};

bool sound_header(Reader& reader, const CsvRow& header) {
  bool sound = true;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const auto same = [&](const CsvCell& other) { return other.text == header[i].text; };
    if (header[i].text.empty()) {
      reader.fail(header[i].pos, "column without a name; expected one");
      sound = false;
    } else if (std::any_of(header.begin(), header.begin() + static_cast<std::ptrdiff_t>(i), same)) {
      reader.fail(header[i].pos, "column '" + header[i].text + "' is duplicated; expected each once");
      sound = false;
    }
  }
  return sound;
}

}  // namespace

CsvFile read_csv(std::string_view where, std::string_view text) {
  CsvFile file;
  Reader reader(where, text);
  if (reader.done()) {
    reader.fail({1, 1}, "no header; expected a line of column names");
  } else if (auto header = reader.record(1); header && sound_header(reader, *header)) {
    file.header = std::move(*header);
    while (!reader.done()) {
      auto row = reader.record(file.header.size());
      if (!row) continue;
      if (row->size() == file.header.size()) {
        file.rows.push_back(std::move(*row));
      } else {
        reader.fail(row->front().pos, std::to_string(row->size()) + " fields; expected " +
                                          std::to_string(file.header.size()) + " as in the header");
      }
    }
  }
  file.errors = reader.take_errors();
  return file;
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos && !text.starts_with(kByteOrderMark))
    return std::string(text);
  std::string field = "\"";
  for (const char c : text) {
    if (c == '"') field += '"';
    field += c;
  }
  return field + '"';
}

std::string csv_line(const std::vector<std::string>& fields) {
  if (fields.size() == 1 && fields[0].empty()) return "\"\"\n";  // bare, it would be an empty line
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i != 0) line += ',';
    line += csv_field(fields[i]);
  }
  return line + '\n';
}

}  // namespace unietp
