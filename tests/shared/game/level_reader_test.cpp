#include "shared/game/level_reader.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "platon/game/level.h"

namespace platon::level_reader_test {
namespace {

// A level text with its errors, each as line:column: message.
struct InvalidLevel {
  const char* name;
  std::string text;
  std::vector<std::string> errors;
};

const std::string kFaces = "%\n%\n%\n%\n";
const std::string kHead = "TETRAHEDRON\n0 0 0 0\n1 0 0\n400\n";

// A tetrahedron with these lines on its first face; the first of them is line 6 of the text.
std::string withLines(const std::string& lines) { return kHead + "%\n" + lines + "%\n%\n%\n"; }

std::string bytes(std::string_view text) { return std::string(text); }

const std::string kOnlyTabs = ": only tabs and line ends (LF or CR LF) are allowed";
const std::string kSolids = ": use TETRAHEDRON, HEXAHEDRON, OCTAHEDRON, DODECAHEDRON or ICOSAHEDRON";
const std::string kNotANumber = " must be a number such as -12 or 0.25, not ";
const std::string kNotWhole = " must be a whole number such as 12, not ";
const std::string kWords = "use oneway, up, hazard, checkpoint, key, door, plate, timed, or no word";
const std::string kBlockedStart =
    ": the start is blocked: a line or a corner overlaps the player there; move the start or the line";

const std::vector<InvalidLevel> kInvalidLevels = {
    {"Empty",
     "",
     {"1:1: missing line: the solid, such as HEXAHEDRON", "1:1: missing line: the start (face x y degrees)",
      "1:1: missing line: the goal (face x y)", "1:1: missing line: the face size"}},
    {"OnlyComments",
     "# title: nothing\n\n  # more\n",
     {"3:9: missing line: the solid, such as HEXAHEDRON", "3:9: missing line: the start (face x y degrees)",
      "3:9: missing line: the goal (face x y)", "3:9: missing line: the face size"}},
    {"UnknownSolid", "CUBE\n0 0 0 0\n1 0 0\n400\n" + kFaces, {"1:1: unknown solid 'CUBE'" + kSolids}},
    {"SolidInLowerCase",
     "  tetrahedron\n0 0 0 0\n1 0 0\n400\n" + kFaces,
     {"1:3: unknown solid 'tetrahedron'" + kSolids}},
    {"SolidMissing",
     "0 0 0 0\n1 0 0\n400\n" + kFaces,
     {"1:1: unknown solid '0'" + kSolids, "2:6: missing degrees: the start is 'face x y degrees'",
      "3:4: missing x: the goal is 'face x y'", "4:1: missing line: the face size"}},
    {"SolidNotAlone",
     "TETRAHEDRON 4\n0 0 0 0\n1 0 0\n400\n" + kFaces,
     {"1:13: unexpected '4' after the solid: remove it"}},
    {"SolidOfManyBytes",
     std::string(40, 'A') + "\n0 0 0 0\n1 0 0\n400\n" + kFaces,
     {"1:1: unknown solid '" + std::string(32, 'A') + "...'" + kSolids}},
    {"SolidNotAscii", "T\xc3\x89TRA\n0 0 0 0\n1 0 0\n400\n" + kFaces, {"1:1: unknown solid 'T??TRA'" + kSolids}},
    {"StartWithoutDegrees",
     "TETRAHEDRON\n0 0 0 # up\n1 0 0\n400\n" + kFaces,
     {"2:6: missing degrees: the start is 'face x y degrees'"}},
    {"StartWithFiveNumbers",
     "TETRAHEDRON\n0 0 0 0 7\n1 0 0\n400\n" + kFaces,
     {"2:9: unexpected '7': the start is 'face x y degrees'"}},
    {"StartFaceTooLarge",
     "TETRAHEDRON\n4 0 0 0\n1 0 0\n400\n" + kFaces,
     {"2:1: face must be between 0 and 3, not '4'"}},
    {"StartFaceNegative",
     "TETRAHEDRON\n-1 0 0 0\n1 0 0\n400\n" + kFaces,
     {"2:1: face must be between 0 and 3, not '-1'"}},
    {"StartFaceWithDecimals",
     "TETRAHEDRON\n1.0 0 0 0\n1 0 0\n400\n" + kFaces,
     {"2:1: face must be a whole number, not '1.0'"}},
    {"StartFaceNoNumber", "TETRAHEDRON\none 0 0 0\n1 0 0\n400\n" + kFaces, {"2:1: face" + kNotWhole + "'one'"}},
    {"DegreesWithDecimals",
     "TETRAHEDRON\n0 0 0 0.5\n1 0 0\n400\n" + kFaces,
     {"2:7: degrees must be a whole number, not '0.5'"}},
    {"DegreesWithManyDecimals",
     "TETRAHEDRON\n0 0 0 0.55555\n1 0 0\n400\n" + kFaces,
     {"2:7: degrees must be a whole number, not '0.55555'"}},
    {"DegreesTooLarge",
     "TETRAHEDRON\n0 0 0 361\n1 0 0\n400\n" + kFaces,
     {"2:7: degrees must be between -360 and 360, not '361'"}},
    {"StartAllWrong",
     "TETRAHEDRON\na b c d\n1 0 0\n400\n" + kFaces,
     {"2:1: face" + kNotWhole + "'a'", "2:3: x" + kNotANumber + "'b'", "2:5: y" + kNotANumber + "'c'",
      "2:7: degrees" + kNotWhole + "'d'"}},
    {"StartOutsideItsFace",
     "TETRAHEDRON\n0 -200 -115 0\n1 0 0\n400\n" + kFaces,
     {"2:3: the start is outside its face: move it inside"}},
    {"StartFarOutside",
     "TETRAHEDRON\n0  131072 -131072 0\n1 0 0\n400\n" + kFaces,
     {"2:4: the start is outside its face: move it inside"}},
    {"StartBeyondAllCoordinates",
     "TETRAHEDRON\n0 131072.0001 -99999999999999999999 0\n1 0 0\n400\n" + kFaces,
     {"2:3: x must be between -131072 and 131072, not '131072.0001'",
      "2:15: y must be between -131072 and 131072, not '-99999999999999999999'"}},
    {"StartOnALine", withLines("-50 0 50 0\n"), {"2:3" + kBlockedStart}},
    {"StartOnAPoint",
     withLines("0 5 0 5\n"),
     {"2:3" + kBlockedStart, "6:1: the line has no length: it blocks as a point"}},
    {"StartAtACorner", "TETRAHEDRON\n0 0 230.9 0\n1 0 0\n400\n" + kFaces, {"2:3" + kBlockedStart}},
    {"GoalMissing",
     "TETRAHEDRON\n0 0 0 0\n400\n" + kFaces,
     {"3:1: face must be between 0 and 3, not '400'", "3:4: missing x: the goal is 'face x y'",
      "4:1: missing line: the face size"}},
    {"GoalWithFourNumbers",
     "TETRAHEDRON\n0 0 0 0\n1 0 0 90\n400\n" + kFaces,
     {"3:7: unexpected '90': the goal is 'face x y'"}},
    {"GoalFaceTooLarge",
     "ICOSAHEDRON\n19 0 0 0\n20 0 0\n400\n" + kFaces + kFaces + kFaces + kFaces + kFaces,
     {"3:1: face must be between 0 and 19, not '20'"}},
    {"GoalOutsideItsFace",
     "TETRAHEDRON\n0 0 0 0\n1 0 231\n400\n" + kFaces,
     {"3:3: the goal is outside its face: move it inside"}},
    {"GoalNoNumber",
     "TETRAHEDRON\n0 0 0 0\n1 1e2 0,5\n400\n" + kFaces,
     {"3:3: x" + kNotANumber + "'1e2'", "3:7: y" + kNotANumber + "'0,5'"}},
    {"FaceSizeTooSmall",
     "TETRAHEDRON\n0 0 0 0\n1 0 0\n199\n" + kFaces,
     {"4:1: face size must be between 200 and 65536, not '199'"}},
    {"FaceSizeTooLarge",
     "TETRAHEDRON\n0 0 0 0\n1 0 0\n65537\n" + kFaces,
     {"4:1: face size must be between 200 and 65536, not '65537'"}},
    {"FaceSizeNegative",
     "TETRAHEDRON\n0 0 0 0\n1 0 0\n-400\n" + kFaces,
     {"4:1: face size must be between 200 and 65536, not '-400'"}},
    {"FaceSizeWithDecimals",
     "TETRAHEDRON\n0 0 0 0\n1 0 0\n400.5\n" + kFaces,
     {"4:1: face size must be a whole number, not '400.5'"}},
    {"FaceSizeTwice",
     "TETRAHEDRON\n0 0 0 0\n1 0 0\n400 400\n" + kFaces,
     {"4:5: unexpected '400': the face size is one number"}},
    {"FaceSizeMissing", "TETRAHEDRON\n0 0 0 0\n1 0 0\n" + kFaces, {"4:1: missing line: the face size"}},
    {"OnlyFaces",
     "TETRAHEDRON\n" + kFaces,
     {"2:1: missing line: the start (face x y degrees)", "2:1: missing line: the goal (face x y)",
      "2:1: missing line: the face size"}},
    {"NoFaces", kHead, {"4:4: the level ends after 0 of 4 faces: each begins with a '%'"}},
    {"TooFewFaces",
     kHead + "%\n%\n%\n0 0 5 5 # end",
     {"8:14: the level ends after 3 of 4 faces: each begins with a '%'"}},
    {"TooManyFaces",
     kHead + kFaces + "%\n0 0 0 5\n%\n",
     {"9:1: too many '%': this is number 5, but the solid has 4 faces",
      "11:1: too many '%': this is number 6, but the solid has 4 faces"}},
    {"LineBeforeTheFirstFace",
     kHead + "0 50 9 50\n0 60 9 60\n" + kFaces,
     {"5:1: line before the first '%': every face begins with a '%'"}},
    {"FaceMarkNotAlone", kHead + "%\n% 0 0 5 5\n%\n%\n", {"6:3: unexpected '0' after '%': move it to the next line"}},
    {"FaceMarkJoined",
     kHead + "%\n%0 0 5 5\n%\n%\n",
     {"6:1: x0" + kNotANumber + "'%0'", "8:2: the level ends after 3 of 4 faces: each begins with a '%'"}},
    {"LineWithThreeNumbers", withLines("40 50 60\n"), {"6:9: missing y1: a line is 'x0 y0 x1 y1'"}},
    {"LineWithOneNumber", withLines("\t40  \n"), {"6:4: missing y0: a line is 'x0 y0 x1 y1'"}},
    {"LineWithFiveNumbers", withLines("40 50 60 50 0\n"), {"6:13: unknown word '0': " + kWords}},
    {"UnknownWord", withLines("40 50 60 50 hazzard\n"), {"6:13: unknown word 'hazzard': did you mean 'hazard'?"}},
    {"WordInCapitals", withLines("40 50 60 50 DOOR 1\n"), {"6:13: unknown word 'DOOR': " + kWords}},
    {"KeyWithoutNumber",
     withLines("40 50 60 50 key\n"),
     {"6:16: missing number after 'key': the number of a door and of its keys and plates"}},
    {"UpWithoutNumber",
     withLines("40 50 60 50 up\n"),
     {"6:15: missing number after 'up': the number of an edge of the face"}},
    {"UpToNoEdge",
     withLines("40 50 60 50 up 3\n"),
     {"6:16: the number of an edge of the face must be a whole number between 0 and 2, not '3'"}},
    {"DoorOutOfRange",
     withLines("40 50 60 50 door 32\n"),
     {"6:18: the number of a door and of its keys and plates must be a whole number between 0 and 31, not '32'"}},
    {"PlateWithADecimal",
     withLines("40 50 60 50 plate 1.0\n"),
     {"6:19: the number of a door and of its keys and plates must be a whole number between 0 and 31, not '1.0'"}},
    {"NegativeKey",
     withLines("40 50 60 50 key -1\n"),
     {"6:17: the number of a door and of its keys and plates must be a whole number between 0 and 31, not '-1'"}},
    {"NumberAfterHazard", withLines("40 50 60 50 hazard 1\n"), {"6:20: unexpected '1' after 'hazard': remove it"}},
    {"SecondNumber", withLines("40 50 60 50 door 1 2\n"), {"6:20: unexpected '2' after 'door 1': remove it"}},
    {"SecondNumberAfterNoAscii",
     withLines("40 50 60 50 door \xc3\xa9 2\n"),
     {"6:21: unexpected '2' after 'door ?\?': remove it"}},
    {"OnewayWithoutLength",
     withLines("40 50 40 50 oneway\n"),
     {"6:1: the line has no length: it blocks as a point",
      "6:13: a 'oneway' without length has no sides: give it two ends"}},
    {"CheckpointAtAWall",
     withLines("40 50 60 50 checkpoint\n40 60 60 60\n"),
     {"6:1: the middle of this checkpoint, where players return, is within 12.5 units of a line that can block, or of "
      "the edge of its face: move it"}},
    {"CheckpointAtAnEdge",
     withLines("40 -110 60 -110 checkpoint\n"),
     {"6:1: the middle of this checkpoint, where players return, is within 12.5 units of a line that can block, or of "
      "the edge of its face: move it"}},
    {"CrossingsNotANumber",
     "# crossings: two\n" + withLines(""),
     {"1:1: 'crossings:' must be a whole number between 0 and 255, not 'two'"}},
    {"NoPlayers",
     "# players: 0\n" + withLines(""),
     {"1:1: 'players:' must be a whole number between 1 and 255, not '0'"}},
    {"HalfAPlayer",
     "# players: 1.5\n" + withLines(""),
     {"1:1: 'players:' must be a whole number between 1 and 255, not '1.5'"}},
    {"TooManyCrossings",
     "# crossings: 256\n" + withLines(""),
     {"1:1: 'crossings:' must be a whole number between 0 and 255, not '256'"}},
    {"NeedsADoor",
     "# needs: key 1, door 1\n" + withLines(""),
     {"1:1: 'needs:' must name keys, plates or checkpoints, such as 'key 1, checkpoint', not 'door 1'"}},
    {"NeedsNothing",
     "# needs:\n" + withLines(""),
     {"1:1: 'needs:' must name keys, plates or checkpoints, such as 'key 1, checkpoint', not ''"}},
    {"NeedsWithACommaTooMany",
     "# needs: key 1,\n" + withLines(""),
     {"1:1: 'needs:' must name keys, plates or checkpoints, such as 'key 1, checkpoint', not ''"}},
    {"NeedsTwice", "# needs: key 1\n# needs: key 2\n" + withLines(""), {"2:1: second 'needs:': remove one of them"}},
    {"PlayersTwice", "# players: 2\n# players: 2\n" + withLines(""), {"2:1: second 'players:': remove one of them"}},
    {"LineNoNumber", withLines("40 x 60 50\n"), {"6:4: y0" + kNotANumber + "'x'"}},
    {"LineWithPlus", withLines("+40 50 60 50\n"), {"6:1: x0" + kNotANumber + "'+40'"}},
    {"LineWithBarePoint",
     withLines("40 .5 60. 50\n"),
     {"6:4: y0" + kNotANumber + "'.5'", "6:7: x1" + kNotANumber + "'60.'"}},
    {"LineNotANumberByName",
     withLines("nan inf -inf 0x10\n"),
     {"6:1: x0" + kNotANumber + "'nan'", "6:5: y0" + kNotANumber + "'inf'", "6:9: x1" + kNotANumber + "'-inf'",
      "6:14: y1" + kNotANumber + "'0x10'"}},
    {"LineWithFiveDecimals",
     withLines("40 50.12345 60 50\n"),
     {"6:4: y0 must have at most four decimals, not '50.12345'"}},
    {"LineBeyondAllCoordinates",
     withLines("40 50 600000 50\n"),
     {"6:7: x1 must be between -131072 and 131072, not '600000'"}},
    {"LineWhollyOutside", withLines("-200 200 -100 200\n"), {"6:1: the line is outside its face: move or remove it"}},
    {"LineBehindACorner", withLines("  -60 232 60 232\n"), {"6:3: the line is outside its face: move or remove it"}},
    {"PointOutside", withLines("300 0 300 0\n"), {"6:1: the line is outside its face: move or remove it"}},
    {"NulByte", kHead + bytes({"%\n0\0 0 0 5\n%\n%\n%\n", 17}), {"6:2: control character 0x00" + kOnlyTabs}},
    {"EscapeInAComment", "# \x1b[2J\n" + kHead + kFaces, {"1:3: control character 0x1b" + kOnlyTabs}},
    {"FormFeed", "TETRAHEDRON\f\n0 0 0 0\n1 0 0\n400\n" + kFaces, {"1:12: control character 0x0c" + kOnlyTabs}},
    {"CarriageReturnAlone",
     "TETRAHEDRON\r0 0 0 0\n1 0 0 0\n1 0 0\n400\n" + kFaces,
     {"1:12: control character 0x0d" + kOnlyTabs}},
    {"Latin1", "# author: Andr\xe9\n" + kHead + kFaces, {"1:15: invalid UTF-8: save the file as UTF-8"}},
    {"Utf16",
     bytes({"\xff\xfeT\0E\0", 6}),
     {"1:1: invalid UTF-8: save the file as UTF-8", "1:7: missing line: the start (face x y degrees)",
      "1:7: missing line: the goal (face x y)", "1:7: missing line: the face size"}},
    {"NoBreakSpace",
     withLines("40\xc2\xa0"
               "50 60 50\n"),
     {"6:1: x0" + kNotANumber + "'40??50'", "6:13: missing y1: a line is 'x0 y0 x1 y1'"}},
    {"TwoTitles", "# title: a\n# title: b\n" + kHead + kFaces, {"2:1: second 'title:': remove one of them"}},
    {"LongAuthor",
     "# author: " + std::string(101, 'x') + "\n" + kHead + kFaces,
     {"1:1: 'author:' has 101 bytes: at most 100 are allowed"}},
    {"ManyErrors",
     "PLATON\n0 0\n1 0 zero\n10\n%\n1 2 3\n",
     {"1:1: unknown solid 'PLATON'" + kSolids, "2:4: missing y: the start is 'face x y degrees'",
      "3:5: y" + kNotANumber + "'zero'", "4:1: face size must be between 200 and 65536, not '10'",
      "6:6: missing y1: a line is 'x0 y0 x1 y1'"}},
};

void PrintTo(const InvalidLevel& level, std::ostream* out) { *out << level.name; }

class InvalidLevelTest : public testing::TestWithParam<InvalidLevel> {};

TEST_P(InvalidLevelTest, EveryErrorIsReportedAtItsPosition) {
  const LevelResult result = loadLevel(GetParam().text);
  EXPECT_EQ(result.level, nullptr);
  std::vector<std::string> found;
  for (const Diagnostic& one : result.diagnostics) {
    found.push_back(std::to_string(one.line) + ":" + std::to_string(one.column) + ": " + one.message);
  }
  EXPECT_EQ(found, GetParam().errors);
}

INSTANTIATE_TEST_SUITE_P(All, InvalidLevelTest, testing::ValuesIn(kInvalidLevels),
                         [](const auto& spec) { return std::string(spec.param.name); });

LevelDraft read(std::string_view text, Diagnostics& diagnostics) { return readLevel(text, diagnostics); }

LevelDraft readValid(std::string_view text) {
  Diagnostics diagnostics;
  LevelDraft draft = read(text, diagnostics);
  for (const Diagnostic& one : diagnostics.take()) ADD_FAILURE() << format("level", one);
  return draft;
}

TEST(LevelReaderTest, ReadsEveryFieldOfALevel) {
  const LevelDraft draft = readValid(
      "# title: Two words\n#author:Somebody\nTETRAHEDRON\n2 -1.5 0.25 -90\n3 0 10\n400\n%\n0 50 9 50.0005\n%\n%\n"
      "1 2 3 4\n5 6 7 8\n%\n");
  EXPECT_EQ(draft.solid, SolidKind::kTetrahedron);
  EXPECT_EQ(draft.faceSize, 400);
  EXPECT_EQ(draft.title, "Two words");
  EXPECT_EQ(draft.author, "Somebody");
  ASSERT_TRUE(draft.start && draft.goal);
  EXPECT_EQ(draft.start->face, 2u);
  EXPECT_EQ(draft.start->point, Point(-1536, 256));
  EXPECT_EQ(draft.start->angle, Angle(27000));
  EXPECT_EQ(draft.start->at.line, 4);
  EXPECT_EQ(draft.start->at.column, 3) << "the position is that of the x";
  EXPECT_EQ(draft.goal->face, 3u);
  EXPECT_EQ(draft.goal->point, Point(0, 10240));
  ASSERT_EQ(draft.segments.size(), 4u);
  EXPECT_EQ(draft.segments[0], (std::vector<Segment>{{{0, 51200}, {9216, 51201}}}));
  EXPECT_TRUE(draft.segments[1].empty());
  EXPECT_EQ(draft.segments[2], (std::vector<Segment>{{{1024, 2048}, {3072, 4096}}, {{5120, 6144}, {7168, 8192}}}));
  EXPECT_TRUE(draft.segments[3].empty());
}

TEST(LevelReaderTest, DoesNotCheckWhetherTheStartIsFree) { EXPECT_TRUE(readValid(withLines("-50 0 50 0\n")).start); }

TEST(LevelReaderTest, AnErrorLeavesOnlyItsOwnFieldEmpty) {
  Diagnostics diagnostics;
  const LevelDraft draft = read("TETRAHEDRON\n0 0 zero 0\n1 0 0\n400\n" + kFaces, diagnostics);
  EXPECT_TRUE(diagnostics.hasError());
  EXPECT_EQ(draft.solid, SolidKind::kTetrahedron);
  EXPECT_FALSE(draft.start);
  EXPECT_TRUE(draft.goal);
  EXPECT_EQ(draft.faceSize, 400);
}

TEST(LevelReaderTest, ReadsATitleOfTheLargestSize) {
  const std::string title(LevelDraft::kMaxNameBytes, 'x');
  EXPECT_EQ(readValid("# title: " + title + "\n" + kHead + kFaces).title, title);
}

// The warnings about these lines, which are on the first face of a level, as line: message.
std::vector<std::string> warningsOf(const std::string& text) {
  Diagnostics diagnostics;
  read(text, diagnostics);
  std::vector<std::string> found;
  for (const Diagnostic& one : diagnostics.take()) found.push_back(std::to_string(one.line) + ": " + one.message);
  return found;
}

TEST(LevelReaderTest, ALineIsADuplicateInEitherDirection) {
  for (const std::string line : {"40 50 60 50", "40 50 40 70", "40 50 60 70", "40 70 60 50", "40 70 40 50"}) {
    const std::size_t middle = line.find(' ', 3);
    const std::string backwards = line.substr(middle + 1) + " " + line.substr(0, middle);
    const std::string between = "0 50 9 50\n";
    for (const std::string& second : {line, backwards}) {
      EXPECT_EQ(warningsOf(withLines(line + "\n" + between + second + "\n")),
                std::vector<std::string>{"8: duplicate of line 6: remove one of the two"})
          << line << ", " << second;
    }
  }
}

TEST(LevelReaderTest, LinesThatDifferInOneNumberOrInTheirFaceAreNoDuplicates) {
  const std::string line = "40 50 60 70\n";
  for (const std::string other : {"41 50 60 70", "40 51 60 70", "40 50 61 70", "40 50 60 71", "40 70 60 50"})
    EXPECT_EQ(warningsOf(withLines(line + other + "\n")), std::vector<std::string>()) << other;
  EXPECT_EQ(warningsOf(kHead + "%\n" + line + "%\n" + line + "%\n%\n"), std::vector<std::string>());
}

TEST(LevelReaderTest, ElementsComeFirstOnTheirFace) {
  const LevelDraft draft = readValid(
      "TETRAHEDRON\n0 0 0 0\n1 0 0\n400\n%\n1 30 2 30\n3 30 4 30 key 5\n5 30 6 30\n7 30 8 30 plate 6\n%\n%\n"
      "1 40 2 40\n%\n3 50 4 50\n5 50 6 50 up 2\n");
  const auto firstXOf = [&](std::size_t face) {
    std::vector<std::int32_t> all;
    for (const Segment& segment : draft.segments[face]) all.push_back(segment.a.x / 1024);
    return all;
  };
  const auto linesOf = [&](std::size_t face) {
    std::vector<int> all;
    for (const TextPosition& at : draft.positions[face]) all.push_back(at.line);
    return all;
  };
  EXPECT_EQ(firstXOf(0), (std::vector<std::int32_t>{3, 7, 1, 5}));
  EXPECT_EQ(linesOf(0), (std::vector<int>{7, 9, 6, 8}));
  EXPECT_EQ(firstXOf(2), (std::vector<std::int32_t>{1}));
  EXPECT_EQ(firstXOf(3), (std::vector<std::int32_t>{5, 3}));
  EXPECT_EQ(linesOf(3), (std::vector<int>{15, 14}));
  ASSERT_EQ(draft.elements.size(), 3u);
  EXPECT_EQ(draft.elements[0], (Element{ElementKind::kKey, 5, 0, 0, 0, {{3072, 30720}, {4096, 30720}}}));
  EXPECT_EQ(draft.elements[1], (Element{ElementKind::kPlate, 6, 0, 0, 1, {{7168, 30720}, {8192, 30720}}}));
  EXPECT_EQ(draft.elements[2], (Element{ElementKind::kUp, 2, 0, 3, 0, {{5120, 51200}, {6144, 51200}}}));
}

TEST(LevelReaderTest, ReadsTheLargestNumberOfElementsAndNoMore) {
  std::string text = "HEXAHEDRON\n0 0 0 0\n0 0 0\n1000\n%\n";
  for (std::size_t i = 0; i < LevelDraft::kMaxElements; ++i)
    text += "-500 " + std::to_string(20 + i % 450) + " 500 " + std::to_string(20 + i / 450) + " hazard\n";
  const std::string others = "0 20 0 30\n%\n%\n%\n%\n%\n";
  EXPECT_EQ(readValid(text + others).elements.size(), LevelDraft::kMaxElements);
  Diagnostics diagnostics;
  EXPECT_EQ(read(text + "0 20 0 30 oneway\n0 20 0 40 key 1\n" + others, diagnostics).elements.size(),
            LevelDraft::kMaxElements);
  EXPECT_EQ(diagnostics.take().at(0).message, "more than 4096 lines with a word: remove some");
}

TEST(LevelReaderTest, ReadsTheLargestNumberOfLinesAndNoMore) {
  std::string text = "HEXAHEDRON\n0 0 0 0\n0 0 0\n1000\n%\n";
  for (std::size_t i = 0; i < LevelDraft::kMaxLines; ++i) {
    text += "-500 " + std::to_string(20 + i % 450) + " 500 " + std::to_string(20 + i / 450) + "\n";
  }
  const std::string otherFaces = "%\n%\n%\n%\n%\n";
  EXPECT_EQ(readValid(text + otherFaces).segments[0].size(), LevelDraft::kMaxLines);
  Diagnostics diagnostics;
  read(text + "0 20 0 30\n0 20 0 40\n" + otherFaces, diagnostics);
  EXPECT_EQ(diagnostics.take(), (std::vector<Diagnostic>{{200006, 1, true, "more than 200000 lines: remove some"}}));
}

}  // namespace
}  // namespace platon::level_reader_test
