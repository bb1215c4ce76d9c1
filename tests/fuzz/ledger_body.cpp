#include "annotator/instruction.h"
#include "bodies.h"
#include "dataset/dataset_database.h"
#include "fuzz_bodies.h"
#include "run/ledger.h"
#include "support.h"

namespace unietp::fuzz {
bool rewording_body(std::string_view bytes) {
  static const Folder folder("rewording");
  folder.write("dataset.sqlite", bytes);
  Instruction other;
  other.text = "Open the fridge.";
  other.writer = "fuzz";
  const auto copy = folder.path() / "copy.sqlite";
  std::filesystem::remove(copy);
  auto database = RewordedDatabase::begin(folder.path() / "dataset.sqlite", copy);
  return check_result(database) && check_result(database->add("ai2thor-00001", other)) &&
         check_result(database->finish());
}

bool ledger_body(std::string_view bytes) {
  static const Folder folder("ledger");
  folder.write("ledger.sqlite", bytes);
  auto ledger = Ledger::read_only(folder.path() / "ledger.sqlite", "fuzz");
  if (!check_result(ledger)) return false;
  const auto outlines = ledger->outlines(0, 1000);
  if (!check_result(outlines)) return false;
  for (const CandidateRecord& outline : *outlines) {
    if (!check_result(ledger->read(outline.slot, outline.attempt))) return false;
  }
  return check_result(ledger->home("h"));
}

}  // namespace unietp::fuzz
