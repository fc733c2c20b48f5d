#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "platon/game/diagnostics.h"

namespace platon {

/// A run of bytes without spaces. Columns count bytes from 1.
struct LevelToken {
  std::string_view text;
  int column = 0;
};

/// One line of a level text.
struct LevelLine {
  int number = 0;                  ///< from 1
  std::vector<LevelToken> tokens;  ///< none when a byte among them is forbidden, which has been reported
  bool broken = false;             ///< has such a byte
  int end = 1;                     ///< column behind the last token, or where one would stand
  std::string_view comment;        ///< from the '#' on; empty when there is none
  int commentColumn = 1;
};

/// Splits a level text into lines and tokens: LF or CRLF, spaces and tabs, '#' to the end of the line. A UTF-8 byte
/// order mark at the beginning is passed over and not counted. Control bytes and broken UTF-8 are reported, once a
/// line.
class LevelText {
 public:
  LevelText(std::string_view text, Diagnostics& diagnostics);

  /// The next line; false at the end of the text.
  bool next(LevelLine& line);

  /// Number of the last line given, 1 before the first.
  int lines() const { return number_ == 0 ? 1 : number_; }
  /// Column behind the last byte of that line.
  int endOfLine() const { return endOfLine_; }

 private:
  std::string_view takeLine();
  void checkBytes(std::string_view content, std::size_t tokens, LevelLine& line);

  std::string_view rest_;
  Diagnostics* diagnostics_;
  int number_ = 0;
  int endOfLine_ = 1;
};

}  // namespace platon
