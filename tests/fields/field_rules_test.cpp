#include "validator/field_rules.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/files.h"

namespace unietp {
namespace {

using ::testing::IsEmpty;
using Json = nlohmann::ordered_json;

/// The fields that a schema describes, named as in FieldInfo. What another schema describes is one field here.
class SchemaFields {
 public:
  explicit SchemaFields(const std::string& name) {
    const auto text = read_file(std::string(UNIETP_SOURCE_DIR) + "/data/schemas/" + name + ".schema.json");
    EXPECT_TRUE(text) << name;
    root_ = Json::parse(*text);
    visit(root_, "", {});
  }
  const std::vector<std::string>& all() const { return fields_; }

 private:
  void visit(const Json& schema, const std::string& field, std::set<std::string> inside) {
    if (schema.contains("$ref")) {
      const std::string target = schema["$ref"];
      const std::string own = "#/$defs/";
      if (!target.starts_with(own) || !inside.insert(target).second) return fields_.push_back(field);
      return visit(root_["$defs"][target.substr(own.size())], field, inside);
    }
    if (schema.contains("properties")) {
      for (const auto& [name, part] : schema["properties"].items())
        visit(part, field.empty() ? name : field + "." + name, inside);
      return;
    }
    const bool of_objects =
        schema.contains("items") && (schema["items"].contains("properties") || schema["items"].contains("$ref"));
    if (of_objects) return visit(schema["items"], field + "[]", inside);
    fields_.push_back(field);
  }

  Json root_;
  std::vector<std::string> fields_;
};

/// A new field needs a rule, and a field that is gone needs none.
TEST(FieldRules, AreThereForEveryFieldOfTheSchemasAndForNoOther) {
  std::set<std::string> known;
  for (const char* schema :
       {"task", "delta", "scene", "demonstration", "rejection", "wordings", "review-mark", "manifest", "run"}) {
    const SchemaFields fields(schema);
    for (const auto& field : fields.all()) {
      const auto* rule = rule_of(schema, field);
      EXPECT_NE(rule, nullptr) << "add a rule for the field " << field << " of " << schema << " to field_rules.cpp";
      if (rule != nullptr) known.insert(std::string(schema) + " " + std::string(rule->field));
    }
  }
  std::vector<std::string> stale;
  for (const FieldInfo& rule : field_rules()) {
    const auto name = std::string(rule.schema) + " " + std::string(rule.field);
    if (!known.contains(name)) stale.push_back(name);
  }
  EXPECT_THAT(stale, IsEmpty());
}

TEST(FieldRules, FreeTextIsAClosedList) {
  std::vector<std::string> free;
  for (const FieldInfo& rule : field_rules()) {
    if (rule.rule == FieldRule::Free) free.push_back(std::string(rule.schema) + " " + std::string(rule.field));
  }
  EXPECT_THAT(free, ::testing::ElementsAre("task instruction.why", "review-mark comment"));
}

}  // namespace
}  // namespace unietp
