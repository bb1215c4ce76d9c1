#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "annotator/instruction.h"
#include "annotator/meaning.h"
#include "templates/template.h"
#include "tests/support/committed_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

using Op = Formula::Op;

/// Goals one small step away from the given one.
std::vector<Formula> mutations(const Formula& goal) {
  std::vector<Formula> found;
  const auto add = [&](auto change) {
    Formula other = goal;
    if (change(other)) found.push_back(other);
  };
  if (goal.op == Op::Atom && (goal.predicate == Predicate::On || goal.predicate == Predicate::Inside))
    add([](Formula& f) {
      f.predicate = f.predicate == Predicate::On ? Predicate::Inside : Predicate::On;
      return true;
    });
  if (goal.op == Op::Count) add([](Formula& f) { return ++f.number, true; });
  if (goal.op == Op::And && goal.children.size() > 1) add([](Formula& f) { return f.children.pop_back(), true; });
  if (goal.op == Op::Before || goal.op == Op::Until)
    add([](Formula& f) { return std::swap(f.children[0], f.children[1]), true; });
  if (goal.op == Op::Forall || goal.op == Op::Exists) {
    add([](Formula& f) { return f.op = f.op == Op::Forall ? Op::Exists : Op::Forall, true; });
    add([](Formula& f) { return f.domain.members.empty() ? false : (f.domain.members[0].category += "X", true); });
  }
  for (std::size_t i = 0; i < goal.children.size(); ++i)
    for (Formula& inner : mutations(goal.children[i])) add([&](Formula& f) { return f.children[i] = inner, true; });
  return found;
}

TEST(WriteInstruction, EveryTemplateOfTheLibraryReadsBackAndItsNeighborsDoNot) {
  const auto library = load_templates(std::filesystem::path(UNIETP_SOURCE_DIR) / "templates/library");
  ASSERT_TRUE(library.errors.empty());
  std::size_t goals = 0, written = 0, refused = 0, without_words = 0, spelled_out = 0;
  std::set<std::string> templates_written;
  for (const Simulator simulator : kSimulators) {
    const Knowledge* knowledge = &committed_knowledge(simulator);
    const NounTable nouns(*knowledge, committed_names());
    for (const Template& source : library.templates) {
      SCOPED_TRACE(source.name);
      for (std::uint64_t seed = 1; seed < 4; ++seed) {
        const auto binding = sample_binding(source, *knowledge, {}, Rng(seed));
        const auto specification = binding ? instantiate(source, *knowledge, *binding)
                                           : Result<Specification>(Error{Error::Kind::Unsatisfiable, "", {}, "none"});
        if (!specification) continue;
        SCOPED_TRACE(to_text(specification->goal));
        ++goals;
        if (!write_instruction(*specification, *knowledge, nouns, {}, Rng(0))) {
          ++without_words;  // some categories have no name for a slice
          continue;
        }
        templates_written.insert(source.name);
        for (std::uint64_t draw = 0; draw < 20; ++draw) {
          const auto text = write_instruction(*specification, *knowledge, nouns, {}, Rng(draw));
          ASSERT_TRUE(text) << format(text.error());
          // No operator by operator, as nobody speaks; "in the dining room" needs a home that has one, and so does
          // "leave the one on the table where it is".
          const bool plain = source.name.ends_with("-all-in-room") || source.name == "place-inside-leave-others-on" ||
                             text->text.find(": ") == std::string::npos;
          spelled_out += plain ? 0 : 1;
          ++written;
          if (draw > 0) continue;
          for (const Formula& wrong : mutations(specification->goal)) {
            Specification other = *specification;
            other.goal = wrong;
            EXPECT_FALSE(check_instruction(text->text, other, *knowledge, nouns).empty())
                << text->text << to_text(wrong);
            ++refused;
          }
        }
      }
    }
  }
  EXPECT_EQ(templates_written.size(), library.templates.size());
  EXPECT_LT(without_words, goals / 100);
  EXPECT_LT(spelled_out, written / 100);
  EXPECT_GT(written, 1000u);
  EXPECT_GT(refused, 500u);
}

TEST(WriteInstruction, RefinedGoalsReadBack) {
  const auto library = load_templates(std::filesystem::path(UNIETP_SOURCE_DIR) / "templates/library");
  std::size_t written = 0, without_words = 0;
  for (const Simulator simulator : kSimulators) {
    const Knowledge* knowledge = &committed_knowledge(simulator);
    for (const Template& source : library.templates) {
      const auto binding = sample_binding(source, *knowledge, {}, Rng(6));
      if (!binding) continue;
      const auto plain = instantiate(source, *knowledge, *binding);
      if (!plain) continue;
      for (const auto& refined : {refine_referring(*plain, *knowledge, {}, "", Rng(1)),
                                  refine_linguistic(*plain, *knowledge, {}, "", Rng(1))}) {
        if (!refined || refined->style == Style::Aside) continue;  // which needs a home
        const auto text = write_instruction(*refined, *knowledge, Rng(2));
        if (!text) {
          ++without_words;  // "an egg or a potato" has none that is short
          continue;
        }
        EXPECT_TRUE(check_instruction(text->text, *refined, *knowledge).empty()) << text->text;
        ++written;
      }
    }
  }
  EXPECT_GT(written, 50u);
  EXPECT_LT(without_words, written / 20);
}

}  // namespace
}  // namespace unietp
