#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace platon::oracle {

/// The text is no JSON, or not the JSON that was asked for; the message ends with the column.
class JsonError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Walks through one JSON text from front to back without keeping it. The caller says what it expects next; anything
/// else throws JsonError. Knows what traces and reports need: objects, arrays, numbers, strings
/// without escapes.
class JsonReader {
 public:
  /// The text must outlive the reader and what it returns.
  explicit JsonReader(std::string_view text) : text_(text) {}

  std::int64_t integer();
  /// Also one that is not whole.
  double number();
  std::string_view string();

  /// Calls `element()` where each element begins; it must read that element.
  template <typename Element>
  void array(Element element) {
    expect('[');
    if (accept(']')) return;
    do element();
    while (accept(','));
    expect(']');
  }

  /// Calls `member(key)` where each value begins; it must read that value.
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

  /// Nothing but white space may be left.
  void end();

  /// Throws a JsonError about the present column.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  void skipSpace();
  bool accept(char character);
  void expect(char character);

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace platon::oracle
