#pragma once

#include <string_view>

namespace platon {

/// Reads the words of a line, separated by spaces and tabs.
class WordReader {
 public:
  explicit WordReader(std::string_view line) : line_(line) { skipSpaces(); }

  /// The next word; empty at the end of the line.
  std::string_view peek() const;
  /// The next word, which is then read.
  std::string_view next();
  /// All that has not been read, without spaces around it.
  std::string_view rest() const;
  /// Column of the next word, from 1, in bytes.
  int column() const { return static_cast<int>(position_) + 1; }

 private:
  void skipSpaces();

  std::string_view line_;
  std::size_t position_ = 0;
};

}  // namespace platon
