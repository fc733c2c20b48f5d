#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "client/ui/key.h"

namespace platon {

/// A line of text that the player edits. Counts in bytes of UTF-8; the caret is never inside a character.
class TextField {
 public:
  /// Returns the text of the clipboard.
  using Clipboard = std::function<std::string()>;

  /// Takes at most `maxBytes`.
  explicit TextField(std::size_t maxBytes) : maxBytes_(maxBytes) {}

  const std::string& text() const { return text_; }
  /// Bytes before the caret.
  std::size_t caret() const { return caret_; }
  /// Replaces the text; the caret goes to its end.
  void setText(std::string_view text);
  /// Inserts a text at the caret, as far as it fits. Control characters and malformed bytes are left out.
  void insert(std::string_view text);
  /// Edits the text. Returns false for the keys that move through a menu, which change nothing here.
  bool handle(const KeyEvent& event, const Clipboard& clipboard);

 private:
  void edit(const KeyEvent& event, const Clipboard& clipboard);
  void eraseBefore();
  void eraseAfter();
  std::size_t before() const;
  std::size_t after() const;

  std::size_t maxBytes_;
  std::string text_;
  std::size_t caret_ = 0;
};

}  // namespace platon
