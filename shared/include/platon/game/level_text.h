#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace platon {

/// A word of a text line. Columns count bytes from 1.
struct LevelToken {
  std::string_view text;
  int column = 0;
};

/// One text line of a level, valid or not. Words and comment are parts of `text`, so that the line can be changed with
/// everything else kept.
struct LevelLine {
  enum class Role : std::uint8_t {
    kNone,      ///< has no words
    kHeader,    ///< one of the first kHeaderLines
    kFaceMark,  ///< begins the segments of a face: '%'
    kSegment    ///< any other: x0 y0 x1 y1 and its words
  };
  /// The first byte that no level may have: a control character or malformed UTF-8.
  struct Fault {
    int column = 0;
    bool inComment = false;
    std::string message;
  };
  /// The solid, the start, the goal and the face size. A face mark ends the header, whatever is missing.
  static constexpr std::size_t kHeaderLines = 4;

  int number = 0;  ///< from 1
  std::string_view
      text;  ///< all of it, with its line end; that of the first line begins with a byte order mark, if any
  std::vector<LevelToken> tokens;
  int end = 1;               ///< column after the last token
  std::string_view comment;  ///< from the '#' on, without the line end; empty when there is none
  int commentColumn = 1;
  std::optional<Fault> fault;
  Role role = Role::kNone;
  int face = -1;  ///< of kFaceMark and kSegment, from 0; -1 before the first face mark

  /// Whether its words mean nothing because of a fault.
  bool isUnreadable() const { return fault && !fault->inComment; }
};

/// Splits one text line into its parts. Lines end with LF or CRLF, spaces and tabs separate tokens, '#' starts a
/// comment. Number, role and face are left as they are in a new LevelLine.
LevelLine splitLevelLine(std::string_view line);

/// Splits a level text into lines, and says what each is. What the lines mean is for the reader of levels; what is
/// changed in them, for an editor. The texts of all lines, one after the other, are the level text. A UTF-8 byte order
/// mark at the beginning is skipped; a text that is nothing else has no lines.
class LevelText {
 public:
  explicit LevelText(std::string_view text) : rest_(text) {}

  /// Reads the next line; false at the end of the text.
  bool next(LevelLine& line);

  /// Number of the last line read; 1 before the first.
  int lines() const { return number_ == 0 ? 1 : number_; }
  /// Column after the last byte of that line.
  int endOfLine() const { return endOfLine_; }
  /// Number of face marks read so far.
  int faces() const { return faces_; }

 private:
  std::string_view rest_;
  int number_ = 0;
  int endOfLine_ = 1;
  std::size_t header_ = 0;  // header lines read so far
  int faces_ = 0;
};

}  // namespace platon
