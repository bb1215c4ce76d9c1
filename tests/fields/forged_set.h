#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "resources/resources.h"
#include "tests/support/scratch_folder.h"
#include "validator/proof_memory.h"
#include "validator/validate.h"

namespace unietp {

/// A small data set over four simulators, five splits and three modes, with paired wordings and a review, made once by
/// the real program, in which one file at a time is forged: the manifest's checksums are made right again.
class ForgedSet {
 public:
  ForgedSet();

  const std::filesystem::path& folder() const { return folder_; }
  /// The file as it was made; of a home the unpacked text.
  const std::string& text(const std::string& file) const { return texts_.at(file); }
  /// All files below the folder, in order of path.
  std::vector<std::string> files() const;

  /// Validates the folder with other bytes in a file, then puts the old ones back.
  ValidationReport with_bytes(const std::string& file, const std::string& bytes);
  /// The same with other text (packed for a home).
  ValidationReport with(const std::string& file, const std::string& text);
  /// The same with a database changed by SQL.
  ValidationReport with_database(const std::string& sql);
  /// As it was made.
  ValidationReport unchanged();

 private:
  void write(const std::string& file, const std::string& bytes) const;
  /// The manifest with the checksum of a file.
  std::string vouching_for(const std::string& file, const std::string& bytes) const;
  ValidationReport validated();

  ScratchFolder scratch_;
  std::filesystem::path folder_;
  std::map<std::string, std::string> bytes_, texts_;  // by path
  ProofMemory memory_;
  ValidationOptions options_;
};

/// The committed tables and templates.
const Resources& library();

/// The one of this process.
ForgedSet& forged_set();

}  // namespace unietp
