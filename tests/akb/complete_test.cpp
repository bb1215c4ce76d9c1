// A whole completion against a server on loopback: what is asked, taken, written and laid under the tables.
#include <algorithm>
#include <atomic>

#include <gmock/gmock.h>

#include "../llm/asking.h"
#include "../llm/model.h"
#include "akb/complete.h"
#include "core/files.h"
#include "core/text.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using test::answer_all;
using test::ChatServer;
using test::endpoint_of;
using test::http;
using test::Received;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Key;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

std::vector<FactKind> every_kind() { return {all_fact_kinds().begin(), all_fact_kinds().end()}; }

std::map<std::string, std::string> bytes_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).generic_string()] = *read_file(entry.path());
  }
  return files;
}

/// Small tables of the four simulators, a cache, and runs on them.
class Home {
 public:
  Home() { test::write_small_tables(tables(), texts_); }
  fs::path tables() const { return folder_.path() / "akb"; }
  std::map<std::string, std::string> completed() const { return bytes_below(tables() / "completed"); }
  std::map<std::string, std::string> all_files() const { return bytes_below(folder_.path()); }

  void rewrite(const std::string& table, const std::string& from, const std::string& to) {
    ASSERT_NE(texts_[table].find(from), std::string::npos);
    texts_[table] = replace_all(texts_[table], from, to);
    test::write_small_tables(tables(), texts_);
  }

  CompletionReport run(const LlmEndpoint& endpoint, CompletionOptions options) const {
    auto cache = LlmCache::open(folder_.path() / "answers.sqlite");
    EXPECT_TRUE(cache);
    std::vector<Error> errors;
    auto plan = plan_completion(tables(), endpoint, options, &*cache, errors);
    for (const auto& error : errors) ADD_FAILURE() << format(error);
    auto report = complete_knowledge(tables(), endpoint, options, &*cache, std::move(plan));
    EXPECT_TRUE(report) << format(report.error());
    return std::move(*report);
  }

  Knowledge compiled(Simulator simulator = Simulator::Behavior) const {
    const auto database = folder_.path() / "knowledge.sqlite";
    for (const auto& error : compile_knowledge(tables(), database)) ADD_FAILURE() << format(error);
    auto knowledge = load_knowledge(database, simulator);
    EXPECT_TRUE(knowledge) << format(knowledge.error());
    return std::move(*knowledge);
  }

 private:
  ScratchFolder folder_;
  std::map<std::string, std::string> texts_ = test::small_tables();
};

CompletionOptions options_for(std::vector<FactKind> facts) {
  CompletionOptions options;
  options.simulators = {Simulator::Behavior};
  options.facts = std::move(facts);
  options.batch = 2;
  options.ask = test::quick();
  return options;
}

TEST(Complete, TakesWhatIsLackingAndNamesTheModel) {
  ChatServer server(answer_all);
  const Home home;
  const auto report = home.run(endpoint_of(server), options_for(every_kind()));
  const auto knowledge = home.compiled();
  const Source model{"llm:tiny", 0.5};

  ASSERT_EQ(knowledge.aliases_of("plate", AliasKind::Function).size(), 1U);
  EXPECT_EQ(knowledge.aliases_of("plate", AliasKind::Function)[0]->text, "something useful at home");
  EXPECT_EQ(knowledge.aliases_of("plate", AliasKind::Function)[0]->source, model);
  ASSERT_EQ(knowledge.aliases_of("plate", AliasKind::Synonym).size(), 1U);  // "thingamajig" would name everything
  EXPECT_EQ(knowledge.aliases_of("plate", AliasKind::Synonym)[0]->text, "etalp");
  EXPECT_EQ(knowledge.aliases_of("apple", AliasKind::Context).size(), 1U);
  EXPECT_EQ(knowledge.find("fridge")->synset, "artifact.n.01");
  EXPECT_EQ(knowledge.find("fridge")->synset_source, model);
  EXPECT_TRUE(knowledge.has("knife", "dirtyable"));
  ASSERT_EQ(knowledge.placements_of("half_apple", Predicate::Inside).size(), 1U);  // not in the mug, which is too small
  EXPECT_EQ(knowledge.placements_of("half_apple", Predicate::Inside)[0]->source, model);

  EXPECT_EQ(report.accepted.at(FactKind::Function), 5);  // of all but the mug
  EXPECT_GT(report.unused, 0);
  std::vector<std::string> reasons;
  for (const auto& rejected : report.rejected) reasons.push_back(rejected.reason);
  EXPECT_THAT(reasons, Contains("a duplicate"));
  EXPECT_THAT(reasons, Contains("an unknown affordance"));
  EXPECT_THAT(reasons, Contains("does not fit there"));
  EXPECT_THAT(reasons, Contains("not lower-case English words"));
}

