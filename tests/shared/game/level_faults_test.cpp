#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "platon/game/level.h"

namespace platon {
namespace {

struct Faulty {
  const char* name;
  std::string text;
  std::vector<std::string> errors;
};

const std::string kFaces = "%\n%\n%\n%\n";
const std::string kHead = "TETRAHEDRON\n0 0 0 0\n1 0 0\n400\n";

// A tetrahedron whose first face has these lines; the first of them is line 6.
std::string withLines(const std::string& lines) { return kHead + "%\n" + lines + "%\n%\n%\n"; }

std::string bytes(std::string_view text) { return std::string(text); }

const std::string kOnlyTabs = ": only tabs and line ends (LF or CR LF) are allowed";
const std::string kSolids = ": it is TETRAHEDRON, HEXAHEDRON, OCTAHEDRON, DODECAHEDRON or ICOSAHEDRON";
const std::string kNoNumber = " must be a number such as -12 or 0.25, not ";
const std::string kNotWhole = " must be a whole number such as 12, not ";
const std::string kNotFree = ": the start is not free: a line or a corner overlaps the player there";

const std::vector<Faulty> kFaulty = {
    {"Empty",
     "",
     {"1:1: a line is missing before this: the solid, such as HEXAHEDRON",
      "1:1: a line is missing before this: the start: face x y degrees",
      "1:1: a line is missing before this: the goal: face x y", "1:1: a line is missing before this: the face size"}},
    {"OnlyComments",
     "# title: nothing\n\n  # more\n",
     {"3:9: a line is missing before this: the solid, such as HEXAHEDRON",
      "3:9: a line is missing before this: the start: face x y degrees",
      "3:9: a line is missing before this: the goal: face x y", "3:9: a line is missing before this: the face size"}},
    {"UnknownSolid", "CUBE\n0 0 0 0\n1 0 0\n400\n" + kFaces, {"1:1: unknown solid 'CUBE'" + kSolids}},
    {"SolidInLowerCase",
     "  tetrahedron\n0 0 0 0\n1 0 0\n400\n" + kFaces,
     {"1:3: unknown solid 'tetrahedron'" + kSolids}},
    {"SolidMissing",
     "0 0 0 0\n1 0 0\n400\n" + kFaces,
     {"1:1: unknown solid '0'" + kSolids, "2:6: the start is: face x y degrees; degrees is missing",
      "3:4: the goal is: face x y; x is missing", "4:1: a line is missing before this: the face size"}},
    {"SolidNotAlone",
     "TETRAHEDRON 4\n0 0 0 0\n1 0 0\n400\n" + kFaces,
     {"1:13: the solid stands alone on its line: take '4' away"}},
    {"SolidOfManyBytes",
     std::string(40, 'A') + "\n0 0 0 0\n1 0 0\n400\n" + kFaces,
     {"1:1: unknown solid '" + std::string(32, 'A') + "...'" + kSolids}},
    {"SolidNotAscii", "T\xc3\x89TRA\n0 0 0 0\n1 0 0\n400\n" + kFaces, {"1:1: unknown solid 'T??TRA'" + kSolids}},
    {"StartWithoutDegrees",
     "TETRAHEDRON\n0 0 0 # up\n1 0 0\n400\n" + kFaces,
     {"2:6: the start is: face x y degrees; degrees is missing"}},
    {"StartWithFiveNumbers",
     "TETRAHEDRON\n0 0 0 0 7\n1 0 0\n400\n" + kFaces,
     {"2:9: the start is: face x y degrees; '7' is too much"}},
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
     {"2:1: face" + kNotWhole + "'a'", "2:3: x" + kNoNumber + "'b'", "2:5: y" + kNoNumber + "'c'",
      "2:7: degrees" + kNotWhole + "'d'"}},
    {"StartOutsideItsFace",
     "TETRAHEDRON\n0 -200 -115 0\n1 0 0\n400\n" + kFaces,
     {"2:3: the start lies outside its face"}},
    {"StartFarOutside",
     "TETRAHEDRON\n0  131072 -131072 0\n1 0 0\n400\n" + kFaces,
     {"2:4: the start lies outside its face"}},
    {"StartBeyondAllCoordinates",
     "TETRAHEDRON\n0 131072.0001 -99999999999999999999 0\n1 0 0\n400\n" + kFaces,
     {"2:3: x must be between -131072 and 131072, not '131072.0001'",
      "2:15: y must be between -131072 and 131072, not '-99999999999999999999'"}},
    {"StartOnALine", withLines("-50 0 50 0\n"), {"2:3" + kNotFree}},
    {"StartOnAPoint", withLines("0 5 0 5\n"), {"2:3" + kNotFree, "6:1: a line without length: it blocks as a point"}},
    {"StartAtACorner", "TETRAHEDRON\n0 0 230.9 0\n1 0 0\n400\n" + kFaces, {"2:3" + kNotFree}},
    {"GoalMissing",
     "TETRAHEDRON\n0 0 0 0\n400\n" + kFaces,
     {"3:1: face must be between 0 and 3, not '400'", "3:4: the goal is: face x y; x is missing",
      "4:1: a line is missing before this: the face size"}},
    {"GoalWithFourNumbers",
     "TETRAHEDRON\n0 0 0 0\n1 0 0 90\n400\n" + kFaces,
     {"3:7: the goal is: face x y; '90' is too much"}},
    {"GoalFaceTooLarge",
     "ICOSAHEDRON\n19 0 0 0\n20 0 0\n400\n" + kFaces + kFaces + kFaces + kFaces + kFaces,
     {"3:1: face must be between 0 and 19, not '20'"}},
    {"GoalOutsideItsFace", "TETRAHEDRON\n0 0 0 0\n1 0 231\n400\n" + kFaces, {"3:3: the goal lies outside its face"}},
    {"GoalNoNumber",
     "TETRAHEDRON\n0 0 0 0\n1 1e2 0,5\n400\n" + kFaces,
     {"3:3: x" + kNoNumber + "'1e2'", "3:7: y" + kNoNumber + "'0,5'"}},
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
     {"4:5: the face size is one number; '400' is too much"}},
    {"FaceSizeMissing",
     "TETRAHEDRON\n0 0 0 0\n1 0 0\n" + kFaces,
     {"4:1: a line is missing before this: the face size"}},
    {"OnlyFaces",
     "TETRAHEDRON\n" + kFaces,
     {"2:1: a line is missing before this: the start: face x y degrees",
      "2:1: a line is missing before this: the goal: face x y", "2:1: a line is missing before this: the face size"}},
    {"NoFaces", kHead, {"4:4: the text ends after 0 of 4 faces: each needs a '%'"}},
    {"TooFewFaces", kHead + "%\n%\n%\n0 0 5 5 # end", {"8:14: the text ends after 3 of 4 faces: each needs a '%'"}},
    {"TooManyFaces",
     kHead + kFaces + "%\n0 0 0 5\n%\n",
     {"9:1: one '%' too many: this is number 5, but the solid has 4 faces",
      "11:1: one '%' too many: this is number 6, but the solid has 4 faces"}},
    {"LineBeforeTheFirstFace",
     kHead + "0 50 9 50\n0 60 9 60\n" + kFaces,
     {"5:1: a line before the first '%': every face begins with a '%'"}},
    {"FaceMarkNotAlone", kHead + "%\n% 0 0 5 5\n%\n%\n", {"6:3: '%' stands alone on its line: move '0' to the next"}},
    {"FaceMarkJoined",
     kHead + "%\n%0 0 5 5\n%\n%\n",
     {"6:1: x0" + kNoNumber + "'%0'", "8:2: the text ends after 3 of 4 faces: each needs a '%'"}},
    {"LineWithThreeNumbers", withLines("40 50 60\n"), {"6:9: a line is: x0 y0 x1 y1; y1 is missing"}},
    {"LineWithOneNumber", withLines("\t40  \n"), {"6:4: a line is: x0 y0 x1 y1; y0 is missing"}},
    {"LineWithFiveNumbers", withLines("40 50 60 50 0\n"), {"6:13: a line is: x0 y0 x1 y1; '0' is too much"}},
    {"LineNoNumber", withLines("40 x 60 50\n"), {"6:4: y0" + kNoNumber + "'x'"}},
    {"LineWithPlus", withLines("+40 50 60 50\n"), {"6:1: x0" + kNoNumber + "'+40'"}},
    {"LineWithBarePoint",
     withLines("40 .5 60. 50\n"),
     {"6:4: y0" + kNoNumber + "'.5'", "6:7: x1" + kNoNumber + "'60.'"}},
    {"LineNotANumberByName",
     withLines("nan inf -inf 0x10\n"),
     {"6:1: x0" + kNoNumber + "'nan'", "6:5: y0" + kNoNumber + "'inf'", "6:9: x1" + kNoNumber + "'-inf'",
      "6:14: y1" + kNoNumber + "'0x10'"}},
    {"LineWithFiveDecimals",
     withLines("40 50.12345 60 50\n"),
     {"6:4: y0 must have at most four decimals, not '50.12345'"}},
    {"LineBeyondAllCoordinates",
     withLines("40 50 600000 50\n"),
     {"6:7: x1 must be between -131072 and 131072, not '600000'"}},
    {"LineWhollyOutside", withLines("-200 200 -100 200\n"), {"6:1: the line lies wholly outside its face"}},
    {"LineBehindACorner", withLines("  -60 232 60 232\n"), {"6:3: the line lies wholly outside its face"}},
    {"PointOutside", withLines("300 0 300 0\n"), {"6:1: the line lies wholly outside its face"}},
    {"NulByte", kHead + bytes({"%\n0\0 0 0 5\n%\n%\n%\n", 17}), {"6:2: control character 0x00" + kOnlyTabs}},
    {"EscapeInAComment", "# \x1b[2J\n" + kHead + kFaces, {"1:3: control character 0x1b" + kOnlyTabs}},
    {"FormFeed", "TETRAHEDRON\f\n0 0 0 0\n1 0 0\n400\n" + kFaces, {"1:12: control character 0x0c" + kOnlyTabs}},
    {"CarriageReturnAlone",
     "TETRAHEDRON\r0 0 0 0\n1 0 0 0\n1 0 0\n400\n" + kFaces,
     {"1:12: control character 0x0d" + kOnlyTabs}},
    {"Latin1", "# author: Andr\xe9\n" + kHead + kFaces, {"1:15: the text is no valid UTF-8 here"}},
    {"Utf16",
     bytes({"\xff\xfeT\0E\0", 6}),
     {"1:1: the text is no valid UTF-8 here", "1:7: a line is missing before this: the start: face x y degrees",
      "1:7: a line is missing before this: the goal: face x y", "1:7: a line is missing before this: the face size"}},
    {"NoBreakSpace",
     withLines("40\xc2\xa0"
               "50 60 50\n"),
     {"6:1: x0" + kNoNumber + "'40??50'", "6:13: a line is: x0 y0 x1 y1; y1 is missing"}},
    {"TwoTitles", "# title: a\n# title: b\n" + kHead + kFaces, {"2:1: a second 'title:': give it once"}},
    {"LongAuthor",
     "# author: " + std::string(101, 'x') + "\n" + kHead + kFaces,
     {"1:1: 'author:' has 101 bytes: at most 100 are allowed"}},
    {"ManyFaults",
     "PLATON\n0 0\n1 0 zero\n10\n%\n1 2 3\n",
     {"1:1: unknown solid 'PLATON'" + kSolids, "2:4: the start is: face x y degrees; y is missing",
      "3:5: y" + kNoNumber + "'zero'", "4:1: face size must be between 200 and 65536, not '10'",
      "6:6: a line is: x0 y0 x1 y1; y1 is missing"}},
};

void PrintTo(const Faulty& faulty, std::ostream* out) { *out << faulty.name; }

class LevelFaultsTest : public testing::TestWithParam<Faulty> {};

TEST_P(LevelFaultsTest, IsReportedWhereItStands) {
  const LevelResult result = loadLevel(GetParam().text);
  EXPECT_EQ(result.level, nullptr);
  std::vector<std::string> found;
  for (const Diagnostic& one : result.diagnostics) {
    found.push_back(std::to_string(one.line) + ":" + std::to_string(one.column) + ": " + one.message);
  }
  EXPECT_EQ(found, GetParam().errors);
}

INSTANTIATE_TEST_SUITE_P(All, LevelFaultsTest, testing::ValuesIn(kFaulty),
                         [](const auto& spec) { return std::string(spec.param.name); });

}  // namespace
}  // namespace platon
