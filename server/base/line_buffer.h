#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace platon {

/// Cuts a stream of bytes into lines of bounded length.
class LineBuffer {
 public:
  /// `maxBytes`: longest line, without its line feed.
  explicit LineBuffer(std::size_t maxBytes) : maxBytes_(maxBytes) {}

  void add(std::string_view bytes) { bytes_ += bytes; }
  /// The next complete line without its line feed and a carriage return before it. Nothing while it is incomplete, and
  /// once a line is too long.
  std::optional<std::string> next();
  /// Whether `next` returns a line.
  bool ready() const;
  /// Whether the next line is too long, complete or not.
  bool tooLong() const;

 private:
  std::size_t maxBytes_;
  std::string bytes_;
};

}  // namespace platon