TEST(Complete, ASynonymThatNamesTwoCategoriesIsLeftOut) {
  const ScratchFolder folder;
  test::write_small_tables(folder.path(), test::small_tables());
  std::vector<Error> errors;
  auto tables = read_tables(folder.path() / "habitat", errors);
  ASSERT_THAT(errors, IsEmpty());
  const Source model{"llm:tiny", 0.5};
  CompletedFacts facts;
  facts.aliases = {{"apple", "snack", AliasKind::Synonym, model},
                   {"half_apple", "snack", AliasKind::Synonym, model},
                   {"apple", "mugs", AliasKind::Synonym, model},
                   {"plate", "cup, with a handle", AliasKind::Synonym, model},
                   {"apple", "windfall", AliasKind::Synonym, model},
                   {"apple", "something to eat", AliasKind::Function, model},
                   {"plate", "something to eat", AliasKind::Function, model}};
  lay_under(facts, {}, tables);
  std::vector<std::string> laid;
  for (const auto& alias : tables.aliases) {
    if (alias.source == model)
      laid.push_back(alias.category + " " + std::string(name_of(alias.kind)) + " " + alias.text);
  }
  EXPECT_THAT(laid, UnorderedElementsAre("apple synonym windfall", "apple function something to eat",
                                         "plate function something to eat"));
}

TEST(Complete, ChangesNoFactOfAnotherSource) {
  ChatServer server(answer_all);
  const Home home;
  const auto before = home.compiled();
  (void)home.run(endpoint_of(server), options_for(every_kind()));
  const auto after = home.compiled();
  for (const auto& c : before.categories()) {
    const auto& now = *after.find(c.name);
    EXPECT_EQ(now.size, c.size);
    EXPECT_EQ(now.size_source, c.size_source);
    EXPECT_EQ(now.mass, c.mass);
    EXPECT_EQ(now.mass_source, c.mass_source);
    if (!c.synset.empty()) {
      EXPECT_EQ(now.synset, c.synset);
    }
  }
  for (const auto& f : before.affordances()) EXPECT_TRUE(after.has(f.category, f.affordance));
  for (const auto& p : before.placements()) {
    EXPECT_EQ(after.placement(p.object, p.relation, p.receptacle)->source, p.source);
    EXPECT_EQ(after.placement(p.object, p.relation, p.receptacle)->likelihood, p.likelihood);
  }
  EXPECT_EQ(after.aliases_of("mug", AliasKind::Function).size(), 1U);
  EXPECT_EQ(after.aliases_of("mug", AliasKind::Function)[0]->source.source, "curated");
  EXPECT_THAT(home.completed(), Not(Contains(Key(HasSubstr("size")))));
}

