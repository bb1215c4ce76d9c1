#include "akb/wordnet.h"

#include "akb/wordnet_words.h"
#include "bodies.h"
#include "fuzz_bodies.h"
#include "support.h"

namespace unietp::fuzz {

bool wordnet_body(std::string_view text) {
  static const Folder folder("wordnet");
  constexpr std::string_view kBetween = "====\n";
  const std::size_t end = text.find(kBetween);
  folder.write("index.noun", text.substr(0, end));
  folder.write("data.noun", end == std::string_view::npos ? "" : text.substr(end + kBetween.size()));
  const auto counts = WordNet::read(folder.path());
  const auto words = WordNetWords::read(folder.path());
  require(counts && words);
  for (const char* synset : {"mug.n.01", "mug.n.04", "sofa.n.01", "coffee_mug.n.01", "mug", ".n.1", "mug.n.99"}) {
    (void)counts->has(synset);
    if (!words->has(synset)) require(words->usual_words(synset).empty());
    for (const std::string& word : words->usual_words(synset))
      require(word.find_first_not_of("abcdefghijklmnopqrstuvwxyz -") == std::string::npos);
  }
  return counts->has("mug.n.04") && !words->usual_words("sofa.n.01").empty();
}

}  // namespace unietp::fuzz
