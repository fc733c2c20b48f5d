#include "client/ui/chat_feed.h"

namespace platon {

void ChatFeed::add(const std::string& name, const std::string& text, std::uint32_t emote, double seconds) {
  if (emote > kEmoteTexts.size()) return;
  const std::string said = emote == 0 ? ": " + text : std::string(" ") + kEmoteTexts[emote - 1].told;
  lines_.push_back({name + said, seconds + kSeconds});
  if (lines_.size() > kMaxLines) lines_.pop_front();
}

std::vector<std::string> ChatFeed::lines(double seconds) const {
  std::vector<std::string> shown;
  for (const Line& line : lines_) {
    if (seconds < line.until) shown.push_back(line.text);
  }
  return shown;
}

std::vector<std::string> ChatFeed::newest() const {
  std::vector<std::string> texts;
  for (auto line = lines_.rbegin(); line != lines_.rend(); ++line) texts.push_back(line->text);
  return texts;
}

void EmoteBubbles::add(std::uint32_t slot, std::uint32_t emote, double seconds) {
  if (emote > 0 && emote <= kEmoteTexts.size()) bubbles_[slot] = {emote, seconds + kSeconds};
}

std::string EmoteBubbles::of(std::uint32_t slot, double seconds) const {
  const auto found = bubbles_.find(slot);
  return found == bubbles_.end() || seconds >= found->second.until ? "" : kEmoteTexts[found->second.emote - 1].shown;
}

}  // namespace platon