TEST(Complete, AFactOfAnotherSourceWinsAlsoWhenItComesLater) {
  ChatServer server(answer_all);
  Home home;
  home.rewrite("category", "0.24,0.24,0.02,0.5,kitchen,white,ceramic,curated,1,curated,1,curated,1",
               "0.24,0.24,0.02,0.5,kitchen,white,ceramic,curated,1,derived:typical,0.4,derived:typical,0.4");
  (void)home.run(endpoint_of(server), options_for(every_kind()));
  EXPECT_EQ(home.compiled().find("plate")->size, Vec3(0.11, 0.12, 0.13));
  EXPECT_EQ(home.compiled().find("plate")->size_source.source, "llm:tiny");
  EXPECT_EQ(home.compiled().find("plate")->mass, 0.457);

  home.rewrite("category", "derived:typical,0.4,derived:typical,0.4", "metadata:a.json,0.3,derived:typical,0.5");
  home.rewrite("alias", "mug,function", "plate,function,something to eat from,curated,1\nmug,function");
  home.rewrite("affordance", "mug,pickupable", "plate,breakable,curated,1\nmug,pickupable");
  home.rewrite("relation", "apple,inside", "half_apple,on,plate,1,1,curated,1\napple,inside");
  const auto knowledge = home.compiled();
  EXPECT_EQ(knowledge.find("plate")->size, Vec3(0.24, 0.24, 0.02));
  EXPECT_EQ(knowledge.find("plate")->mass, 0.5);
  ASSERT_EQ(knowledge.aliases_of("plate", AliasKind::Function).size(), 1U);
  EXPECT_EQ(knowledge.aliases_of("plate", AliasKind::Function)[0]->text, "something to eat from");
  EXPECT_THAT(knowledge.affordances_of("plate"), ElementsAre("breakable"));
  EXPECT_THAT(knowledge.placements_of("half_apple", Predicate::Inside), IsEmpty());
}

TEST(Complete, WhatWasTakenBackByHandStaysAway) {
  ChatServer server(answer_all);
  const Home home;
  (void)home.run(endpoint_of(server), options_for(every_kind()));
  EXPECT_TRUE(home.compiled().has("knife", "dirtyable"));
  const auto digest = digest_of_tables(home.tables());
  ASSERT_TRUE(write_file(removed_file(home.tables(), Simulator::Behavior),
                         "table,subject,verb,object\naffordance,knife,dirtyable,\nrelation,half_apple,inside,*\n"));
  EXPECT_NE(*digest_of_tables(home.tables()), *digest);
  EXPECT_FALSE(home.compiled().has("knife", "dirtyable"));
  EXPECT_THAT(home.compiled().placements_of("half_apple", Predicate::Inside), IsEmpty());
}

TEST(Complete, AnOverrideWinsOverCompletedFacts) {
  ChatServer server(answer_all);
  const Home home;
  (void)home.run(endpoint_of(server), options_for(every_kind()));
  ASSERT_TRUE(home.compiled().has("knife", "dirtyable"));
  ASSERT_TRUE(home.compiled().has("plate", "dirtyable"));
  ASSERT_TRUE(write_file(home.tables() / "override.csv",
                         "simulator,category,fact,value,reason\n"
                         "behavior,knife,dirtyable,false,it is always clean\n"
                         "behavior,plate,breakable,true,ceramic\n"
                         "behavior,half_apple,inside:fridge:capacity,2,refines a completed fact\n"));
  const auto knowledge = home.compiled();
  EXPECT_FALSE(knowledge.has("knife", "dirtyable"));
  EXPECT_THAT(knowledge.affordances_of("plate"), ElementsAre("breakable"));  // told by hand, so not by a model
  EXPECT_EQ(knowledge.placement("half_apple", Predicate::Inside, "fridge")->capacity, 2);
  std::vector<Error> errors;
  auto options = options_for({FactKind::Affordances});
  const auto plan = plan_completion(home.tables(), endpoint_of(server), options, nullptr, errors);
  EXPECT_EQ(plan.lacking.at(FactKind::Affordances), 2);  // half apple and knife
}

