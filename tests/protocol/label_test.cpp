#include "protocol/label.h"

#include <gtest/gtest.h>
#include <utf8proc.h>

#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "platon/game/utf8.h"
#include "tests/support/run/repetitions.h"

namespace platon::label_test {
namespace {

using namespace std::string_literals;

// The text in a normal form of Unicode.
std::string normal(const std::string& text, utf8proc_uint8_t* (*form)(const utf8proc_uint8_t*)) {
  const std::unique_ptr<utf8proc_uint8_t, void (*)(void*)> made(
      form(reinterpret_cast<const utf8proc_uint8_t*>(text.c_str())), std::free);
  return made ? reinterpret_cast<const char*>(made.get()) : "";
}

std::string utf8(char32_t code) {
  utf8proc_uint8_t bytes[4];
  const auto length = utf8proc_encode_char(static_cast<utf8proc_int32_t>(code), bytes);
  return {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(length)};
}

bool alike(const std::string& a, const std::string& b) { return lookAlikeKey(a) == lookAlikeKey(b); }

TEST(Label, AcceptsTextThatCanBeShown) {
  for (const auto& text :
       {""s, "Ann"s, "a b"s, "Łukasz"s, "世界"s, "\xf0\x9f\x8e\xb2"s, "\xef\xbf\xbd"s, "\xf4\x8f\xbf\xbf"s}) {
    EXPECT_TRUE(isLabel(text, 32)) << text;
  }
}

TEST(Label, RefusesControlCharactersLineBreaksAndDirectionMarks) {
  for (const auto& text : {"a\nb"s, "\x1b[31m"s, "a\0b"s, "\x7f"s, "\xc2\x85"s, "\xe2\x80\xa8"s, "\xe2\x80\xae"s,
                           "\xe2\x81\xa6"s, "\xd8\x9c"s, "\t"s}) {
    EXPECT_FALSE(isLabel(text, 32)) << testing::PrintToString(text);
  }
}

TEST(Label, RefusesInvalidUtf8) {
  for (const auto& text : {"\x80"s, "\xc3"s, "\xc3("s, "\xc0\xaf"s, "\xe0\x80\xaf"s, "\xed\xa0\x80"s,
                           "\xf0\x80\x80\xaf"s, "\xf4\x90\x80\x80"s, "\xf8\x88\x80\x80\x80"s, "\xe4\xb8"s, "\xff"s}) {
    EXPECT_FALSE(isLabel(text, 32)) << testing::PrintToString(text);
  }
}

TEST(Label, LimitsTheNumberOfBytes) {
  EXPECT_TRUE(isLabel("1234", 4));
  EXPECT_FALSE(isLabel("12345", 4));
  EXPECT_FALSE(isLabel("世界", 5));
}

TEST(Label, VisibleTextIsKept) {
  for (const auto& text : {""s, "Ann"s, "a b"s, "Łukasz"s, "世界"s, "\U0001f3b2"s, "e\u0301"s, "नमस्ते"s, "ß!?"s}) {
    EXPECT_EQ(visibleLabel(text), text);
  }
}

TEST(Label, InvisibleCharactersAreLeftOut) {
  for (const auto& invisible :
       {"\u200b"s, "\u200d"s, "\u00ad"s, "\ufe0f"s, "\ufeff"s, "\u2060"s, "\u3164"s, "\u115f"s, "\uffa0"s, "\u180e"s,
        "\U000e0041"s, "\ufffc"s, "\ue000"s, "\U0010ffff"s, "\u202e"s, "\u034f"s, "\x7f"s}) {
    EXPECT_EQ(visibleLabel("A" + invisible + "nn"), "Ann") << testing::PrintToString(invisible);
    EXPECT_EQ(visibleLabel(invisible), "") << testing::PrintToString(invisible);
  }
}

TEST(Label, RunsOfSpacesBecomeOne) {
  EXPECT_EQ(visibleLabel("  a \u3000\u00a0 b\u2003"), "a b");
  EXPECT_EQ(visibleLabel("a \u200b b"), "a b");
  EXPECT_EQ(visibleLabel("\u2800 "), "");
}

TEST(Label, CombiningCharactersNeedACharacterBefore) {
  EXPECT_EQ(visibleLabel("\u0301\u20dd"), "");
  EXPECT_EQ(visibleLabel("\u0301a\u0301"), "a\u0301");
  EXPECT_EQ(visibleLabel("a \u0301b"), "a b");
}

TEST(Label, ALetterHasTwoAccents) {
  EXPECT_EQ(visibleLabel("e\u0301\u0302\u0303\u0304\u0305\u0306\u0307\u0308\u030a"), "é\u0302");
  EXPECT_EQ(visibleLabel("é\u0302\u0303o\u0303"), "é\u0302o\u0303") << "it is composed with one";
  EXPECT_EQ(visibleLabel("ế\u0303"), "ế");
  EXPECT_EQ(visibleLabel("A\u20dd\u20de\u20df"), "A\u20dd\u20de") << "marks that enclose";
  EXPECT_EQ(visibleLabel("a\u0308\u0308"), "ä") << "none twice";
  EXPECT_EQ(visibleLabel("ä\u0308"), "ä");
  EXPECT_EQ(visibleLabel("a\u0344\u0301"), "ä\u0301") << "it consists of two";
}

TEST(Label, TheFormOfALetterDoesNotDecideWhichAccentsItHas) {
  const std::string greek = "\u1f82";  // with three accents
  EXPECT_EQ(visibleLabel(greek), greek);
  EXPECT_EQ(visibleLabel("α\u0313\u0300\u0345"), "α\u0313\u0300\u0345");
  EXPECT_EQ(visibleLabel(greek + "\u0301"), greek);
  EXPECT_EQ(visibleLabel("α\u0313\u0300\u0345\u0301"), greek);
  for (const auto& marks : {"\u0323\u0302\u0301"s, "\u0302\u0323\u0301"s, "\u0302\u0301\u0323"s}) {
    EXPECT_EQ(visibleLabel("a" + marks), "ậ") << "they are canonically equivalent";
  }
  EXPECT_EQ(visibleLabel("â\u0301\u0323"), "ậ");
}

// In NFC this note is 12 bytes, and its label has 6.
TEST(Label, ALetterWhoseNfcIsLongerStaysWithinTheLabel) {
  EXPECT_EQ(visibleLabel("\U0001d160\u0301"), "\U0001d160");
  EXPECT_EQ(visibleLabel("\u0958"), "\u0958") << "it is not composed in NFC";
}

// Names in Burmese, Hindi, Tibetan and Vietnamese.
TEST(Label, ALetterHasTheVowelSignsThatItsScriptNeeds) {
  for (const auto& text : {"ကြောင့်"s, "ज़िंदगी"s, "སྒྲུབས"s, "Nguyễn"s}) EXPECT_EQ(visibleLabel(text), text);
  const std::string mai = "\u0e47", others = "\u0e31\u0e34\u0e35\u0e36\u0e37";
  EXPECT_EQ(visibleLabel("ก" + mai + mai + mai), "ก" + mai);
  EXPECT_EQ(visibleLabel("ก" + others), "ก" + others.substr(0, 12));
}

TEST(Label, NormalFormsOfALabelHaveTheSameKey) {
  for (char32_t code = 0; code <= 0x10ffff; ++code) {
    const std::string character = utf8(code);
    if (code == 0 || !utf8proc_codepoint_valid(static_cast<utf8proc_int32_t>(code))) continue;
    if (visibleLabel(character) != character) continue;
    for (auto* const form : {utf8proc_NFD, utf8proc_NFC}) {
      ASSERT_TRUE(alike(character, normal(character, form))) << std::hex << std::uint32_t{code};
    }
  }
}

// Built of what makes trouble: letters that are composed, folded, of full width or ligatures, marks, blanks, and what
// is invisible.
TEST(LabelLaws, HoldForLabelsOfTroublesomeCharacters) {
  static const std::vector<std::string> kParts{
      "a",      "A",      "é",      "e\u0301", "E",      "Ａ",     "ﬁ",      "ß",      "ẞ",      "ς",          "Σ",
      "ᾴ",      "\u1f82", "İ",      "ı",       "ế",      "가",     "ᄀ",     "ᅡ",     "क",      "\u093f",     "\u093c",
      "\u0301", "\u0302", "\u0323", "\u0345",  "\u20dd", "\u0344", "\u200b", "\u200d", "\ufe0f", "\U000e0041", "\u3000",
      " ",      "\u00a8", "½",      "²",       "Ⅳ",      "1",      "\u2800", "👩",      "\ue000", "\u0e47"};
  std::mt19937_64 random(1);
  for (int i = repetitions(20000); i > 0; --i) {
    std::string label;
    for (auto parts = random() % 12; parts > 0; --parts) label += kParts[random() % kParts.size()];
    const std::string visible = visibleLabel(label);
    ASSERT_LE(visible.size(), label.size()) << label;
    ASSERT_TRUE(isLabel(visible, label.size())) << label;
    ASSERT_EQ(visibleLabel(visible), visible) << label;
    ASSERT_EQ(lookAlikeKey(visible), lookAlikeKey(label)) << label;
    for (auto* const form : {utf8proc_NFD, utf8proc_NFC}) {
      ASSERT_EQ(lookAlikeKey(normal(label, form)), lookAlikeKey(label)) << label;
    }
  }
}

TEST(Label, LabelsThatLookAlikeHaveTheSameKey) {
  EXPECT_TRUE(alike("José", "Jose\u0301"));
  EXPECT_TRUE(alike("Ann", "Ａｎｎ"));
  EXPECT_TRUE(alike("fix", "ﬁx"));
  EXPECT_TRUE(alike("Ann2", "Ann²"));
  EXPECT_TRUE(alike("IV", "ⅳ"));
  EXPECT_TRUE(alike("가", "\u1100\u1161")) << "Hangul";
  EXPECT_TRUE(alike("ậ", "a\u0302\u0323")) << "marks in another order";
  EXPECT_TRUE(alike("ᾴ", "α\u0345\u0301"));
  EXPECT_FALSE(alike("Jose", "José"));
  EXPECT_FALSE(alike("Аnn", "Ann")) << "a Cyrillic letter";
  EXPECT_TRUE(alike("Ann", " aNN\u200b"));
  EXPECT_TRUE(alike("ŁUKASZ", "łukasz"));
  EXPECT_TRUE(alike("ΣΟΦΟΣ", "σοφος")) << "a final sigma is a sigma";
  EXPECT_TRUE(alike("ЯНА", "яна"));
  EXPECT_TRUE(alike("STRAẞE", "straße"));
  EXPECT_TRUE(alike("STRASSE", "straße"));
  EXPECT_FALSE(alike("Ann", "Anna"));
  EXPECT_FALSE(alike("A nn", "Ann"));
  EXPECT_FALSE(alike("Ān", "An"));
}

}  // namespace
}  // namespace platon::label_test
