#pragma once

#include <string>
#include <string_view>

#include "core/result.h"

namespace unietp {

/// The JSON object in a model's text: the text itself, or the first object in it, after reasoning (`</think>`), prose
/// or a code fence. Its bytes are unchanged. Errors: Schema, when there is none or it is nested over 64 deep.
Result<std::string> json_object_in(std::string_view text);

/// True when brackets outside strings nest over 64 deep; such texts are not parsed.
bool nested_too_deep(std::string_view json);

}  // namespace unietp
