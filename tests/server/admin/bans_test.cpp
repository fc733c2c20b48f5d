#include "server/admin/bans.h"

#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "protocol/label.h"
#include "protocol/limits.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_levels.h"
#include "tests/support/wait_until.h"

namespace platon::bans_test {
namespace {

IpAddress ip(const std::string& text) { return IpAddress::parse(text).value(); }
AddressRange range(const std::string& text) { return std::get<AddressRange>(AddressRange::parse(text)); }

std::string errorOf(std::string_view text) {
  const auto parsed = AddressRange::parse(text);
  const auto* error = std::get_if<ParseError>(&parsed);
  return error ? error->what : "none";
}

TEST(AddressRange, HoldsTheAddressesWithItsFirstBits) {
  EXPECT_TRUE(range("192.0.2.0/24").contains(ip("192.0.2.255")));
  EXPECT_FALSE(range("192.0.2.0/24").contains(ip("192.0.3.0")));
  EXPECT_TRUE(range("192.0.2.128/25").contains(ip("192.0.2.200")));
  EXPECT_FALSE(range("192.0.2.128/25").contains(ip("192.0.2.127")));
  EXPECT_TRUE(range("2001:db8::/33").contains(ip("2001:db8:7fff::1")));
  EXPECT_FALSE(range("2001:db8::/33").contains(ip("2001:db8:8000::1")));
}

TEST(AddressRange, ASingleAddressHoldsOnlyItself) {
  EXPECT_EQ(range("192.0.2.7"), range("192.0.2.7/32"));
  EXPECT_EQ(range("2001:db8::1"), range("2001:db8::1/128"));
  EXPECT_TRUE(range("192.0.2.7").contains(ip("192.0.2.7")));
  EXPECT_FALSE(range("192.0.2.7").contains(ip("192.0.2.6")));
}

TEST(AddressRange, RangesOfOneFamilyHoldNoneOfTheOther) {
  EXPECT_TRUE(range("0.0.0.0/0").contains(ip("255.255.255.255")));
  EXPECT_FALSE(range("0.0.0.0/0").contains(ip("::1")));
  EXPECT_TRUE(range("::/0").contains(ip("ffff::1")));
  EXPECT_FALSE(range("::/0").contains(ip("192.0.2.7")));
}

TEST(AddressRange, AnIpv4AddressInIpv6FormIsAnIpv4Address) {
  EXPECT_EQ(range("::ffff:192.0.2.0/120"), range("192.0.2.0/24"));
  EXPECT_EQ(range("::ffff:192.0.2.7"), range("192.0.2.7"));
}

TEST(AddressRange, TheHouseholdOfAnIpv6AddressIsItsFirst64Bits) {
  EXPECT_EQ(AddressRange::householdOf(ip("192.0.2.7")), range("192.0.2.7"));
  EXPECT_EQ(AddressRange::householdOf(ip("2001:db8:1:2:3:4:5:6")), range("2001:db8:1:2::/64"));
}

TEST(AddressRange, TheHouseholdOfATranslatedAddressIsThisOne) {
  EXPECT_EQ(AddressRange::householdOf(ip("64:ff9b::192.0.2.7")), range("64:ff9b::c000:207"));
}

TEST(AddressRange, ParsingReversesTheText) {
  for (const char* text : {"192.0.2.7", "192.0.2.0/24", "0.0.0.0/0", "10.0.0.0/8", "2001:db8::1", "2001:db8::/32",
                           "::/0", "fe80::/10", "255.255.255.254/31"}) {
    EXPECT_EQ(range(text).text(), text);
  }
}

TEST(AddressRange, EveryRangeAroundAnAddressHoldsItAndHasAText) {
  for (const char* text : {"203.0.113.77", "2001:db8:ffff:1234:5678:9abc:def0:1234"}) {
    const unsigned least = ip(text).isIpv4() ? AddressRange::kIpv4Bits : 0;
    for (unsigned bits = least; bits <= AddressRange::kBits; ++bits) {
      const AddressRange around = AddressRange::around(ip(text), bits);
      EXPECT_TRUE(around.contains(ip(text))) << around.text();
      EXPECT_EQ(range(around.text()), around);
    }
  }
}

TEST(AddressRange, SaysWhatIsWrong) {
  const std::string noAddress =
      " is not an address or a range of addresses; write one such as 192.0.2.7 or 2001:db8::/32";
  EXPECT_EQ(errorOf("Ann"), "'Ann'" + noAddress);
  EXPECT_EQ(errorOf(""), "''" + noAddress);
  EXPECT_EQ(errorOf("192.0.2"), "'192.0.2'" + noAddress);
  EXPECT_EQ(errorOf("192.0.2.7.1/8"), "'192.0.2.7.1/8'" + noAddress);
  EXPECT_EQ(errorOf("fe80::1%eth0"), "'fe80::1%eth0'" + noAddress);
  EXPECT_EQ(errorOf(std::string_view("192.0.2.7\0x", 11)), "'192.0.2.7?x'" + noAddress);
  EXPECT_EQ(errorOf("192.0.2.0/33"), "the number after the / of '192.0.2.0/33' must be 0 to 32");
  EXPECT_EQ(errorOf("2001:db8::/129"), "the number after the / of '2001:db8::/129' must be 0 to 128");
  for (const char* text : {"192.0.2.0/", "192.0.2.0/-1", "192.0.2.0/+8", "192.0.2.0/8x", "192.0.2.0/8/8"}) {
    EXPECT_TRUE(errorOf(text).ends_with(" must be 0 to 32")) << text;
  }
  EXPECT_EQ(errorOf("192.0.2.7/24"), "'192.0.2.7/24' has bits set after its first 24: write 192.0.2.0/24");
  EXPECT_EQ(errorOf("2001:db8::1/32"), "'2001:db8::1/32' has bits set after its first 32: write 2001:db8::/32");
  EXPECT_EQ(errorOf("::ffff:0:0/80"), "'::ffff:0:0/80' has bits set after its first 80: write ::/80");
}

using namespace std::chrono_literals;

const UtcTime kNow = *parseUtcTime("2026-11-22T12:00:00Z");

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
  const std::string time = "'until' must be followed by a time in UTC, such as 2026-12-01 or 2026-12-01T18:00:00Z";
  const std::string reason =
      "the reason must have at most 100 bytes of text, without control characters or #, and must not begin with "
      "'until'";
  EXPECT_EQ(
      errorsOf("192.0.2.7\n  Ann\n"),
      Lines{"2:3: 'Ann' is not an address or a range of addresses; write one such as 192.0.2.7 or 2001:db8::/32"});
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

constexpr FileWriter::Time kMoment{std::chrono::hours(1)};

Ban banOf(const std::string& text) { return {range(text), std::nullopt, "x"}; }

class BanStoreTest : public testing::Test {
 protected:
  BanStore open(const std::string& text) {
    writeText(path_, text);
    return BanStore(path_, std::get<BanList>(readBanFile(path_)));
  }

