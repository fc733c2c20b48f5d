#include "server/admin/ban_list.h"

#include <gtest/gtest.h>

#include <random>

#include "protocol/label.h"
#include "protocol/limits.h"

namespace platon::ban_list_test {
namespace {

using namespace std::chrono_literals;

const UtcTime kNow = *parseUtcTime("2026-11-22T12:00:00Z");

IpAddress ip(const std::string& text) { return IpAddress::parse(text).value(); }
AddressRange range(const std::string& text) { return std::get<AddressRange>(AddressRange::parse(text)); }
BanList listOf(const std::string& text) { return std::get<BanList>(BanList::parse(text)); }

// Each error as line:column: message.
std::vector<std::string> errorsOf(const std::string& text) {
  const auto parsed = BanList::parse(text);
  std::vector<std::string> errors;
  if (!std::holds_alternative<std::vector<Diagnostic>>(parsed)) return errors;
  for (const Diagnostic& one : std::get<std::vector<Diagnostic>>(parsed)) {
    EXPECT_TRUE(one.error);
    errors.push_back(std::to_string(one.line) + ":" + std::to_string(one.column) + ": " + one.message);
  }
  return errors;
}

TEST(BanList, ReadsRangeExpiryAndReason) {
  const BanList list = listOf(
      "# trolls\n\n192.0.2.7\n 203.0.113.0/24 until 2026-12-01T18:00:00Z threw  things # Ben knows them\n"
      "2001:db8::/32\tuntil 2027-01-01\r\n198.51.100.1 a proxy\r\n");
  const std::vector<Ban> expected{{range("192.0.2.7"), std::nullopt, ""},
                                  {range("203.0.113.0/24"), parseUtcTime("2026-12-01T18:00:00Z"), "threw  things"},
                                  {range("2001:db8::/32"), parseUtcTime("2027-01-01"), ""},
                                  {range("198.51.100.1"), std::nullopt, "a proxy"}};
  EXPECT_EQ(list.bans(), expected);
  EXPECT_EQ(list.size(), 4u);
}

TEST(BanList, ItsTextIsTheTextThatItWasReadFrom) {
  for (const char* text : {"", "\n", "#", "# a\n\n \t\n192.0.2.7   x # y\r\n", "192.0.2.7", "192.0.2.7\n\n\n"}) {
    EXPECT_EQ(listOf(text).text(), text);
  }
}

TEST(BanList, FindsTheBanOfAnAddress) {
  const BanList list = listOf("192.0.2.0/24 a\n2001:db8::/32 b\n");
  ASSERT_TRUE(list.find(ip("192.0.2.99"), kNow));
  EXPECT_EQ(list.find(ip("192.0.2.99"), kNow)->reason, "a");
  EXPECT_EQ(list.find(ip("2001:db8:5::1"), kNow)->reason, "b");
  EXPECT_FALSE(list.find(ip("192.0.3.0"), kNow));
  EXPECT_FALSE(list.find(ip("2001:db9::"), kNow));
  EXPECT_FALSE(BanList().find(ip("192.0.2.99"), kNow));
}

TEST(BanList, ExactLoopbackIsNeverBanned) {
  const BanList list = listOf("0.0.0.0/0\n::/0\n127.0.0.1\n");
  EXPECT_FALSE(list.find(ip("127.0.0.1"), kNow));
  EXPECT_FALSE(list.find(ip("::1"), kNow));
  EXPECT_TRUE(list.find(ip("127.0.0.2"), kNow));
  EXPECT_TRUE(list.find(ip("::2"), kNow));
}

TEST(BanList, ABanEndsAtItsTime) {
  const BanList list = listOf("192.0.2.7 until 2026-11-22T12:00:00Z\n");
  EXPECT_TRUE(list.find(ip("192.0.2.7"), kNow - 1s));
  EXPECT_FALSE(list.find(ip("192.0.2.7"), kNow));
}

TEST(BanList, OfSeveralBansTheOneThatLastsLongestCounts) {
  const BanList list = listOf(
      "192.0.0.0/16 until 2026-11-23 wide\n192.0.2.0/24 until 2026-11-24 longer\n192.0.2.7 until 2026-11-22 over\n");
  EXPECT_EQ(list.find(ip("192.0.2.7"), kNow)->reason, "longer");
  EXPECT_EQ(list.find(ip("192.0.3.7"), kNow)->reason, "wide");
  EXPECT_FALSE(list.find(ip("192.0.2.7"), kNow + 48h));
  EXPECT_EQ(listOf(list.text() + "192.0.2.0/25 ever\n").find(ip("192.0.2.7"), kNow)->reason, "ever");
}

// `find` looks only at the lengths of ranges that occur; compare with asking every ban.
TEST(BanList, FindsTheSameAsAskingEveryBan) {
  std::mt19937 random(7);
  const auto below = [&random](unsigned bound) { return random() % bound; };
  BanList list;
  for (int i = 0; i < 200; ++i) {
    IpAddress address = ip(i % 2 == 0 ? "10.0.0.0" : "fd00::");
    for (std::size_t byte = 13; byte < 16; ++byte) address.bytes[byte] = static_cast<std::uint8_t>(below(4));
    const auto bits = static_cast<unsigned>(104 + below(25));
    list.add({AddressRange::around(address, bits), std::nullopt, std::to_string(i)});
  }
  for (int i = 0; i < 500; ++i) {
    IpAddress address = ip(i % 2 == 0 ? "10.0.0.0" : "fd00::");
    for (std::size_t byte = 13; byte < 16; ++byte) address.bytes[byte] = static_cast<std::uint8_t>(below(5));
    bool banned = false;
    for (const Ban& ban : list.bans()) banned = banned || ban.range.contains(address);
    EXPECT_EQ(list.find(address, kNow) != nullptr, banned) << address.text();
  }
}

TEST(BanList, AddsAtTheEndAndKeepsTheRest) {
  BanList list = listOf("# mine\n192.0.2.7 x");
  list.add({range("192.0.2.8"), kNow, "y"});
  EXPECT_EQ(list.text(), "# mine\n192.0.2.7 x\n192.0.2.8 until 2026-11-22T12:00:00Z y\n");
  EXPECT_EQ(listOf(list.text()), list);
}

TEST(BanList, ReplacesTheBanOfTheSameRangeInItsPlace) {
  BanList list = listOf("192.0.2.7 x  # Ben asked for it\n# end\n");
  list.add({range("192.0.2.7"), std::nullopt, "z"});
  EXPECT_EQ(list.text(), "192.0.2.7 z  # Ben asked for it\n# end\n");
  EXPECT_EQ(list.find(range("192.0.2.7"))->reason, "z");
  EXPECT_EQ(list.size(), 1u);
}

TEST(BanList, RemovesTheLineOfABanAlone) {
  BanList list = listOf("# a\n192.0.2.7\n\n192.0.2.8\n# b\n");
  EXPECT_FALSE(list.remove(range("192.0.2.0/24")));
  EXPECT_TRUE(list.remove(range("192.0.2.7")));
  EXPECT_EQ(list.text(), "# a\n\n192.0.2.8\n# b\n");
  EXPECT_FALSE(list.find(ip("192.0.2.7"), kNow));
  EXPECT_TRUE(list.find(ip("192.0.2.8"), kNow));
  EXPECT_FALSE(list.remove(range("192.0.2.7")));
}

TEST(BanList, RemovesTheBansThatHaveEnded) {
  BanList list = listOf("# a\n192.0.2.7 until 2026-11-22T12:00:00Z\n192.0.2.8 until 2026-11-22T12:00:01Z\n192.0.2.9");
  list.removeEnded(kNow);
  EXPECT_EQ(list.text(), "# a\n192.0.2.8 until 2026-11-22T12:00:01Z\n192.0.2.9");
  list.removeEnded(kNow + 1s);
  EXPECT_EQ(list.text(), "# a\n192.0.2.9");
}

// Found by fuzzing: an empty line at the end without a line feed cannot be told from none.
TEST(BanList, WithoutItsLastLineTheTextEndsWithALineFeed) {
  BanList list = listOf("# a\n\n192.0.2.7");
  EXPECT_TRUE(list.remove(range("192.0.2.7")));
  EXPECT_EQ(list.text(), "# a\n\n");
  EXPECT_EQ(listOf(list.text()), list);
}

TEST(BanList, AnEmptiedListEqualsAnEmptyOne) {
  BanList list = listOf("192.0.2.7");
  EXPECT_TRUE(list.remove(range("192.0.2.7")));
  EXPECT_EQ(list, BanList());
  EXPECT_EQ(list.text(), "");
}

TEST(BanList, ErrorsHaveALineAndAColumn) {
  using Lines = std::vector<std::string>;
  const std::string time = "after 'until' must stand a time in UTC, such as 2026-12-01 or 2026-12-01T18:00:00Z";
  const std::string reason =
      "the reason must have at most 100 bytes of text, without control characters and #, and must not begin with "
      "'until'";
  EXPECT_EQ(errorsOf("192.0.2.7\n  Ann\n"),
            Lines{"2:3: 'Ann' is not an address or a range of addresses, such as 192.0.2.7 or 2001:db8::/32"});
  EXPECT_EQ(errorsOf("192.0.2.7 until tomorrow"), Lines{"1:17: " + time});
  EXPECT_EQ(errorsOf("192.0.2.7 until"), Lines{"1:16: " + time});
  EXPECT_EQ(errorsOf("192.0.2.7 until 2026-12-01 until later"), Lines{"1:28: " + reason});
  EXPECT_EQ(errorsOf("192.0.2.7 a\x07"), Lines{"1:11: " + reason});
  EXPECT_EQ(errorsOf("192.0.2.7 \xff"), Lines{"1:11: " + reason});
  EXPECT_EQ(errorsOf("192.0.2.7 " + std::string(100, 'x')), Lines{});
  EXPECT_EQ(errorsOf("192.0.2.7 " + std::string(101, 'x')), Lines{"1:11: " + reason});
  EXPECT_EQ(errorsOf("192.0.2.7\n#\n192.0.2.7/32 x\nAnn\n").size(), 2u);
  EXPECT_EQ(errorsOf("192.0.2.7\n#\n192.0.2.7/32 x\n"),
            Lines{"3:1: 192.0.2.7 is banned in line 1 already: remove one of the two lines"});
}

TEST(BanList, ReportsAtMost100ErrorsAndThatThereAreMore) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "x\n";
  const std::vector<std::string> errors = errorsOf(text);
  ASSERT_EQ(errors.size(), BanList::kMaxErrors + 1);
  EXPECT_EQ(errors.back(), "100:1: too many errors; fix these first");
}

TEST(BanList, RefusesATextThatIsTooLong) {
  EXPECT_EQ(errorsOf(std::string(BanList::kMaxBytes, '\n')), std::vector<std::string>{});
  EXPECT_EQ(errorsOf(std::string(BanList::kMaxBytes + 1, '\n')),
            std::vector<std::string>{"1:1: the file has more than 1048576 bytes"});
}

TEST(BanReason, LosesTheSpacesAroundIt) {
  EXPECT_EQ(std::get<std::string>(parseBanReason("  too  loud ")), "too  loud");
  EXPECT_EQ(std::get<std::string>(parseBanReason("")), "");
}

TEST(BanReason, CannotBeReadAsAnotherPartOfTheLine) {
  EXPECT_TRUE(std::holds_alternative<ParseError>(parseBanReason(" until tomorrow")));
  EXPECT_TRUE(std::holds_alternative<ParseError>(parseBanReason("a # b")));
  EXPECT_TRUE(std::holds_alternative<ParseError>(parseBanReason("a\nb")));
  EXPECT_TRUE(std::holds_alternative<std::string>(parseBanReason("untilted")));
}

TEST(Ban, TheSentenceForThePlayerIsALabel) {
  EXPECT_EQ(refusalOf({range("192.0.2.7"), std::nullopt, ""}), "you are banned from this server");
  const Ban longest{range("192.0.2.7"), kNow, std::string(Ban::kMaxReasonBytes, 'x')};
  EXPECT_EQ(refusalOf(longest),
            "you are banned from this server until 2026-11-22T12:00:00Z: " + std::string(Ban::kMaxReasonBytes, 'x'));
  EXPECT_TRUE(isLabel(refusalOf(longest), kMaxReasonBytes));
}

}  // namespace
}  // namespace platon::ban_list_test
