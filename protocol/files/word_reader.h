#pragma once

#include <string>
#include <string_view>

namespace platon {

/// Why a text is refused: a clause that says what is wrong and how to correct it, in printable characters.
struct ParseError {
  std::string what;

  friend bool operator==(const ParseError&, const ParseError&) = default;
};

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

/// Reads the lines of a text, one after the other. They end with LF, or with CR LF; the last one may have no end.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : left_(text) {}

  /// Goes on to the next line. Returns whether there is one.
  bool next();
  /// As next, to the next line that is not empty and does not begin with `#`, spaces aside.
  bool nextEntry();
  /// The line, without its end.
  std::string_view line() const { return line_; }
  /// Its number, from 1.
  int number() const { return number_; }

 private:
  std::string_view left_;
  std::string_view line_;
  int number_ = 0;
};

}  // namespace platon