  // Polls until the file has this content.
  bool writes(BanStore& store, const std::string& text) const {
    return stepUntil([&] { EXPECT_EQ(store.poll(kMoment), std::nullopt); }, [&] { return readText(path_) == text; });
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "bans.txt";
};

TEST_F(BanStoreTest, WithoutAFileItKeepsBansInMemory) {
  BanStore store;
  EXPECT_FALSE(store.hasFile());
  EXPECT_EQ(store.add(banOf("192.0.2.7"), kNow), std::nullopt);
  EXPECT_TRUE(store.list().find(range("192.0.2.7")));
  EXPECT_EQ(store.replace(BanList()), std::nullopt);  // a reload has no file to read
  EXPECT_EQ(store.list().size(), 1u);
  EXPECT_EQ(store.remove(range("192.0.2.7"), kNow), std::nullopt);
  EXPECT_EQ(store.list().size(), 0u);
}

TEST_F(BanStoreTest, WritesAChangeAndKeepsComments) {
  BanStore store = open("# mine\n192.0.2.7\n");
  EXPECT_EQ(store.add(banOf("192.0.2.8"), kNow), std::nullopt);
  EXPECT_TRUE(writes(store, "# mine\n192.0.2.7\n192.0.2.8 x\n"));
  EXPECT_EQ(store.remove(range("192.0.2.7"), kNow), std::nullopt);
  EXPECT_TRUE(writes(store, "# mine\n192.0.2.8 x\n"));
}

TEST_F(BanStoreTest, AChangeDropsTheBansThatHaveEnded) {
  BanStore store = open("192.0.2.7 until 2026-11-01\n192.0.2.9\n");
  EXPECT_EQ(store.add(banOf("192.0.2.8"), kNow), std::nullopt);
  EXPECT_TRUE(writes(store, "192.0.2.9\n192.0.2.8 x\n"));
}

TEST_F(BanStoreTest, KeepsWhatWasEditedMeanwhile) {
  BanStore store = open("192.0.2.7\n");
  writeText(path_, "192.0.2.7\n203.0.113.0/24 edited\n");
  EXPECT_EQ(store.add(banOf("192.0.2.8"), kNow), std::nullopt);
  EXPECT_TRUE(store.list().find(range("203.0.113.0/24")));
  EXPECT_TRUE(writes(store, "192.0.2.7\n203.0.113.0/24 edited\n192.0.2.8 x\n"));
}

TEST_F(BanStoreTest, ChangesNothingWhileTheFileHasAnError) {
  BanStore store = open("192.0.2.7\n");
  writeText(path_, "192.0.2.7\nAnn\n");
  const auto error = store.add(banOf("192.0.2.8"), kNow);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->what, path_ +
                             ":2:1: error: 'Ann' is not an address or a range of addresses; write one such as "
                             "192.0.2.7 or 2001:db8::/32; nothing has changed: correct the file first");
  EXPECT_TRUE(store.remove(range("192.0.2.7"), kNow));
  EXPECT_EQ(store.list().size(), 1u);
  EXPECT_EQ(readText(path_), "192.0.2.7\nAnn\n");
}

TEST_F(BanStoreTest, ABanThatCouldNotBeWrittenIsWrittenWithTheNextOne) {
  BanStore store = open("");
  std::filesystem::remove(path_);
  std::filesystem::create_directory(path_);
  const auto error = store.add(banOf("192.0.2.7"), kNow);
  EXPECT_TRUE(error);  // cannot be read
  std::filesystem::remove(path_);
  writeText(path_, "");
  EXPECT_EQ(store.add(banOf("192.0.2.7"), kNow), std::nullopt);
  EXPECT_EQ(store.add(banOf("192.0.2.8"), kNow), std::nullopt);  // perhaps before the first is in the file
  EXPECT_TRUE(writes(store, "192.0.2.7 x\n192.0.2.8 x\n"));
}

TEST_F(BanStoreTest, ABanThatCouldNotBeWrittenIsTriedAgain) {
  BanStore store = open("");
  EXPECT_EQ(store.add(banOf("192.0.2.7"), kNow), std::nullopt);
  std::filesystem::remove(path_);
  std::filesystem::create_directory(path_);
  std::optional<std::string> fault;
  EXPECT_TRUE(stepUntil([&] { fault = store.poll(kMoment); }, [&] { return fault.has_value(); }));
  EXPECT_TRUE(store.finish());
  std::filesystem::remove(path_);
  const auto step = [&] { EXPECT_EQ(store.poll(kMoment + FileWriter::kRetryInterval), std::nullopt); };
  EXPECT_TRUE(stepUntil(step, [&] { return std::filesystem::is_regular_file(path_); }));
  EXPECT_EQ(store.finish(), std::nullopt);
  EXPECT_EQ(readText(path_), "192.0.2.7 x\n");
}

TEST_F(BanStoreTest, SaysWhyThereIsNothingToRemove) {
  BanStore store = open("192.0.2.0/24\n");
  const auto refusalFor = [&](const std::string& text) { return store.remove(range(text), kNow).value().what; };
  EXPECT_EQ(refusalFor("192.0.2.7"), "there is no ban of 192.0.2.7; the ban of 192.0.2.0/24 includes it");
  EXPECT_EQ(refusalFor("192.0.0.0/16"), "there is no ban of 192.0.0.0/16; the command 'bans' lists all of them");
  EXPECT_EQ(refusalFor("198.51.100.1"), "there is no ban of 198.51.100.1; the command 'bans' lists all of them");
}

TEST_F(BanStoreTest, AReloadTakesOverTheFile) {
  BanStore store = open("192.0.2.7\n");
  writeText(path_, "192.0.2.8\n");
  EXPECT_EQ(store.replace(std::get<BanList>(readBanFile(path_))), std::nullopt);
  EXPECT_TRUE(store.list().find(range("192.0.2.8")));
  EXPECT_FALSE(store.list().find(range("192.0.2.7")));
}

// The file that was read does not hold the change yet.
TEST_F(BanStoreTest, AReloadDoesNotUndoAChangeThatWaitsToBeWritten) {
  BanStore store = open("");
  const BanList old = std::get<BanList>(readBanFile(path_));
  EXPECT_EQ(store.add(banOf("192.0.2.7"), kNow), std::nullopt);
  const auto error = store.replace(old);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->what, path_ +
                             ": error: the last change of the bans has not been written to this file yet, and will "
                             "replace what is in it; reload again when it has been written");
  EXPECT_EQ(store.list().size(), 1u);
  EXPECT_TRUE(writes(store, "192.0.2.7 x\n"));
  EXPECT_TRUE(stepUntil([&] { store.poll(kMoment); }, [&] { return store.replace(BanList()) == std::nullopt; }));
  EXPECT_EQ(store.list().size(), 0u);
}

TEST_F(BanStoreTest, ReportsWhatIsWrongWithAFile) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(std::get<Lines>(readBanFile(path_)),
            Lines{path_ + ": error: No such file or directory; name a readable ban file; it may be empty"});
  writeText(path_, "a\nb\n");
  EXPECT_EQ(std::get<Lines>(readBanFile(path_)).size(), 2u);
}

