#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "platon/game/diagnostics.h"

namespace platon {

/// A word of a line. Columns count bytes from 1.
struct LevelToken {
  std::string_view text;
  int column = 0;
};

/// One line of a level text.
struct LevelLine {
  int number = 0;                  ///< line number, from 1
  std::vector<LevelToken> tokens;  ///< empty when the line is invalid
  bool invalid = false;            ///< has a control character or malformed UTF-8 before the comment
  int end = 1;                     ///< column after the last token
  std::string_view comment;        ///< from the '#' on; empty when there is none
  int commentColumn = 1;
};

/// Splits a level text into lines and tokens. Lines end with LF or CRLF, spaces and tabs separate tokens, '#' starts a
/// comment. A UTF-8 byte order mark at the beginning is skipped. Reports the first control character or malformed UTF-8
/// of each line.
class LevelText {
 public:
  LevelText(std::string_view text, Diagnostics& diagnostics);

  /// Reads the next line; false at the end of the text.
  bool next(LevelLine& line);

  /// Number of the last line read; 1 before the first.
  int lines() const { return number_ == 0 ? 1 : number_; }
  /// Column after the last byte of that line.
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
