#include "record/text_writer.h"

namespace unietp {

std::optional<TextWriter> text_writer_of(std::string_view name) {
  constexpr std::string_view kModel = "llm:";
  if (name.starts_with(kModel) && name.size() > kModel.size()) return TextWriter::Model;
  if (name == "grammar") return TextWriter::Grammar;
  if (name == "person") return TextWriter::Person;
  if (name == "person:unchecked") return TextWriter::UncheckedPerson;
  return std::nullopt;
}

}  // namespace unietp
