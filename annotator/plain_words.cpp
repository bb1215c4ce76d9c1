#include "annotator/plain_words.h"

#include <algorithm>
#include <array>

#include "annotator/words_for_reading.h"

namespace unietp {
namespace {

/// Lists as of is_among: a '.' ends a whole word.
constexpr std::array<std::string_view, 9> kPlainWords{
    // articles, pronouns, determiners
    "a. an. the. this. that. these. those. it. its. itself. they. them. their. themselves. i. me. my. mine. myself. "
    "we. "
    "us. our. you. your. yours. he. him. his. she. her. who. whom. whose. which. what. whatever. whichever. one. ones. "
    "another. other. others. each. every. everything. both. either. neither. some. any. all. none. no. such. same. "
    "something. anything. nothing. somewhere. anywhere. somebody. someone. here. there. own. else",
    // be, have, do, and what goes with them
    "be. is. are. am. was. were. been. being. have. has. had. having. do. does. did. doing. done. can. could. may. "
    "might. "
    "must. shall. should. will. would. need. needs. needed. ought. let. lets. let's. i'd. i'll. i'm. it's. that's. "
    "you'd. "
    "you'll. you're. you've. there's. we'd. we're. they're. what's. don't. doesn't. isn't. aren't. won't. can't. s. t. "
    "d. ll. "
    "re",
    // joints of a sentence
    "and. or. but. except. so. if. as. than. then. when. whenever. while. once. until. till. before. after. "
    "afterwards. later. "
    "first. firstly. next. last. lastly. finally. now. again. also. too. even. just. only. still. already. yet. ever. "
    "always. never. not. nor. because. since. for. whether. where. wherever. how. why. though. although. however. "
    "plus. "
    "soon. immediately. straight. eventually. meanwhile. afterward. beforehand. prior. throughout. during. time. "
    "times. "
    "moment. point. whole. end. start. beginning. order. way",
    // prepositions that the goal's relations need not have
    "of. to. at. by. with. without. from. off. out. up. down. over. about. through. across. along. around. away. back. "
    "between. among. via. per. together. apart. aside. on. in. ready",
    // numbers and degrees that other checks hold against the goal
    "zero. two. three. four. five. six. seven. eight. nine. ten. eleven. twelve. couple. pair. few. several. many. "
    "more. "
    "most. much. less. least. fewer. minimum. maximum. exactly. precisely. total. number. single. exact. equal. "
    "enough. "
    "very. quite. rather. really. completely. fully. entirely. properly. nicely. well. carefully. gently. neatly. "
    "quickly. slowly. simply. right. exceed. beyond",
    // courtesy
    "please. kindly. thanks. thank. you. would. mind. like. want. wish. love. hope. appreciate. grateful. glad. nice. "
    "great. good. fine. okay. ok. hey. hi. hello. sorry. help. helpful. favor. favour. wonder. wondering. possible. "
    "able. "
    "sure. certain. care. counts. goal. course. job. task. thing. things. object. objects. item. items. piece. pieces. "
    "stuff",
    // verbs whose sense the goal's relations and states give
    "put. puts. putting. place. places. placed. placing. set. sets. setting. lay. lays. laid. leave. leaves. left. "
    "leaving. move. moves. moved. moving. bring. brings. brought. bringing. take. takes. took. taken. taking. get. "
    "gets. "
    "got. getting. carry. carries. carried. carrying. fetch. fetched. grab. grabbed. pick. picked. picking. transfer. "
    "transferred. relocate. shift. deliver. return. returned. drop. position. positioned. arrange. store. stored. "
    "storing. stow. stowed. keep. keeps. kept. keeping. stay. stays. remain. remains. rest. rests. resting. stand. "
    "stands. standing. sit. sits. sitting. lie. lies. lying. find. finds. found. finding. locate. located. look. "
    "looks. "
    "see. sees. seen. go. goes. going. gone. walk. head. come. comes. reach. visit. search. choose. chosen. select. "
    "use. used. using. make. makes. making. made. ensure. ensures. check. remember. give. given. hand. hands. hold. "
    "work. works. turn. turns. turned. turning. become. becomes. end. ends. finish. finished. complete. proceed. "
    "begin. "
    "try. wait. happen. happens. belong. belongs. contain. contains. containing. hold. holding. located. situated. "
    "ahead. divide. divided. evenly. share. shared. freshly. different. accepted. meant. remove. removed. clear. "
    "cleared. "
    "available. present. require. "
    "required. requires. follow. following. perform. want. wants. wanted",
    // places and kinds that name nothing
    "room. rooms. house. home. apartment. spot. area. side. bottom. content. contents. kind. kinds. type. "
    "sort. color. colour. colored. coloured. size. material. state. condition. possession. nearby. currently. present",
};

constexpr std::string_view kDenials =
    "no. not. never. nothing. none. nobody. nowhere. without. neither. nor. don't. doesn't. isn't. aren't. won't. "
    "can't. "
    "cannot. mustn't. shouldn't. avoid. except. instead. refrain.";

}  // namespace

bool is_plain_word(std::string_view word) {
  return std::any_of(kPlainWords.begin(), kPlainWords.end(),
                     [word](std::string_view list) { return is_among(word, list); });
}

bool is_denial(std::string_view word) { return is_among(word, kDenials); }

}  // namespace unietp
