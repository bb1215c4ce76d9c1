#include "record/line_index.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace unietp {

Result<LineIndex> LineIndex::open(const std::filesystem::path& folder, const std::string& name, FileNames names,
                                  const std::function<Result<Done>(const FileLine&)>& each) {
  auto lines = LineFile::open(folder, name, names);
  if (!lines) return lines.error();
  auto file = open_regular_file(folder, name);
  if (!file) return file.error();
  LineIndex index(lines->name(), std::move(*file));
  while (const auto line = lines->next()) {
    if (!line->fault.empty()) return Error{Error::Kind::Schema, lines->at(line->number), {}, line->fault};
    index.begins_.push_back(index.begins_.back() + line->text.size() + 1);
    if (!each) continue;
    if (auto done = each(*line); !done) return done.error();
  }
  return index;
}

Result<FileLine> LineIndex::line(std::size_t position) const {
  FileLine line{static_cast<int>(position) + 1, std::string(begins_[position + 1] - begins_[position] - 1, '\0'), ""};
  const auto error = [&](std::string message) {
    return Error{Error::Kind::Io, name_ + ":" + std::to_string(line.number), {}, std::move(message)};
  };
  for (std::size_t got = 0; got < line.text.size();) {
    const auto count = ::pread(file_.get(), line.text.data() + got, line.text.size() - got,
                               static_cast<off_t>(begins_[position] + got));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return error(std::strerror(errno));
    if (count == 0) return error("is no longer there: the file has become shorter");
    got += static_cast<std::size_t>(count);
  }
  return line;
}

}  // namespace unietp
