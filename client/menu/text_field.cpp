#include "client/menu/text_field.h"

#include <algorithm>
#include <optional>
#include <string>

#include "platon/game/utf8.h"

namespace platon {
namespace {

bool isContinuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u; }

// `codePoint` is valid.
std::string utf8Of(char32_t codePoint) {
  const auto byte = [](char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
  const auto rest = [&](unsigned shift) { return byte(0x80u | ((codePoint >> shift) & 0x3Fu)); };
  if (codePoint < 0x80) return {byte(codePoint)};
  if (codePoint < 0x800) return {byte(0xC0u | (codePoint >> 6u)), rest(0)};
  if (codePoint < 0x10000) return {byte(0xE0u | (codePoint >> 12u)), rest(6), rest(0)};
  return {byte(0xF0u | (codePoint >> 18u)), rest(12), rest(6), rest(0)};
}

bool movesThroughMenu(Key key) {
  switch (key) {
    case Key::kArrowUp:
    case Key::kArrowDown:
    case Key::kEnter:
    case Key::kEscape:
    case Key::kF1:
    case Key::kF3:
    case Key::kF11:
    case Key::kF12:
      return true;
    default:
      return isOfGamepad(key);
  }
}

}  // namespace

void TextField::setText(std::string_view text) {
  text_.clear();
  caret_ = 0;
  insert(text);
}

void TextField::insert(std::string_view text) {
  while (!text.empty()) {
    const std::optional<Utf8Character> character = decodeUtf8(text);
    const std::size_t length = character ? character->length : 1;
    if (character && !isControlCharacter(character->codePoint)) {
      if (text_.size() + length > maxBytes_) return;
      text_.insert(caret_, text.substr(0, length));
      caret_ += length;
    }
    text.remove_prefix(length);
  }
}

bool TextField::handle(const KeyEvent& event, const Clipboard& clipboard) {
  if (event.kind == KeyEvent::Kind::kCharacter) {
    insert(utf8Of(event.character));
    return true;
  }
  if (movesThroughMenu(event.key)) return false;
  if (event.kind != KeyEvent::Kind::kRelease) edit(event, clipboard);
  return true;
}

void TextField::edit(const KeyEvent& event, const Clipboard& clipboard) {
  switch (event.key) {
    case Key::kArrowLeft:
      caret_ = before();
      return;
    case Key::kArrowRight:
      caret_ = after();
      return;
    case Key::kHome:
      caret_ = 0;
      return;
    case Key::kEnd:
      caret_ = text_.size();
      return;
    case Key::kBackspace:
      return eraseBefore();
    case Key::kDelete:
      return eraseAfter();
    case Key::kV:
      if (event.ctrl && clipboard) insert(clipboard());
      return;
    default:
      return;
  }
}

void TextField::eraseBefore() {
  const std::size_t start = before();
  text_.erase(start, caret_ - start);
  caret_ = start;
}

void TextField::eraseAfter() { text_.erase(caret_, after() - caret_); }

std::size_t TextField::before() const {
  std::size_t place = caret_;
  while (place > 0 && isContinuation(text_[--place])) {
  }
  return place;
}

std::size_t TextField::after() const {
  std::size_t place = std::min(caret_ + 1, text_.size());
  while (place < text_.size() && isContinuation(text_[place])) ++place;
  return place;
}

}  // namespace platon
