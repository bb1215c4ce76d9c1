#pragma once

#include <span>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "annotator/noun_table.h"
#include "annotator/phrasing_sets.h"
#include "core/result.h"
#include "core/rng.h"
#include "generator/specification.h"
#include "logic/formula.h"
#include "scene/scene.h"

namespace unietp {

/// An instruction with how it was made and what was checked.
struct Instruction {
  std::string text;
  std::string writer;                 // "grammar", or "llm:<model>"
  Style style = Style::Direct;        // as asked, or direct after a fallback
  std::vector<std::string> checks;    // names of the checks that it passed
  std::string why;                    // why the grammar wrote it instead of the requested writer; "" otherwise
  std::vector<Style> phenomena = {};  // that it shows (phenomena.h)
  int phrasing = 0;                   // the template's own, counted from 1; 0: a form of the grammar
};

/// How an instruction is worded.
struct WritingOptions {
  Phrasings phrasings = Phrasings::Everyday;
  std::vector<std::string> around;  // categories in the start scene: what a text may name beside the goal (aside)
  const Scene* home = nullptr;      // the start scene, which an aside is about and readings are held against
  std::span<const std::string> phrasings_of_template = {};  // with slots (templates/phrasing.h); they outlive the call
  bool spells_out = true;    // a goal that nothing else says, operator by operator: "for every mug, in the end, …"
  bool tells_apart = false;  // uses no name that another thing of the home may be called (EverydayNames::look_alikes)
};

/// Words a goal in English: every object, count, quantifier, order and referring constraint, and nothing else.
/// Deterministic in rng. `nouns`: the table of `knowledge`, which takes longer to make than a text. Errors:
/// Unsatisfiable when the grammar has no words for a part of the goal (names the part), or none among the phrasings
/// asked for.
Result<Instruction> write_instruction(const Specification& specification, const Knowledge& knowledge,
                                      const NounTable& nouns, const WritingOptions& options, Rng rng);

/// The checks of a text in the grammar's English: its form (word_check.h), and it reads back as a goal that is proven
/// to mean the same; where the words have several readings, exactly one of them can be meant in the home
/// (home_reading.h), and that one is it. `home`: the start scene, or nullptr when it is not known. Empty when it
/// passes, else what is wrong.
std::vector<std::string> check_instruction(const std::string& text, const Specification& specification,
                                           const Knowledge& knowledge, const NounTable& nouns,
                                           const Scene* home = nullptr);
/// What a text of another writer asks for where it is in the grammar's English and no reading of it is the goal; "" for
/// all others, of which nothing is known. Parameters as above.
std::string misreading(const std::string& text, const Specification& specification, const Knowledge& knowledge,
                       const NounTable& nouns, const Scene* home);
/// The one goal that a text means in the home. Errors: Parse for what is no text of the grammar's English, that can be
/// read in several ways there or in none, and whose "it" is not what was named last.
Result<Formula> goal_of_text(const std::string& text, const Specification& specification, const Knowledge& knowledge,
                             const NounTable& nouns, const Scene& home);

}  // namespace unietp
