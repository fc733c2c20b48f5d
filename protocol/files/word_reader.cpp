#include "protocol/files/word_reader.h"

#include <algorithm>
#include <cstddef>

namespace platon {
namespace {

constexpr std::string_view kSpaces = " \t";

}  // namespace

std::string_view WordReader::peek() const {
  const std::string_view left = line_.substr(position_);
  return left.substr(0, left.find_first_of(kSpaces));
}

std::string_view WordReader::next() {
  const std::string_view word = peek();
  position_ += word.size();
  skipSpaces();
  return word;
}

std::string_view WordReader::rest() const {
  const std::string_view left = line_.substr(position_);
  return left.substr(0, left.find_last_not_of(kSpaces) + 1);
}

bool TextLines::next() {
  if (left_.empty()) return false;
  const std::size_t end = std::min(left_.find('\n'), left_.size());
  line_ = left_.substr(0, end);
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  left_.remove_prefix(std::min(end + 1, left_.size()));
  ++number_;
  return true;
}

bool TextLines::nextEntry() {
  while (next()) {
    const std::string_view first = WordReader(line_).peek();
    if (!first.empty() && !first.starts_with('#')) return true;
  }
  return false;
}

void WordReader::skipSpaces() { position_ = std::min(line_.find_first_not_of(kSpaces, position_), line_.size()); }

}  // namespace platon