TEST_F(BanStoreTest, DoesNotGrowAFileBeyondWhatItReads) {
  BanStore store = open("#" + std::string(BanList::kMaxBytes - 100, 'x') + "\n");
  const auto error = store.add(banOf("192.0.2.7"), kNow);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->what, "the ban file is full: remove bans from it");
  EXPECT_EQ(store.list().size(), 0u);
}

/// A match with two players of one address, one of another, and one of this machine.
class EnforceBansTest : public testing::Test {
 protected:
  EnforceBansTest() {
    for (const ClientId client : {1u, 2u}) join(client, "192.0.2.7");
    join(3, "192.0.2.8");
    join(4, "127.0.0.1");
    match_.takeOutgoing();
  }

  void join(ClientId client, const char* address) {
    Hello hello;
    hello.token = SessionToken{static_cast<std::uint8_t>(client)};
    match_.receive(client, hello, *IpAddress::parse(address));
  }

  Match match_{LevelRotation({levelOf(farGoalText())}), {8, "Test"}};
};

TEST_F(EnforceBansTest, RemovesEveryPlayerOfABannedAddress) {
  EXPECT_EQ(enforceBans(match_, listOf("192.0.2.7 too loud\n"), kNow), 2u);
  EXPECT_FALSE(match_.isPlaying(1));
  EXPECT_FALSE(match_.isPlaying(2));
  EXPECT_TRUE(match_.isPlaying(3));
  EXPECT_TRUE(match_.isPlaying(4));
  const std::span<const Outgoing> sent = match_.takeOutgoing();
  ASSERT_EQ(sent.size(), 2u);
  for (const Outgoing& message : sent) {
    EXPECT_TRUE(message.last);
    EXPECT_EQ(std::get<Bye>(*decodeToClient(message.bytes)).reason, "you are banned from this server: too loud");
  }
}

