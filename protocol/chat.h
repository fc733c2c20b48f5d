#pragma once

#include <cstdint>
#include <string>

#include "protocol/label.h"
#include "protocol/limits.h"

namespace platon {

/// How much a player may say: a burst, then one text or emote after another at a constant rate.
inline constexpr double kChatBurst = 4;
inline constexpr double kChatsPerSecond = 0.5;

/// What a player says to the others: a text or an emote, not both. Reliable.
struct Chat {
  std::string text{};       ///< a label of 1 … kMaxChatBytes; empty with an emote
  std::uint32_t emote = 0;  ///< 1 … kEmotes; 0 with a text

  friend bool operator==(const Chat&, const Chat&) = default;
};

/// Whether this is one text, or one emote.
inline bool isChat(const Chat& chat) {
  return chat.emote <= kEmotes && isLabel(chat.text, kMaxChatBytes) && chat.text.empty() == (chat.emote != 0);
}

}  // namespace platon
