#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "akb/knowledge.h"
#include "akb/table_words.h"
#include "core/files.h"
#include "templates/constraint_kinds.h"
#include "templates/phrasing.h"
#include "templates/refinement_kinds.h"
#include "templates/template.h"

namespace unietp {
namespace {

std::string document(const std::string& name) {
  const auto text = read_file(std::filesystem::path(UNIETP_SOURCE_DIR) / "docs" / name);
  EXPECT_TRUE(text);
  return text ? *text : "";
}

/// The first ```lisp block that holds a whole template.
std::string example_in(const std::string& text) {
  const std::string fence = "```lisp\n";
  for (auto at = text.find(fence); at != std::string::npos; at = text.find(fence, at + 1)) {
    const auto start = at + fence.size();
    const auto block = text.substr(start, text.find("```", start) - start);
    if (block.find("(template ") != std::string::npos) return block;
  }
  return "";
}

TEST(Docs, TheExamplesAreTemplates) {
  for (const auto& [doc, name] :
       {std::pair("templates.md", "place-two-one-inside"), std::pair("add-a-template.md", "two-on-and-close")}) {
    const auto reading = parse_template(std::string(name) + ".template", example_in(document(doc)));
    for (const auto& error : reading.errors) ADD_FAILURE() << doc << ": " << format(error);
    EXPECT_EQ(reading.templates.size(), 1U) << doc;
  }
}

TEST(Docs, NameEveryWordOfTheLanguage) {
  const auto text = document("templates.md");
  const auto has = [&](std::string_view word) { return text.find(word) != std::string::npos; };
  for (const auto& kind : constraint_kinds()) {
    EXPECT_TRUE(has(std::string("`(").append(kind.name).append(" "))) << kind.name;
  }
  for (const auto& word : affordance_names()) EXPECT_TRUE(has(std::string("`").append(word).append("`"))) << word;
  for (const auto& word : pseudo_affordances()) EXPECT_TRUE(has(std::string("`").append(word).append("`"))) << word;
  for (const auto& form : slot_forms()) EXPECT_TRUE(has(std::string(":").append(form.name).append("}"))) << form.name;
  for (const auto& kind : refinement_kinds()) {
    EXPECT_TRUE(has(std::string("`").append(kind.name).append("`"))) << kind.name;
  }
  for (const auto simulator : kSimulators) EXPECT_TRUE(has(name_of(simulator)));
}

}  // namespace
}  // namespace unietp
