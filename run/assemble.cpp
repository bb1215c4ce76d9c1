#include "run/assemble.h"

#include <string>

#include "dataset/balance.h"
#include "run/selection.h"

namespace unietp {

namespace {

Result<Done> add_candidate(DatasetWriter& writer, Ledger& ledger, const CandidateRecord& record,
                           Selection::Verdict verdict) {
  if (verdict != Selection::Verdict::Taken)
    return writer.add_rejection(repetition_entry(record, verdict == Selection::Verdict::SameStart));
  if (!record.accepted) return writer.add_rejection(record.rejection);
  return writer.add_task(record.task, traits_from(record.traits),
                         [&ledger](const std::string& layout) { return ledger.home(layout); });
}

}  // namespace

Result<Done> add_block(DatasetWriter& writer, const FilledBlock& block, int attempts) {
  const auto outlines = block.ledger->outlines(block.first, block.slots);
  if (!outlines) return outlines.error();
  Selection selection(block.first, static_cast<std::size_t>(block.slots));
  selection.offer_all(*outlines);
  for (int slot = block.first; slot < block.first + block.slots; ++slot) {
    const int chosen = selection.chosen(slot);
    for (int attempt = 0; attempt <= (chosen < 0 ? attempts - 1 : chosen); ++attempt) {
      const auto record = block.ledger->read(slot, attempt);
      if (!record) return record.error();
      if (auto added = add_candidate(writer, *block.ledger, *record, selection.verdict(slot, attempt)); !added)
        return added.error();
    }
  }
  return Done{};
}

Result<Done> assemble(const std::filesystem::path& folder, const RunConfiguration& configuration,
                      const Resources& resources, const std::filesystem::path& licenses,
                      const std::vector<FilledBlock>& blocks) {
  auto writer = DatasetWriter::begin(folder);
  if (!writer) return writer.error();
  for (const FilledBlock& block : blocks) {
    if (auto added = add_block(*writer, block, configuration.attempts); !added) return added.error();
  }
  return writer->finish(configuration, resources, licenses);
}

}  // namespace unietp
