#include "client/ui/chat_feed.h"

namespace platon {

void ChatFeed::add(const std::string& name, const std::string& text, std::uint32_t emote, double seconds) {
  if (emote > kEmoteNames.size()) return;
  const std::string said = emote == 0 ? ": " + text : std::string(" ") + kEmoteNames[emote - 1].second;
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

}  // namespace platon