TEST(Complete, ASecondRunAsksNothingAndChangesNoByte) {
  ChatServer server(answer_all);
  const Home home;
  const auto first = home.run(endpoint_of(server), options_for(every_kind()));
  const auto bytes = home.completed();
  EXPECT_GT(first.totals.asked, 0);
  EXPECT_THAT(bytes, Not(IsEmpty()));
  const int asked = server.count();
  const auto second = home.run(endpoint_of(server), options_for(every_kind()));
  EXPECT_EQ(server.count(), asked);
  EXPECT_EQ(second.totals.asked, 0);
  EXPECT_EQ(home.completed(), bytes);
}

TEST(Complete, StoppedHalfwayAndRunAgainGivesTheBytesOfOneRun) {
  ChatServer server(answer_all);
  const Home whole;
  (void)whole.run(endpoint_of(server), options_for(every_kind()));
  for (int stop_after = 1; stop_after < 5; ++stop_after) {
    const Home halved;
    std::atomic<bool> stop = false;
    int answered = 0;
    auto options = options_for(every_kind());
    options.ask.at_once = 1;  // else all may be answered before the stop is seen
    options.ask.stop = &stop;
    options.ask.on_answer = [&](std::size_t, const Result<LlmAnswer>&) { stop = ++answered >= stop_after; };
    const auto report = halved.run(endpoint_of(server), options);
    EXPECT_TRUE(report.stopped);
    EXPECT_THAT(halved.completed(), Not(IsEmpty()));  // what was accepted is kept
    EXPECT_NE(halved.completed(), whole.completed());
    (void)halved.run(endpoint_of(server), options_for(every_kind()));
    EXPECT_EQ(halved.completed(), whole.completed());
  }
}

TEST(Complete, TheOrderOfArrivalDoesNotChangeAByte) {
  ChatServer server(answer_all);
  const Home one_by_one;
  auto options = options_for(every_kind());
  options.ask.at_once = 1;
  (void)one_by_one.run(endpoint_of(server), options);
  options.ask.at_once = 16;
  for (int i = 0; i < 5; ++i) {
    const Home at_once;
    (void)at_once.run(endpoint_of(server), options);
    EXPECT_EQ(at_once.completed(), one_by_one.completed());
  }
}

TEST(Complete, LosesNothingToAServerThatMisbehaves) {
  ChatServer good(answer_all);
  const Home calm;
  (void)calm.run(endpoint_of(good), options_for(every_kind()));

  std::mutex mutex;
  std::map<std::string, std::size_t> times;
  const std::string leak = std::string("key ") + test::kKey;
  const std::vector<std::string> troubles = {http("429 Too Many Requests", leak, "Retry-After: 0\r\n"),
                                             http("500 Oh", R"({"error":")" + leak + "\"}"),
                                             "",
                                             "HTTP/1.1 200 OK\r\nContent-Length: 999\r\n\r\n{\"choices\"",
                                             http("200 OK", "<html>" + leak + "</html>"),
                                             test::completion("I will not."),
                                             test::completion("{\"categories\": \"" + leak + "\"}"),
                                             http("200 OK", std::string(std::size_t{5} << 20, 'x'))};
  std::atomic<std::size_t> next = 0;
  ChatServer bad([&](const Received& received) {
    std::size_t before = 0;
    {
      const std::lock_guard lock(mutex);
      before = times[received.user]++;
    }
    if (before < 3) return troubles[next++ % troubles.size()];
    return answer_all(received);
  });
  const Home stormy;
  auto options = options_for(every_kind());
  options.ask.max_attempts = 9;
  const auto report = stormy.run(endpoint_of(bad), options);
  EXPECT_EQ(report.totals.failed, 0);
  EXPECT_EQ(stormy.completed(), calm.completed());
  for (const auto& [name, bytes] : stormy.all_files()) EXPECT_THAT(bytes, Not(HasSubstr(test::kKey))) << name;
}

