#include "platon/game/utf8.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace platon::utf8_test {
namespace {

using namespace std::string_literals;

// The reference encoder of RFC 3629, section 3; also encodes surrogates and values above U+10FFFF.
std::string encoded(char32_t codePoint) {
  const auto byte = [](char32_t value) { return static_cast<char>(static_cast<unsigned char>(value)); };
  const auto continuation = [&](int shift) { return byte(0x80 | ((codePoint >> shift) & 0x3f)); };
  if (codePoint < 0x80) return {byte(codePoint)};
  if (codePoint < 0x800) return {byte(0xc0 | codePoint >> 6), continuation(0)};
  if (codePoint < 0x10000) return {byte(0xe0 | codePoint >> 12), continuation(6), continuation(0)};
  return {byte(0xf0 | codePoint >> 18), continuation(12), continuation(6), continuation(0)};
}

bool isMalformed(std::string_view text) { return !decodeUtf8(text).has_value(); }

// All code points of a text, by takeCodePoint.
std::u32string codePoints(std::string_view text) {
  std::u32string all;
  while (!text.empty()) all.push_back(takeCodePoint(text));
  return all;
}

TEST(Utf8Test, DecodesEveryCodePoint) {
  for (char32_t codePoint = 0; codePoint <= 0x10ffff; ++codePoint) {
    if (codePoint == 0xd800) codePoint = 0xe000;
    const std::string text = encoded(codePoint);
    const auto character = decodeUtf8(text);
    ASSERT_TRUE(character) << static_cast<std::uint32_t>(codePoint);
    ASSERT_EQ(character->codePoint, codePoint);
    ASSERT_EQ(character->length, text.size());
  }
}

TEST(Utf8Test, DecodesOnlyTheFirstCharacter) {
  const auto character = decodeUtf8("\xc3\x84pfel");
  ASSERT_TRUE(character);
  EXPECT_EQ(character->codePoint, U'Ä');
  EXPECT_EQ(character->length, 2u);
  EXPECT_EQ(decodeUtf8("a\xff")->codePoint, U'a');
}

TEST(Utf8Test, RefusesAnEmptyText) { EXPECT_TRUE(isMalformed("")); }

TEST(Utf8Test, RefusesBytesThatStartNoSequence) {
  for (int lead = 0x80; lead <= 0xff; ++lead) {
    if (lead >= 0xc2 && lead <= 0xf4) continue;
    EXPECT_TRUE(isMalformed(static_cast<char>(lead) + "\x80\x80\x80"s)) << lead;
  }
}

TEST(Utf8Test, RefusesOverlongForms) {
  // The smallest and the largest overlong form of two, three and four bytes; then the first values that need as many.
  for (const char* text :
       {"\xc0\x80", "\xc1\xbf", "\xe0\x80\x80", "\xe0\x9f\xbf", "\xf0\x80\x80\x80", "\xf0\x8f\xbf\xbf"}) {
    EXPECT_TRUE(isMalformed(text)) << testing::PrintToString(text);
  }
  EXPECT_EQ(decodeUtf8("\xc2\x80")->codePoint, 0x80u);
  EXPECT_EQ(decodeUtf8("\xe0\xa0\x80")->codePoint, 0x800u);
  EXPECT_EQ(decodeUtf8("\xf0\x90\x80\x80")->codePoint, 0x10000u);
}

TEST(Utf8Test, RefusesSurrogates) {
  EXPECT_EQ(decodeUtf8("\xed\x9f\xbf")->codePoint, 0xd7ffu);
  for (char32_t surrogate = 0xd800; surrogate < 0xe000; ++surrogate) {
    ASSERT_TRUE(isMalformed(encoded(surrogate))) << static_cast<std::uint32_t>(surrogate);
  }
  EXPECT_EQ(decodeUtf8("\xee\x80\x80")->codePoint, 0xe000u);
}

TEST(Utf8Test, RefusesValuesAbove10FFFF) {
  EXPECT_EQ(decodeUtf8("\xf4\x8f\xbf\xbf")->codePoint, 0x10ffffu);
  EXPECT_TRUE(isMalformed("\xf4\x90\x80\x80"));
  EXPECT_TRUE(isMalformed("\xf5\x80\x80\x80"));
  EXPECT_TRUE(isMalformed("\xf7\xbf\xbf\xbf"));
}

TEST(Utf8Test, RefusesTruncatedSequences) {
  for (const char32_t codePoint : {U'é', U'€', U'😀'}) {
    const std::string text = encoded(codePoint);
    for (std::size_t length = 1; length < text.size(); ++length) {
      EXPECT_TRUE(isMalformed(text.substr(0, length))) << length << " of " << text.size() << " bytes";
      EXPECT_TRUE(isMalformed(text.substr(0, length) + "a")) << "an ASCII byte in place of a continuation byte";
      EXPECT_TRUE(isMalformed(text.substr(0, length) + "\xc3")) << "a lead byte in place of a continuation byte";
    }
  }
}

TEST(Utf8Test, TakesOneCharacterAfterAnother) {
  EXPECT_EQ(codePoints("aé€😀"), U"aé€😀");
  EXPECT_EQ(codePoints("a\0b"s), U"a\0b"s) << "U+0000 ends no text";
}

TEST(Utf8Test, ReplacesEachMalformedByte) {
  EXPECT_EQ(codePoints("a\x80z"), U"a\xfffdz");
  EXPECT_EQ(codePoints("\xe2\x82"), U"\xfffd\xfffd") << "truncated: one replacement per byte";
  EXPECT_EQ(codePoints("\xe2\x82z"), U"\xfffd\xfffdz");
  EXPECT_EQ(codePoints("\xed\xa0\x80"), U"\xfffd\xfffd\xfffd") << "a surrogate";
  EXPECT_EQ(codePoints("\xff\xc3\xa9"), U"\xfffdé") << "decoding continues with the next byte";
  EXPECT_EQ(codePoints("\xef\xbf\xbd"), U"\xfffd") << "U+FFFD itself is well-formed";
}

TEST(Utf8Test, ControlCharactersAreC0DeleteAndC1) {
  for (char32_t codePoint = 0; codePoint < 0x200; ++codePoint) {
    const bool control = codePoint <= 0x1f || (codePoint >= 0x7f && codePoint <= 0x9f);
    EXPECT_EQ(isControlCharacter(codePoint), control) << static_cast<std::uint32_t>(codePoint);
  }
}

}  // namespace
}  // namespace platon::utf8_test
