#pragma once

#include <span>
#include <string_view>

namespace unietp {

/// How `validate` knows that a field is right.
enum class FieldRule {
  Fixed,       // it has one value in every data set
  Recomputed,  // it is computed again from other files, and must be equal
  Compared,    // it must agree with other fields, which do not determine it alone
  Physical,    // knowledge and physics must accept it: what homes and starts are made of
  Setting,     // how the run was set up; the files must not contradict it
  Free,        // text by people, or for them
};
std::string_view name_of(FieldRule rule);

/// A field of a file of a data set.
struct FieldInfo {
  std::string_view schema;  // "task": that of data/schemas/ which describes it
  std::string_view field;   // "start.edits", with `[]` for the items of a list of objects; `.*`: and all below it
  FieldRule rule;
  std::string_view how;  // one line for people
};
/// Every field of every schema that a data set's files have, in their order.
std::span<const FieldInfo> field_rules();
/// The rule of a field; nullptr where there is none.
const FieldInfo* rule_of(std::string_view schema, std::string_view field);

}  // namespace unietp
