#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "interchange/source_scene.h"
#include "scene/json_reader.h"

namespace unietp {

// Others' JSON files are read as strictly as ours, but fields that nobody asks for are theirs to have.

/// The field, when the object has it and it is not null. Linear in the number of fields.
std::optional<JsonAt> given(const JsonAt& object, std::string_view name);

/// Length of a list of a home's objects; 0 and an error when it is none or has more than limits::kListedObjects.
std::size_t objects_in(JsonReader& reader, const JsonAt& list);

/// Order of a quaternion's four numbers in a file.
enum class QuatOrder { Wxyz, Xyzw };
/// Files round their quaternions: lengths within 1 % of one are accepted and set right.
Quat rounded_rotation(JsonReader& reader, const JsonAt& at, QuatOrder order);

/// The home named by a file: "a/TestScene1.json.gz" → "TestScene1".
std::string home_named_by(std::string_view where);

/// One home's account from its JSON value; errors go to the reader.
using HomeReader = std::function<SourceScene(JsonReader& reader, const JsonAt& home, std::string id)>;

/// All homes of a file: one JSON value; a list of them; an object that holds them by name, as a whole or in its field
/// `scenes`; or JSON lines. `marks` are the fields of which every home has at least one.
/// Errors: Parse with line and column; Schema with a JSON pointer.
Result<std::vector<SourceScene>> read_homes(std::string_view where, std::string_view text,
                                            const std::vector<std::string_view>& marks, const HomeReader& read);

}  // namespace unietp
