#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace platon::oracle {

/// The text is not JSON, or not the expected JSON. The message ends with the column.
class JsonError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Pull parser for one JSON text. The caller asks for the value it expects next; anything else throws JsonError.
/// Supports objects, arrays, numbers, and strings without escapes.
class JsonReader {
 public:
  /// The text must outlive the reader and the strings that it returns.
  explicit JsonReader(std::string_view text) : text_(text) {}

  std::int64_t integer();
  /// Any finite number.
  double number();
  std::string_view string();

  /// Calls `element()` at each element; it must read that element.
  template <typename Element>
  void array(Element element) {
    expect('[');
    if (accept(']')) return;
    do element();
    while (accept(','));
    expect(']');
  }

  /// Calls `member(key)` at each value; it must read that value.
  template <typename Member>
  void object(Member member) {
    expect('{');
    if (accept('}')) return;
    do {
      const std::string_view key = string();
      expect(':');
      member(key);
    } while (accept(','));
    expect('}');
  }

  /// Expects the end of the text, after optional white space.
  void end();

  /// Throws a JsonError that names the current column.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  void skipSpace();
  bool accept(char character);
  void expect(char character);

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace platon::oracle
