#include "server/base/word_reader.h"

#include <algorithm>

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

void WordReader::skipSpaces() { position_ = std::min(line_.find_first_not_of(kSpaces, position_), line_.size()); }

}  // namespace platon
