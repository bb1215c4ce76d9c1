#include "validator/text_record.h"

#include <algorithm>

#include "core/text.h"
#include "record/text_writer.h"

namespace unietp {
namespace {

using Names = std::vector<std::string>;

const Names& checks_by_reader() {
  static const Names kChecks{"form", "parses-back", "style"};
  return kChecks;
}

std::string in_words(const Names& names) { return names.empty() ? "no checks" : "the checks " + join(names, ", "); }

/// What `checks` must be, or nothing where only some of them were passed.
bool passes(TextWriter writer, const Names& checks) {
  static const Names kOfModels{"form", "words", "style", "judged-back"};
  if (writer == TextWriter::Model) return checks == kOfModels;
  if (writer != TextWriter::UncheckedPerson) return checks == checks_by_reader();
  return checks.size() < checks_by_reader().size() &&
         std::includes(checks_by_reader().begin(), checks_by_reader().end(), checks.begin(), checks.end());
}

}  // namespace

std::string origin_fault(const TextOrigin& origin, bool by_model) {
  const std::string& writer = origin.writer;
  const auto known = text_writer_of(writer);
  if (!known) return "has the writer " + writer + "; accepted are grammar, llm:MODEL, person, person:unchecked";
  if (known == TextWriter::Model && !by_model)
    return "is by " + writer + ", but the manifest names no model as a writer";
  if (!passes(*known, origin.checks)) return "passed " + in_words(origin.checks) + ", which are not those of " + writer;
  const bool stands_in = known == TextWriter::Grammar && by_model;
  if (stands_in && origin.why.empty()) return "is by the grammar, but does not say why a model's text was not used";
  if (!stands_in && !origin.why.empty()) return "says why the grammar stands in for a model, which it does not";
  return "";
}

}  // namespace unietp
