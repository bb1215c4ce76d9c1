#include "record/line_file.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "core/limits.h"

namespace unietp {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{1} << 18;  // read at once

std::string fault_of(const std::string& text, bool has_end) {
  if (!has_end) return "does not end in a line feed: the file is cut off";
  if (text.empty()) return "is empty; expected a JSON object on every line";
  if (text.back() == '\r') return "ends in CR LF; expected only LF";
  return "";
}

}  // namespace

Result<LineFile> LineFile::open(const std::filesystem::path& folder, const std::string& name, FileNames names) {
  std::string shown = names == FileNames::InFolder ? name : (folder / name).string();
  std::error_code code;
  if (!std::filesystem::exists(std::filesystem::symlink_status(folder / name, code)))
    return Error{Error::Kind::Io, std::move(shown), {}, "is missing; expected a finished data set"};
  auto file = open_regular_file(folder, name);
  if (!file) {
    Error error = file.error();
    error.where = std::move(shown);
    return error;
  }
  return LineFile(std::move(shown), std::move(*file));
}

bool LineFile::fill() {
  buffer_.erase(0, used_);
  used_ = 0;
  const std::size_t kept = buffer_.size();
  buffer_.resize(kept + kBlockBytes);
  ssize_t count = 0;
  do count = ::read(file_.get(), buffer_.data() + kept, kBlockBytes);
  while (count < 0 && errno == EINTR);
  failed_ = count < 0;
  buffer_.resize(kept + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return buffer_.size() > kept;
}

std::optional<FileLine> LineFile::next() {
  if (ended_) return std::nullopt;
  std::size_t searched = used_;
  std::size_t end = buffer_.find('\n', searched);
  while (end == std::string::npos && buffer_.size() - used_ <= limits::kLineBytes) {
    searched = buffer_.size() - used_;
    if (!fill()) break;
    end = buffer_.find('\n', searched);
  }
  FileLine line{++lines_, buffer_.substr(used_, end == std::string::npos ? end : end - used_), ""};
  const bool has_end = end != std::string::npos;
  used_ = has_end ? end + 1 : buffer_.size();
  if (failed_) {
    ended_ = true;
    line.fault = "cannot be read";
  } else if (line.text.size() > limits::kLineBytes) {
    ended_ = true;
    line.fault = "is longer than " + std::to_string(limits::kLineBytes) + " bytes; nothing after it is read";
  } else if (!has_end && line.text.empty()) {  // the end of a sound file
    ended_ = true;
    return std::nullopt;
  } else {
    line.fault = fault_of(line.text, has_end);
  }
  return line;
}

}  // namespace unietp
