#pragma once

#include <optional>
#include <string_view>

namespace unietp {

/// Who wrote a text of a data set, by the field `writer`.
enum class TextWriter {
  Grammar,
  Model,            // "llm:MODEL"
  Person,           // whose text passed all checks
  UncheckedPerson,  // whose text was accepted although it did not
};

/// nullopt for a name that is none of these.
std::optional<TextWriter> text_writer_of(std::string_view name);

}  // namespace unietp
