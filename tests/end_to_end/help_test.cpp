// Help, manual page and shell completions of the real program, and where it finds its data.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "core/files.h"
#include "core/text.h"
#include "program.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

std::string output_of(const std::vector<std::string>& arguments) {
  const auto ended = run_program(arguments);
  EXPECT_EQ(ended.code, 0) << join(arguments, " ") << "\n" << ended.err;
  return ended.out;
}

/// First words of the indented lines of one section: commands, topics or options.
std::vector<std::string> entries(const std::string& text, const std::string& section) {
  std::vector<std::string> found;
  bool within = false;
  for (const auto& line : split(text, '\n')) {
    if (!line.starts_with(' ')) within = line.starts_with(section);
    if (within && line.starts_with("  ") && line.size() > 2 && line[2] != ' ') {
      for (const auto& word : split(line.substr(2), ' ')) {
        if (!word.starts_with("--") && !found.empty() && section == "Options") break;
        found.push_back(word.ends_with(',') ? word.substr(0, word.size() - 1) : word);
        if (!word.ends_with(',')) break;
      }
    }
  }
  return found;
}

/// Every command with its subcommands, as words: {"scene", "import"}.
std::vector<std::vector<std::string>> all_commands() {
  std::vector<std::vector<std::string>> all;
  for (const auto& name : entries(output_of({"help"}), "Commands")) {
    all.push_back({name});
    for (const auto& below : entries(output_of({"help", name}), "Commands")) all.push_back({name, below});
  }
  return all;
}

TEST(Help, TheFirstScreenFitsATerminalAndNamesEveryCommand) {
  const auto screen = output_of({"--help"});
  const auto lines = split(screen, '\n');
  EXPECT_LE(lines.size(), 24U);  // the last is empty
  for (const auto& line : lines) EXPECT_LE(line.size(), 80U) << line;
  for (const auto& name : entries(output_of({"help"}), "Commands")) EXPECT_THAT(screen, HasSubstr(name));
}

TEST(Help, AFormatIsListedWithTheValuesOfItsOptions) {
  const auto formats = output_of({"help", "formats"});
  EXPECT_THAT(formats, HasSubstr("  --unit episode|step\n"));
  EXPECT_THAT(formats, HasSubstr("  --modes M1|M2|M3\n"));
  EXPECT_THAT(formats, HasSubstr("  --reasoning\n"));
}

TEST(Help, EveryCommandHasASummaryAnExampleAndShortLines) {
  const auto commands = all_commands();
  EXPECT_GT(commands.size(), 35U);
  for (const auto& command : commands) {
    const std::string name = "unietp " + join(command, " ");
    SCOPED_TRACE(name);
    auto asked = command;
    asked.push_back("--help");
    const auto text = output_of(asked);
    asked.insert(asked.begin(), "help");
    asked.pop_back();
    EXPECT_EQ(text, output_of(asked));
    const auto examples = text.find("\nExamples:\n");
    ASSERT_NE(examples, std::string::npos);
    // `completion` is shown with the shell around it.
    if (name != "unietp completion") {
      EXPECT_THAT(text.substr(examples), HasSubstr("  " + name));
    }
    for (const auto& line : split(text.substr(0, examples), '\n')) EXPECT_LE(line.size(), 80U) << line;
  }
}

TEST(Help, EveryTopicIsExplainedAndAnUnknownOneIsAnsweredWithTheNearest) {
  const auto topics = entries(output_of({"help"}), "Topics");
  EXPECT_GE(topics.size(), 6U);
  for (const auto& topic : topics) {
    for (const auto& line : split(output_of({"help", topic}), '\n')) EXPECT_LE(line.size(), 84U) << line;
  }
  const auto unknown = run_program({"help", "home"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean \"homes\""));
}

TEST(Help, AnUnknownCommandIsAnsweredWithTheNearest) {
  for (const auto& [words, near] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"generat"}, "generate"}, {{"scene", "improt"}, "import"}}) {
    const auto ended = run_program(words);
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.err, HasSubstr("did you mean \"" + near + "\""));
  }
  EXPECT_EQ(run_program({}).code, 2);
  EXPECT_EQ(run_program({"scene"}).code, 2);
}

TEST(Help, NoTextNamesAPathOutsideTheProgram) {
  auto texts = output_of({"help", "--man"});
  for (const char* shell : {"bash", "zsh", "fish"}) texts += output_of({"completion", shell});
  EXPECT_THAT(replace_all(texts, ".../", ""), Not(HasSubstr("../")));
  EXPECT_THAT(texts, Not(HasSubstr(UNIETP_SOURCE_DIR "/")));
}

TEST(ManualPage, NamesEveryCommandAndPassesGroff) {
  const auto page = output_of({"help", "--man"});
  for (const auto& command : all_commands())
    EXPECT_THAT(page, HasSubstr(".SS " + replace_all("unietp " + join(command, " "), "-", "\\-") + "\n"));
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at("unietp.1"), page));
  const auto ended =
      run_script("command -v groff > /dev/null || exit 9\ngroff -man -ww -Tutf8 -z unietp.1", folder.path());
  if (ended.code == 9) GTEST_SKIP() << "groff is not here: install groff";
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.err, "");
}

