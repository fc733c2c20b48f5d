#include "tests/exactness/oracle/trace/json_reader.h"

#include <charconv>
#include <cmath>

namespace platon::oracle {

void JsonReader::fail(const std::string& what) const {
  throw JsonError(what + " at column " + std::to_string(at_ + 1));
}

void JsonReader::skipSpace() {
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r')) ++at_;
}

bool JsonReader::accept(char character) {
  skipSpace();
  if (at_ >= text_.size() || text_[at_] != character) return false;
  ++at_;
  return true;
}

void JsonReader::expect(char character) {
  if (!accept(character)) fail(std::string("'") + character + "' expected");
}

std::int64_t JsonReader::integer() {
  skipSpace();
  const char* const begin = text_.data() + at_;
  const char* const limit = text_.data() + text_.size();
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(begin, limit, value);
  if (error != std::errc{}) fail("whole number expected");
  const char* const digits = begin + (*begin == '-');
  if (*digits == '0' && end != digits + 1) fail("number with a leading zero");
  if (end != limit && (*end == '.' || *end == 'e' || *end == 'E')) fail("number that is not whole");
  at_ += static_cast<std::size_t>(end - begin);
  return value;
}

double JsonReader::number() {
  skipSpace();
  const char* const begin = text_.data() + at_;
  double value = 0;
  const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) fail("number expected");
  at_ += static_cast<std::size_t>(end - begin);
  return value;
}

std::string_view JsonReader::string() {
  expect('"');
  const std::size_t begin = at_;
  while (at_ < text_.size() && text_[at_] != '"') {
    if (text_[at_] == '\\' || static_cast<unsigned char>(text_[at_]) < ' ') fail("escape or control character");
    ++at_;
  }
  if (at_ == text_.size()) fail("string without an end");
  return text_.substr(begin, at_++ - begin);
}

void JsonReader::end() {
  skipSpace();
  if (at_ != text_.size()) fail("end of the line expected");
}

}  // namespace platon::oracle