// Also where a companion has a lower slot.
TEST_F(EnforceBansTest, RemovesTheCompanionsOfABannedPlayer) {
  match_.remove(1);
  match_.tick();
  for (const std::uint32_t local : {1u, 2u}) match_.receive(3, Companion{local, true, "Ben"});
  match_.takeOutgoing();
  EXPECT_EQ(enforceBans(match_, listOf("192.0.2.8\n"), kNow), 3u);
  EXPECT_EQ(match_.players(), 2u);
  const std::span<const Outgoing> sent = match_.takeOutgoing();
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_TRUE(sent[0].last);
}

TEST_F(EnforceBansTest, RemovesDisconnectedPlayersToo) {
  match_.disconnect(1);
  EXPECT_EQ(enforceBans(match_, listOf("192.0.2.0/24\n"), kNow), 3u);
  EXPECT_EQ(match_.playerStatus().size(), 1u);
}

TEST_F(EnforceBansTest, ABanOfOneIpv6AddressHitsThisAddressOnly) {
  join(5, "2001:db8::1");
  join(6, "2001:db8::2");  // of the same household
  EXPECT_EQ(enforceBans(match_, listOf("2001:db8::1\n"), kNow), 1u);
  EXPECT_FALSE(match_.isPlaying(5));
  EXPECT_TRUE(match_.isPlaying(6));
}

TEST_F(EnforceBansTest, APlayerThatHasMovedIsBannedByItsPresentAddress) {
  EXPECT_TRUE(match_.move(3, *IpAddress::parse("198.51.100.9")));
  EXPECT_EQ(enforceBans(match_, listOf("192.0.2.8\n"), kNow), 0u);
  match_.disconnect(3);
  EXPECT_EQ(enforceBans(match_, listOf("198.51.100.9\n"), kNow), 1u);
}

TEST_F(EnforceBansTest, NobodyLeavesWithoutABanThatHolds) {
  EXPECT_EQ(enforceBans(match_, BanList(), kNow), 0u);
  EXPECT_EQ(enforceBans(match_, listOf("192.0.2.7 until 2026-11-22T12:00:00Z\n"), kNow), 0u);
  EXPECT_EQ(match_.players(), 4u);
}

// Nobody can lock out the person who sits at the machine.
TEST_F(EnforceBansTest, ThePlayersOfThisMachineStay) {
  join(5, "::1");
  EXPECT_EQ(enforceBans(match_, listOf("0.0.0.0/0\n::/0\n"), kNow), 3u);
  EXPECT_TRUE(match_.isPlaying(5));
  EXPECT_TRUE(match_.isPlaying(4));
}

}  // namespace
}  // namespace platon::bans_test