TEST(Completion, NamesEveryCommandAndOptionInEveryShell) {
  std::map<std::string, std::string> scripts;
  for (const char* shell : {"bash", "zsh", "fish"}) scripts[shell] = output_of({"completion", shell});
  for (const auto& command : all_commands()) {
    auto asked = command;
    asked.insert(asked.begin(), "help");
    const auto options = entries(output_of(asked), "Options");
    for (const auto& [shell, script] : scripts) {
      SCOPED_TRACE(shell + ": " + join(command, " "));
      EXPECT_THAT(script, HasSubstr(command.back()));
      for (const auto& option : options)
        EXPECT_THAT(script, HasSubstr(shell == "fish" ? "-l " + option.substr(2) : option));
    }
  }
}

TEST(Completion, WorksInBash) {
  const auto offers = [](const std::string& words) {
    const ScratchFolder folder;
    fs::create_directories(folder.path() / "out" / "mine");
    RunningProgram bash(
        "/bin/bash",
        {"-c", "source <(unietp completion bash)\ncompopt() { :; }\nCOMP_WORDS=(" + words +
                   ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_unietp\nprintf '%s\\n' \"${COMPREPLY[@]}\""},
        folder.path());
    const auto ended = bash.wait();
    EXPECT_EQ(ended.err, "") << words;
    auto lines = split(ended.out, '\n');
    lines.pop_back();
    return lines;
  };
  using ::testing::ElementsAre;
  EXPECT_THAT(offers("unietp gen"), ElementsAre("generate"));
  EXPECT_THAT(offers("unietp scene im"), ElementsAre("import"));
  EXPECT_THAT(offers("unietp scene import --no"), ElementsAre("--no-settle"));
  EXPECT_THAT(offers("unietp export --format pd"), ElementsAre("pddl"));
  EXPECT_THAT(offers("unietp generate --count 3 --modes M1,M"), ElementsAre("M1,M1", "M1,M2", "M1,M3"));
  EXPECT_THAT(offers("unietp knowledge show ai"), ElementsAre("ai2thor"));
  EXPECT_THAT(offers("unietp help mo"), ElementsAre("modes", "models"));
  EXPECT_THAT(offers("unietp validate out/m"), ElementsAre("out/mine"));
  EXPECT_THAT(offers("unietp generate --thr"), ElementsAre("--threads"));
  EXPECT_THAT(offers("unietp generate --da"), ElementsAre("--data"));  // an option of the program
}

TEST(Version, TellsVersionKnowledgeAndBuild) {
  const auto lines = split(output_of({"--version"}), '\n');
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_THAT(lines[0], ::testing::MatchesRegex("unietp [0-9]+[.][0-9]+[.][0-9]+"));
  EXPECT_THAT(lines[1], ::testing::MatchesRegex("knowledge [0-9a-f]+"));
  EXPECT_EQ(lines[1].size(), std::string("knowledge ").size() + 64);
  EXPECT_THAT(lines[2], ::testing::MatchesRegex("build (GNU|Clang) [0-9.]+, [A-Za-z]+(, commit [0-9a-f]+)?"));
}

/// An installation in miniature: the program and its data, copied elsewhere.
TEST(Installation, WorksAnywhereWithAHomeThatCannotBeWritten) {
  const ScratchFolder folder;
  const fs::path share = folder.path() / "usr" / "share" / "unietp", bin = folder.path() / "usr" / "bin";
  fs::create_directories(share / "templates");
  fs::create_directories(bin);
  fs::copy(fs::path(UNIETP_SOURCE_DIR) / "data", share / "data", fs::copy_options::recursive);
  fs::copy(fs::path(UNIETP_SOURCE_DIR) / "templates" / "library", share / "templates" / "library",
           fs::copy_options::recursive);
  const auto copied = run_script(
      "cp \"$(command -v unietp)\" usr/bin/\n"
      "usr/bin/unietp knowledge build --out usr/share/unietp/compiled",
      folder.path());
  ASSERT_EQ(copied.code, 0) << copied.err;
  const auto ended = run_script(
      "export XDG_CACHE_HOME=/proc/nowhere\n"
      "usr/bin/unietp generate --count 1 --simulators habitat --splits atomic --out made\n"
      "usr/bin/unietp validate made",
      folder.path());
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("1 of 1 proven"));
  // The data that is taken is that of the installation, not of the checkout.
  fs::remove(share / "data" / "akb" / "ai2thor" / "category.csv");
  const auto broken = run_script("usr/bin/unietp knowledge show ai2thor Mug", folder.path());
  EXPECT_EQ(broken.code, 2);
  EXPECT_THAT(broken.err, HasSubstr(share.string()));
}

#ifdef UNIETP_RELEASE
TEST(Installation, TheProgramDoesNotNameTheFolderThatItWasBuiltIn) {
  const ScratchFolder folder;
  const auto found = run_script("! grep -aq '" UNIETP_SOURCE_DIR "/' \"$(command -v unietp)\"", folder.path());
  EXPECT_EQ(found.code, 0);
}
#endif

}  // namespace
}  // namespace unietp
