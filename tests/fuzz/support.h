#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/result.h"
#include "logic/formula.h"

namespace unietp::fuzz {

/// A folder of this process for readers that take a path; removed at the end.
class Folder {
 public:
  explicit Folder(std::string_view name);
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  void write(std::string_view name, std::string_view bytes) const;

 private:
  std::filesystem::path path_;
};

/// An error says where and what.
void check_error(const Error& error);
/// Whether there is a value; its error is checked when there is none.
template <class T>
bool check_result(const Result<T>& result) {
  if (!result) check_error(result.error());
  return static_cast<bool>(result);
}
/// The formula prints and parses to itself.
void check_formula(const Formula& formula, FormulaUse use);

}  // namespace unietp::fuzz
