#include "evaluation/conversation.h"

#include <algorithm>
#include <utility>

#include "core/png.h"
#include "environment/agent_text.h"

namespace unietp {

Result<Done> Conversation::see(const Environment& environment) {
  const Observation& seen = environment.observe();
  if (!past_.empty()) past_.back().results = seen.results;
  if (talk_->images == 0 || !seen.has_picture) return Done{};
  const Picture picture = environment.picture();
  auto bytes = png(picture.width, picture.height, picture.rgb);
  if (!bytes) return bytes.error();
  pictures_.push_back(std::make_shared<const std::string>(std::move(*bytes)));
  if (pictures_.size() > static_cast<std::size_t>(talk_->images)) pictures_.pop_front();
  return Done{};
}

/// What the model is told now, without the turns before.
ChatTurn Conversation::present_turn(const Environment& environment) const {
  ChatTurn turn;
  if (talk_->multi) {
    if (!pictures_.empty()) turn.pictures = {pictures_.back()};
  } else {
    turn.pictures = {pictures_.begin(), pictures_.end()};
  }
  turn.text = filled(prompt_->turn, {&environment, talk_, &past_, turn.pictures.size()});
  return turn;
}

Result<std::vector<ChatTurn>> Conversation::turns(const Environment& environment) {
  if (auto done = see(environment); !done) return done.error();
  if (past_.empty()) {
    system_ = filled(prompt_->system, {&environment, talk_, &past_, 0});
    task_ = task_text(environment.observe().instruction);
  }
  std::vector<ChatTurn> turns;
  if (!system_.empty()) turns.push_back({ChatTurn::Role::System, system_, {}});
  ChatTurn present = present_turn(environment);
  if (talk_->multi) {
    user_turns_.push_back(present.text);
    const std::size_t all = past_.size();
    const std::size_t again = talk_->history < 0 ? all : std::min(all, static_cast<std::size_t>(talk_->history));
    const std::size_t first = all - again;
    for (std::size_t i = first; i < all; ++i) {
      ChatTurn user{ChatTurn::Role::User, user_turns_[i], {}};
      const std::size_t back = all - i;  // steps ago; the present picture is the last of pictures_
      if (back < pictures_.size()) user.pictures = {pictures_[pictures_.size() - 1 - back]};
      turns.push_back(std::move(user));
      turns.push_back({ChatTurn::Role::Assistant, past_[i].reply, {}});
    }
    // The task stands in the first turn, which is left out.
    if (first > 0) {
      ChatTurn& earliest = again > 0 ? turns[turns.size() - 2 * again] : present;
      earliest.text = task_ + (earliest.text.empty() ? "" : "\n" + earliest.text);
    }
  }
  turns.push_back(std::move(present));
  return turns;
}

void Conversation::answered(std::string reply) { past_.push_back({std::move(reply), {}}); }

std::string display_text(const std::vector<ChatTurn>& turns) {
  std::string text;
  for (const ChatTurn& turn : turns) {
    text += turn.role == ChatTurn::Role::System ? "[system]\n"
            : turn.role == ChatTurn::Role::User ? "[user]\n"
                                                : "[assistant]\n";
    for (const auto& picture : turn.pictures) text += "[picture, " + std::to_string(picture->size()) + " bytes]\n";
    text += turn.text + "\n";
  }
  return text;
}

}  // namespace unietp
