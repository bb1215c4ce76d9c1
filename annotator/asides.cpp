#include "annotator/asides.h"

#include <array>

namespace unietp {
namespace {

constexpr std::array<std::string_view, 24> kBackgrounds{"It has been a long day.",
                                                        "I only got home a few minutes ago.",
                                                        "My sister is going to visit us this evening.",
                                                        "We have been putting this off for a week.",
                                                        "The neighbours were here until late last night.",
                                                        "I have to leave for work soon.",
                                                        "The children are still at school.",
                                                        "My back hurts, so I would rather sit still today.",
                                                        "Nobody has had time for the household lately.",
                                                        "There is a lot to do before the weekend.",
                                                        "I am expecting an important call at any moment.",
                                                        "Last time I did this myself, and it took me half the morning.",
                                                        "The weather is too bad to go out.",
                                                        "We moved in only last month.",
                                                        "I promised to have this done by noon.",
                                                        "My parents are quite particular about such things.",
                                                        "It is quieter here than it usually is.",
                                                        "I did not sleep very well.",
                                                        "Somebody always forgets about this.",
                                                        "We are having friends over tonight.",
                                                        "I will be busy for the next hour or so.",
                                                        "It would be nice to have some time for myself afterwards.",
                                                        "You have been a great help so far.",
                                                        "I never get used to doing this on my own."};

constexpr std::array<std::string_view, 5> kNeverMinds{"never mind", "you can ignore", "pay no attention to",
                                                      "do not bother about", "you need not care about"};

constexpr std::array<std::string_view, 6> kNestedOpenings{
    "i was wondering whether you , who are so much better at this than i am , could",
    "what i would like you to do , once you have had a look around and know what is where , is to",
    "it would help me a lot if you could , as soon as you have a moment that you do not need for anything else ,",
    "because nobody else who lives here ever thinks of it , i would be glad if you could",
    "if it is not too much trouble , which i hope it is not , i would ask you to",
    "since i cannot do it myself , as you may have noticed , i need you to"};

}  // namespace

std::span<const std::string_view> backgrounds() { return kBackgrounds; }
std::span<const std::string_view> never_minds() { return kNeverMinds; }
std::span<const std::string_view> nested_openings() { return kNestedOpenings; }

}  // namespace unietp
