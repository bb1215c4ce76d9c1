#pragma once

#include <map>
#include <string>

#include <nlohmann/json.hpp>

namespace unietp {

/// A file of data/schemas/; a test that asks for one that is not there fails.
nlohmann::ordered_json schema_file(const std::string& name);

/// Holds values against data/schemas/. Knows the part of JSON Schema that these schemas use and refuses a schema that
/// uses more.
class SchemaChecker {
 public:
  using Json = nlohmann::ordered_json;
  /// What is wrong with `value` by the schema in `file`, or "".
  std::string check(const Json& value, const std::string& file) { return check(value, root(file), file, ""); }

 private:
  const Json& root(const std::string& file);
  std::string check(const Json& value, const Json& schema, const std::string& file, const std::string& path);
  std::string broken(const std::string& word, const Json& rule, const Json& value, const Json& schema,
                     const std::string& file, const std::string& path);

  std::map<std::string, Json> files_;
};

}  // namespace unietp
