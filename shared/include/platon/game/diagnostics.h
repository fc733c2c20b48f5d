#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace platon {

/// An error or a warning about a level text. Line and column count from 1, columns in bytes.
struct Diagnostic {
  int line = 0;
  int column = 0;
  bool error = true;  ///< false for a warning
  std::string message;

  friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

/// `file:line:column: error: message`, as compilers print it.
std::string format(std::string_view file, const Diagnostic& diagnostic);

/// A position in a text, both from 1, columns in bytes.
struct TextPosition {
  int line = 1;
  int column = 1;
};

/// Collects the diagnostics of one text.
class Diagnostics {
 public:
  /// Most diagnostics kept; an error takes the place of a warning when there are more. A hostile text cannot fill
  /// memory with them; no text written by a person has so many.
  static constexpr std::size_t kMax = 20000;

  void error(TextPosition at, std::string message) { add(at, true, std::move(message)); }
  void warning(TextPosition at, std::string message) { add(at, false, std::move(message)); }

  bool hasError() const { return hasError_; }
  /// All diagnostics in the order of the text. When some were dropped, one more at the end says so.
  std::vector<Diagnostic> take();

 private:
  void add(TextPosition at, bool error, std::string message);

  std::vector<Diagnostic> found_;
  std::vector<std::size_t> warnings_;  // indices into found_
  bool hasError_ = false;
  bool full_ = false;
};

/// `text` in quotes for a message: at most 32 bytes; every byte but printable ASCII becomes '?'.
std::string quoted(std::string_view text);

}  // namespace platon
