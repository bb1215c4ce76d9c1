#include <algorithm>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/rng.h"
#include "core/shared_list.h"
#include "core/shared_set.h"
#include "core/shared_value.h"

namespace unietp {
namespace {

std::string text_of(std::uint64_t n) { return "a text that is kept apart from its string: " + std::to_string(n); }

template <class List>
std::vector<std::string> texts(const List& list) {
  return {list.begin(), list.end()};
}

TEST(SharedValue, IsOneObjectUntilACopyIsChanged) {
  SharedValue<std::string> none, text(text_of(1));
  EXPECT_EQ(*none, "");
  const SharedValue<std::string> copy = text;
  EXPECT_EQ(&*copy, &*text);
  text.edit() += "!";
  EXPECT_EQ(*copy, text_of(1));
  EXPECT_EQ(*text, text_of(1) + "!");
  const std::string* alone = &*text;
  text.edit() += "!";
  EXPECT_EQ(&*text, alone);
  none.edit() = "some";
  EXPECT_EQ(*none, "some");
}

TEST(SharedList, IsAsAVectorAndItsCopiesStayWhatTheyWereForAnySeed) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    std::vector<std::string> expected;
    SharedList<std::string> list;
    for (std::uint64_t i = 0; i < rng.below(700); ++i) expected.push_back(text_of(i));
    list = expected;
    std::vector<std::pair<SharedList<std::string>, std::vector<std::string>>> copies;
    for (std::uint64_t change = 0; change < 300; ++change) {
      const auto what = rng.below(10);
      if (what < 5 || expected.empty()) {
        expected.push_back(text_of(change));
        list.push_back(text_of(change));
      } else if (what < 7) {
        const auto at = rng.below(expected.size());
        expected[at] = list.edit(at) = text_of(change);
      } else if (what < 8) {
        expected.pop_back();
        list.pop_back();
      } else if (what < 9 && rng.chance(0.2)) {
        const auto gone = [](const std::string& text) { return text.back() == '7'; };
        std::erase_if(expected, gone);
        erase_if(list, gone);
      } else {
        copies.emplace_back(list, expected);
        if (copies.size() > 3) copies.erase(copies.begin());
      }
      ASSERT_EQ(list.size(), expected.size());
    }
    copies.emplace_back(list, expected);
    for (const auto& [copy, then] : copies) {
      EXPECT_EQ(texts(copy), then);
      EXPECT_EQ(copy == list, then == expected);
      EXPECT_EQ(copy == SharedList<std::string>(then), true);
      EXPECT_EQ(copy.end() - copy.begin(), std::ssize(then));
    }
  }
}

TEST(SharedList, ACopySharesAllButThePiecesThatOneOfThemChanged) {
  SharedList<std::string> list;
  for (std::uint64_t i = 0; i < 900; ++i) list.push_back(text_of(i));
  SharedList<std::string> copy = list;
  for (std::size_t i = 0; i <= 900; ++i) EXPECT_EQ(copy.first_of_its_own(list, i), 900U) << i;
  const std::string *first = &list[0], *near = &list[390], *far = &list[800];
  copy.edit(340) = "other";
  EXPECT_EQ(list[340], text_of(340));
  const std::size_t own = copy.first_of_its_own(list, 0);
  EXPECT_TRUE(own > 300 && own <= 340) << own;
  EXPECT_EQ(copy.first_of_its_own(list, 340), 340U);
  EXPECT_EQ(copy.first_of_its_own(list, 380), 900U);
  EXPECT_EQ(&copy[0], first);
  EXPECT_EQ(&copy[390], near);
  EXPECT_EQ(&copy[800], far);
  copy.push_back(copy[3]);  // an element of its own
  EXPECT_EQ(copy.first_of_its_own(list, 900), 900U);
  EXPECT_EQ(list.first_of_its_own(copy, 901), 901U);
  EXPECT_EQ(copy.back(), text_of(3));
}

