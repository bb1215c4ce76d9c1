#include "audit/text_rank.h"

#include <algorithm>
#include <array>
#include <string>

#include "audit/word_key.h"

namespace unietp {
namespace {

constexpr std::size_t kTextWeights = 1U << 14;
constexpr int kTextPasses = 8;
constexpr float kTextRate = 0.05F;

/// A question of another task whose answer is known.
struct Example {
  const AuditedTask* task = nullptr;
  std::vector<std::uint64_t> words;  // keys, sorted, without repeats
  std::vector<std::uint64_t> grams;  // keys of words and of pairs of neighbors
  float rank = 0.5F, place = 0.5F;
};

std::vector<std::uint64_t> keys_of_words(const AuditedTask& task) {
  std::vector<std::uint64_t> keys;
  for (const std::string& word : task.words) keys.push_back(word_key(word));
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

std::vector<std::uint64_t> keys_of_grams(const AuditedTask& task) {
  std::vector<std::uint64_t> keys;
  for (std::size_t i = 0; i < task.words.size(); ++i) {
    keys.push_back(word_key(task.words[i]));
    if (i > 0) keys.push_back(word_key(task.words[i], keys[keys.size() - 2]));
  }
  return keys;
}

/// nullopt-like: `task` is nullptr when the question is not of that choice.
Example example_of(const AuditedTask& task, const GuessQuestion& question) {
  if (question.choice != GuessChoice::OfKind) return {};
  Example example{&task, keys_of_words(task), keys_of_grams(task), 0, 0};
  float right = 0;
  for (std::size_t i = 0; i < question.options.size(); ++i) {
    if (!question.right[i]) continue;
    example.rank += question.options[i].number_rank;
    example.place += question.options[i].place;
    ++right;
  }
  example.rank /= right;
  example.place /= right;
  return example;
}

double likeness(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
  std::size_t shared = 0, i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (a[i] == b[j])
      ++shared, ++i, ++j;
    else if (a[i] < b[j])
      ++i;
    else
      ++j;
  }
  const std::size_t all = a.size() + b.size() - shared;
  return all == 0 ? 0 : static_cast<double>(shared) / static_cast<double>(all);
}

using TextWeights = std::vector<float>;

float predict(const TextWeights& weights, const std::vector<std::uint64_t>& grams) {
  float sum = 0.5F;
  for (const std::uint64_t gram : grams) sum += weights[gram % kTextWeights];
  return sum;
}

/// Least squares by gradient steps over the examples of the other parts, in order.
TextWeights learn(const std::vector<Example>& examples, std::size_t part) {
  TextWeights weights(kTextWeights, 0);
  for (int pass = 0; pass < kTextPasses; ++pass) {
    for (const Example& example : examples) {
      if (part_of(*example.task) == part || example.grams.empty()) continue;
      const float miss = example.rank - predict(weights, example.grams);
      for (const std::uint64_t gram : example.grams)
        weights[gram % kTextWeights] += kTextRate * miss / static_cast<float>(example.grams.size()) * 4;
    }
  }
  return weights;
}

}  // namespace

std::size_t part_of(const AuditedTask& task) { return word_key(task.home, 1) % kHomeParts; }

void learn_from_texts(std::vector<AuditedTask>& tasks, const std::vector<AuditedTask>& examples) {
  std::vector<Example> known;
  for (const AuditedTask& task : examples) {
    for (const GuessQuestion& question : task.questions) {
      if (auto example = example_of(task, question); example.task != nullptr) known.push_back(std::move(example));
    }
  }
  std::array<TextWeights, kHomeParts> models;
  for (std::size_t part = 0; part < kHomeParts; ++part) models[part] = learn(known, part);
  for (AuditedTask& task : tasks) {
    const auto words = keys_of_words(task);
    const auto grams = keys_of_grams(task);
    for (GuessQuestion& question : task.questions) {
      if (question.choice != GuessChoice::OfKind) continue;
      Example nearest;
      double best = -1;
      for (const Example& one : known) {
        if (one.task->home == task.home) continue;
        const double alike = likeness(words, one.words);
        if (alike > best) best = alike, nearest = one;
      }
      const float rank = predict(models[part_of(task)], grams);
      for (GuessOption& option : question.options) {
        option.expected_rank = nearest.rank;
        option.expected_place = nearest.place;
        option.text_rank = rank;
      }
    }
  }
}

}  // namespace unietp
