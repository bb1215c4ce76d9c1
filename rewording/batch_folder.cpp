#include "rewording/batch_folder.h"

#include <algorithm>
#include <charconv>

#include "core/file_writer.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kRequests = "requests-";

std::string file_name(int number) {
  std::string digits = std::to_string(number);
  digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
  return std::string(kRequests) + digits + ".jsonl";
}

}  // namespace

Result<MadeFolders> MadeFolders::make(const fs::path& folder) {
  constexpr int kMostTries = 100;
  MadeFolders folders;
  for (int tried = 1;; ++tried) {
    std::error_code code;
    std::vector<fs::path> missing;  // the deepest first
    for (fs::path path = one_name_of(folder); !path.empty() && !fs::exists(path, code); path = path.parent_path())
      missing.push_back(path);
    code.clear();
    for (auto path = missing.rbegin(); path != missing.rend() && !code; ++path) {
      if (fs::create_directory(*path, code)) folders.made_.push_back(*path);  // false when another was faster
    }
    if (!code) return folders;
    // Whoever made the folder above has just removed it.
    if (code == std::errc::no_such_file_or_directory && tried < kMostTries) continue;
    return Error{Error::Kind::Io, folder.string(), {}, "cannot create this folder: " + code.message()};
  }
}

MadeFolders::~MadeFolders() {
  std::error_code code;
  for (auto path = made_.rbegin(); path != made_.rend(); ++path)
    if (fs::is_directory(*path, code)) fs::remove(*path, code);  // one with anything in it stays
}

Result<BatchFolder> BatchFolder::open(const fs::path& folder, std::string model) {
  auto around = MadeFolders::make(one_name_of(folder).parent_path());
  if (!around) return around.error();
  auto lock = FolderLock::take(folder);
  if (!lock) return lock.error();
  auto own = MadeFolders::make(folder);
  if (!own) return own.error();
  BatchFolder batch(std::move(*around), std::move(*lock), std::move(*own), folder, batch_endpoint(std::move(model)));
  std::error_code code;
  if (auto writable = check_writable(folder / file_name(0)); !writable) return writable.error();
  std::vector<fs::path> files;
  for (auto it = fs::directory_iterator(folder, code); !code && it != fs::directory_iterator(); it.increment(code))
    if (it->is_regular_file(code) && it->path().extension() == ".jsonl") files.push_back(it->path());
  if (code) return Error{Error::Kind::Io, folder.string(), {}, "cannot list this folder: " + code.message()};
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const auto text = read_file(file);
    if (!text) return text.error();
    const std::string name = file.filename().string();
    if (!name.starts_with(kRequests)) {
      read_batch_answers(file.string(), *text, batch.answers_);
      continue;
    }
    int number = 0;
    (void)std::from_chars(name.data() + kRequests.size(), name.data() + name.size(), number);
    constexpr int kMostFiles = 1'000'000;  // a file of a larger number is not ours
    if (number < kMostFiles) batch.files_ = std::max(batch.files_, number);
    for (const std::string& line : split(*text, '\n')) {
      auto id = id_of_batch_line(line);
      if (!id.empty()) ++batch.asked_[id];
    }
  }
  return batch;
}

std::vector<Result<LlmAnswer>> BatchFolder::ask(const std::vector<LlmRequest>& requests) {
  std::vector<Result<LlmAnswer>> answers;
  for (const LlmRequest& request : requests) {
    const auto id = digest_of(endpoint_, request);
    const auto found = answers_.by_id.find(id);
    if (found != answers_.by_id.end() && found->second) {
      used_.insert(id);
      answers.push_back(found->second);
      continue;
    }
    if (waiting_.insert(id).second) {
      const auto times = asked_.find(id);
      const auto given_up = answers_.failures.find(id);
      if (found != answers_.by_id.end()) failures_.push_back(found->second.error().message);
      const int open =
          (times == asked_.end() ? 0 : times->second) - (given_up == answers_.failures.end() ? 0 : given_up->second);
      if (open <= 0) lines_.push_back(batch_line(endpoint_, request));
    }
    answers.emplace_back(Error{Error::Kind::Io, "batch", {}, "the batch has no answer yet"});
  }
  return answers;
}

Result<BatchFolder::Report> BatchFolder::finish() {
  Report report;
  report.answered = static_cast<int>(used_.size());
  report.failed = failures_;
  report.unreadable = answers_.unreadable;
  report.new_requests = static_cast<int>(lines_.size());
  report.waiting = static_cast<int>(waiting_.size() - lines_.size());
  for (const std::string& text : batch_files(lines_)) {
    const fs::path file = folder_ / file_name(++files_);
    if (auto written = write_file(file, text); !written) return written.error();
    report.new_files.push_back(file);
  }
  return report;
}

}  // namespace unietp