TEST(SharedList, WhatACopyHasOfItsOwnIsFoundWhereverItIs) {
  SharedList<std::string> list;
  for (std::uint64_t i = 0; i < 600; ++i) list.push_back(text_of(i));
  for (std::size_t i = 0; i < list.size(); ++i) {
    SharedList<std::string> copy = list;
    copy.edit(i) = text_of(i);
    const std::size_t own = copy.first_of_its_own(list, 0);
    EXPECT_TRUE(own <= i && own + 8 > i) << i << " " << own;
    EXPECT_TRUE(copy == list);
    copy.edit(i) = "other";
    EXPECT_FALSE(copy == list) << i;
  }
}

TEST(SharedList, CopiesOfOneListCanBeChangedInThreadsAtOnce) {
  SharedList<std::string> list;
  for (std::uint64_t i = 0; i < 200; ++i) list.push_back(text_of(i));
  std::vector<SharedList<std::string>> copies(4, list);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < copies.size(); ++t) {
    threads.emplace_back([&copies, t] {
      for (std::size_t i = t; i < 200; i += 4) copies[t].edit(i) = "thread " + std::to_string(t);
    });
  }
  for (auto& thread : threads) thread.join();
  for (std::size_t t = 0; t < copies.size(); ++t) {
    for (std::size_t i = 0; i < 200; ++i)
      EXPECT_EQ(copies[t][i], i % 4 == t ? "thread " + std::to_string(t) : text_of(i));
  }
}

TEST(SharedSet, IsAsASetAndItsCopiesStayWhatTheyWereForAnySeed) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    std::vector<std::string> drawn;
    for (std::uint64_t i = 0; i < rng.below(300); ++i) drawn.push_back(text_of(rng.below(400)));
    std::set<std::string> expected(drawn.begin(), drawn.end());
    SharedSet<std::string> set(drawn);
    std::vector<std::pair<SharedSet<std::string>, std::set<std::string>>> copies{{set, expected}};
    for (int change = 0; change < 800; ++change) {
      const std::string text = text_of(rng.below(400));
      EXPECT_EQ(set.contains(text), expected.contains(text));
      if (rng.chance(seed % 2 == 0 ? 0.6 : 0.4)) {
        EXPECT_EQ(set.insert(text), expected.insert(text).second);
      } else {
        EXPECT_EQ(set.erase(text), expected.erase(text) == 1);
      }
      if (rng.chance(0.01)) copies.emplace_back(set, expected);
      ASSERT_EQ(set.size(), expected.size());
    }
    copies.emplace_back(set, expected);
    for (const auto& [copy, then] : copies) {
      EXPECT_EQ(texts(copy), texts(then));
      EXPECT_EQ(copy == set, then == expected);
      EXPECT_TRUE(copy == SharedSet<std::string>(texts(then))) << "however it is cut into pieces";
      const std::string wanted = text_of(rng.below(400));
      const auto at = copy.partition_point([&](const std::string& one) { return one < wanted; });
      EXPECT_EQ(std::distance(copy.begin(), at), std::distance(then.begin(), then.lower_bound(wanted)));
      auto back = copy.end();
      for (auto there = then.rbegin(); there != then.rend(); ++there) EXPECT_EQ(*--back, *there);
      EXPECT_TRUE(back == copy.begin());
    }
  }
}

TEST(SharedSet, LosesWhatIsErasedAndCanBecomeEmpty) {
  SharedSet<std::string> set{"c", "a", "b", "a"};
  EXPECT_EQ(texts(set), (std::vector<std::string>{"a", "b", "c"}));
  const auto before = set;
  erase_if(set, [](const std::string& text) { return text != "b"; });
  EXPECT_EQ(texts(set), std::vector<std::string>{"b"});
  EXPECT_TRUE(set.erase("b"));
  EXPECT_TRUE(set.empty() && set.begin() == set.end());
  EXPECT_FALSE(set.erase("b"));
  EXPECT_TRUE(set.insert("d"));
  EXPECT_EQ(texts(set), std::vector<std::string>{"d"});
  EXPECT_EQ(before.size(), 3u);
}

}  // namespace
}  // namespace unietp
