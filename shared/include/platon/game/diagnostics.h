#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace platon {

/// A fault of a level text, or something odd in it. Line and column count from 1, columns in bytes.
struct Diagnostic {
  int line = 0;
  int column = 0;
  bool error = true;
  std::string message;

  friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

/// As compilers write it: `file:line:column: error: message`.
std::string format(std::string_view file, const Diagnostic& found);

/// Where in a text something stands.
struct TextPosition {
  int line = 1;
  int column = 1;
};

/// Collects all that is found in one text.
class Diagnostics {
 public:
  /// So many are kept that no text written by a person reaches it, and so few that a hostile one cannot fill memory.
  static constexpr std::size_t kMax = 20000;

  void error(TextPosition at, std::string message) { add(at, true, std::move(message)); }
  void warning(TextPosition at, std::string message) { add(at, false, std::move(message)); }

  bool hasError() const { return hasError_; }
  /// Everything found, in the order of the text. The last one says so when there was more than is kept.
  std::vector<Diagnostic> take();

 private:
  void add(TextPosition at, bool error, std::string message);

  std::vector<Diagnostic> found_;
  bool hasError_ = false;
  bool full_ = false;
};

/// `text` in quotes, fit to be printed: at most 32 bytes, all but printable ASCII as '?'.
std::string quoted(std::string_view text);

}  // namespace platon
