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

/// A WordReader that remembers where the last thing it has read begins, for an error there.
struct LineReader {
  WordReader words;
  int column = 1;  ///< of what was read last

  std::string_view next() {
    column = words.column();
    return words.next();
  }
  std::string_view rest() {
    column = words.column();
    return words.rest();
  }
};

}  // namespace platon