TEST(Complete, AFailedRequestIsToldAndTheOthersCount) {
  ChatServer server([](const Received& received) {
    return received.user.find("- knife") == std::string::npos ? answer_all(received) : http("404 Not Found", "");
  });
  const Home home;
  const auto report = home.run(endpoint_of(server), options_for({FactKind::Function}));
  EXPECT_EQ(report.totals.failed, 1);
  EXPECT_THAT(report.failures, ElementsAre(::testing::Pair(HasSubstr("status 404"), 1)));
  EXPECT_GT(report.accepted.at(FactKind::Function), 0);
}

TEST(Complete, AnotherModelFillsOnlyWhatIsLeft) {
  ChatServer server([](const Received& received) {
    return received.user.find("- knife") == std::string::npos ? answer_all(received) : test::completion("{}");
  });
  const Home home;
  (void)home.run(endpoint_of(server), options_for({FactKind::Function}));
  const auto first = home.compiled().aliases_of("apple", AliasKind::Function).at(0)->source.source;
  EXPECT_EQ(first, "llm:tiny");
  EXPECT_THAT(home.compiled().aliases_of("knife", AliasKind::Function), IsEmpty());
  ChatServer other(answer_all);
  (void)home.run({other.url, "large", ""}, options_for({FactKind::Function}));
  const auto knowledge = home.compiled();
  EXPECT_EQ(knowledge.aliases_of("apple", AliasKind::Function).at(0)->source.source, "llm:tiny");
  EXPECT_EQ(knowledge.aliases_of("knife", AliasKind::Function).at(0)->source.source, "llm:large");
}

TEST(Complete, ALimitBoundsWhatIsAskedAndTheNextRunGoesOn) {
  ChatServer server(answer_all);
  const Home home;
  auto options = options_for({FactKind::Function});
  options.limit = 2;
  EXPECT_EQ(home.run(endpoint_of(server), options).accepted.at(FactKind::Function), 2);
  EXPECT_EQ(home.run(endpoint_of(server), options).accepted.at(FactKind::Function), 2);
  EXPECT_EQ(home.run(endpoint_of(server), options).accepted.at(FactKind::Function), 1);
  EXPECT_EQ(home.run(endpoint_of(server), options).totals.asked, 0);
  const Home other;
  options.limit = 1;
  EXPECT_EQ(other.run(endpoint_of(server), options).accepted.at(FactKind::Function), 1);
  EXPECT_EQ(other.run(endpoint_of(server), options).accepted.at(FactKind::Function), 1);
}

TEST(Complete, AFaultyFileOfCompletedFactsIsPlaced) {
  const Home home;
  const auto folder = completed_folder(home.tables(), Simulator::Behavior);
  ASSERT_TRUE(write_file(folder / "alias.csv",
                         "category,kind,text,source,confidence\nplait,function,something,llm:m,0.5\n"
                         "plate,function,something,curated,0.5\n"));
  ASSERT_TRUE(
      write_file(folder / "size.csv", "category,width,depth,height,source,confidence\nplate,1,nan,1,llm:m,1\n"));
  std::vector<std::string> messages;
  for (const auto& error : compile_knowledge(home.tables(), home.tables() / "x.sqlite"))
    messages.push_back(format(error));
  EXPECT_THAT(messages, ElementsAre(::testing::AllOf(HasSubstr("size.csv:2:9"), HasSubstr("nan")),
                                    ::testing::AllOf(HasSubstr("alias.csv:2:1"), HasSubstr("unknown category 'plait'")),
                                    ::testing::AllOf(HasSubstr("alias.csv:3:26"), HasSubstr("llm:<model>"))));
}

TEST(Complete, AModelWhoseNameCannotBeASourceIsRefused) {
  ChatServer server(answer_all);
  const Home home;
  const auto report = complete_knowledge(home.tables(), {server.url, "my model", ""}, options_for({FactKind::Mass}),
                                         nullptr, CompletionPlan{});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().kind, Error::Kind::Usage);
}

}  // namespace
}  // namespace unietp
