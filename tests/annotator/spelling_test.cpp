#include "annotator/spelling.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "annotator/instruction.h"
#include "templates/template.h"
#include "tests/support/committed_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Spelling, FindsSlipsAndNotTheNamesOfThings) {
  const auto spelling = Spelling::open();
  ASSERT_TRUE(spelling) << format(spelling.error());
  const NounTable nouns(committed_knowledge(Simulator::Ai2thor), committed_names());
  EXPECT_THAT(spelling->faults("Plaese put the mug in the micorwave, and keep the mug there.", nouns),
              ElementsAre("the word 'plaese' is in no dictionary (please?)",
                          "the word 'micorwave' is in no dictionary (microwave?)"));
  EXPECT_THAT(spelling->faults("Put 2 mugs beside the grey teddy bear, or the gray one: it's John's.", nouns),
              IsEmpty());
}

/// What the grammar writes has no slips: display names, synonyms, function phrases and all turns of phrase.
TEST(Spelling, KnowsEveryWordThatTheGrammarWrites) {
  const auto spelling = Spelling::open();
  ASSERT_TRUE(spelling) << format(spelling.error());
  const auto library = load_templates(std::filesystem::path(UNIETP_SOURCE_DIR) / "templates/library");
  ASSERT_TRUE(library.errors.empty());
  std::size_t texts = 0;
  for (const auto simulator : kSimulators) {
    const auto& knowledge = committed_knowledge(simulator);
    const NounTable nouns(knowledge, committed_names());
    for (std::size_t i = 0; i < library.templates.size(); ++i) {
      const auto& source = library.templates[i];
      const auto binding = sample_binding(source, knowledge, {}, Rng(3).fork(source.name, i));
      auto made = binding ? instantiate(source, knowledge, *binding)
                          : Result<Specification>(Error{Error::Kind::Unsatisfiable, "", {}, "none"});
      if (!made) continue;
      for (const Style style : {Style::Direct, Style::Alias, Style::Function, Style::Hypernym, Style::Description,
                                Style::Context, Style::Request}) {
        made->style = style;
        const auto text = write_instruction(*made, knowledge, nouns, {}, Rng(i));
        if (!text) continue;
        ++texts;
        EXPECT_THAT(spelling->faults(text->text, nouns), IsEmpty()) << text->text;
      }
    }
  }
  EXPECT_GT(texts, 1000U);
}

}  // namespace
}  // namespace unietp
