#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/result.h"

namespace unietp {

/// SHA-256 by path of the files that a policy consists of, so that a run is not continued with another agent:
///   - of a command, the program and each argument that is a file;
///   - of "python:module.Class", the module's file, and every .py file of its package where it is in one.
/// Paths are those of the command, or relative to the current folder or the entry of PYTHONPATH that has the module.
/// What these files import from elsewhere is not followed; a module in neither place, an installed one, has no files
/// here. Errors: Io, for a file that cannot be read; Usage, for a package of more than 10,000 files.
Result<std::map<std::string, std::string>> files_of_command(const std::vector<std::string>& words);
Result<std::map<std::string, std::string>> files_of_python_policy(const std::string& policy);

}  // namespace unietp
