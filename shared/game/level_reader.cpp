#include "shared/game/level_reader.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <span>
#include <tuple>
#include <utility>

#include "platon/game/level_text.h"
#include "platon/game/stage.h"
#include "shared/game/element_words.h"
#include "shared/game/face_area.h"
#include "shared/game/level_number.h"

namespace platon {
namespace {

constexpr std::string_view kHeaderNames[LevelLine::kHeaderLines] = {
    "the solid, such as HEXAHEDRON", "the start (face x y degrees)", "the goal (face x y)", "the face size"};

// Largest number of crossings or players that a level can state.
constexpr std::int64_t kMaxCount = 255;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::optional<SolidKind> kindOf(std::string_view name) {
  for (int i = 0; i < kSolidKinds; ++i) {
    if (nameOf(static_cast<SolidKind>(i)) == name) return static_cast<SolidKind>(i);
  }
  return std::nullopt;
}

FinePoint finePoint(const LevelNumber& x, const LevelNumber& y) {
  return {x.tenThousandths * FinePoint::kPerTenThousandth, y.tenThousandths * FinePoint::kPerTenThousandth};
}

bool isPoint(FinePoint a, FinePoint b) { return a.x == b.x && a.y == b.y; }

// True when a longer line a–b only touches the face. `segment` is its part on the face.
bool isTouch(FinePoint a, FinePoint b, const Segment& segment) {
  constexpr std::int64_t longest = 2;
  constexpr std::int64_t longestFine = (longest + 1) * FinePoint::kPerSubunit;
  return squaredLength(segment.b - segment.a) <= longest * longest &&
         std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)) > longestFine;
}

bool insidePost(const Post& post, const Segment& line) {
  // The cut runs clockwise about the corner, so that the corner is on its right.
  const Point along = post.cut.b - post.cut.a;
  return cross(along, line.a - post.cut.a) <= 0 && cross(along, line.b - post.cut.a) <= 0;
}

// A number of a line: its name in messages and its range.
struct Field {
  std::string_view name;
  std::int64_t low;
  std::int64_t high;
  bool whole;

  static constexpr Field coordinate(std::string_view name) {
    return {name, -FaceArea::kMaxUnits, FaceArea::kMaxUnits, false};
  }
};

bool readField(const LevelLine& line, const LevelToken& token, const Field& field, LevelNumber& number,
               Diagnostics& diagnostics) {
  const auto fail = [&](const std::string& rule) {
    diagnostics.error({line.number, token.column},
                      std::string(field.name) + " " + rule + ", not " + quoted(token.text));
    return false;
  };
  const NumberFault fault = parseNumber(token.text, std::max(-field.low, field.high), number);
  if (fault == NumberFault::kNotANumber) {
    return fail(field.whole ? "must be a whole number such as 12" : "must be a number such as -12 or 0.25");
  }
  if (field.whole && (fault == NumberFault::kTooManyDecimals || token.text.find('.') != std::string_view::npos)) {
    return fail("must be a whole number");
  }
  if (fault == NumberFault::kTooManyDecimals) return fail("must have at most four decimals");
  const std::int64_t value = number.tenThousandths;
  if (fault == NumberFault::kTooLarge || value < field.low * LevelNumber::kOne ||
      value > field.high * LevelNumber::kOne) {
    return fail("must be between " + std::to_string(field.low) + " and " + std::to_string(field.high));
  }
  return true;
}

// `tokens` are those of the line that are to be the fields.
bool readFields(const LevelLine& line, std::span<const LevelToken> tokens, std::string_view what,
                std::span<const Field> fields, std::span<LevelNumber> numbers, Diagnostics& diagnostics) {
  bool good = true;
  for (std::size_t i = 0; i < std::min(tokens.size(), fields.size()); ++i) {
    good = readField(line, tokens[i], fields[i], numbers[i], diagnostics) && good;
  }
  if (tokens.size() < fields.size()) {
    diagnostics.error({line.number, line.end},
                      "missing " + std::string(fields[tokens.size()].name) + ": " + std::string(what));
  } else if (tokens.size() > fields.size()) {
    const LevelToken& extra = tokens[fields.size()];
    diagnostics.error({line.number, extra.column}, "unexpected " + quoted(extra.text) + ": " + std::string(what));
  }
  return good && tokens.size() == fields.size();
}

void readName(const LevelLine& line, std::string_view key, std::string& name, Diagnostics& diagnostics) {
  const std::string_view content = trimmed(line.comment.substr(1));
  if (!content.starts_with(key)) return;
  const std::string_view value = trimmed(content.substr(key.size()));
  const TextPosition at{line.number, line.commentColumn};
  if (!name.empty()) {
    diagnostics.error(at, "second '" + std::string(key) + "': remove one of them");
  } else if (value.size() > LevelDraft::kMaxNameBytes) {
    diagnostics.error(at, "'" + std::string(key) + "' has " + std::to_string(value.size()) + " bytes: at most " +
                              std::to_string(LevelDraft::kMaxNameBytes) + " are allowed");
  } else {
    name = value;
  }
}

void readCount(const LevelLine& line, std::string_view key, std::uint32_t low, std::optional<std::uint32_t>& count,
               Diagnostics& diagnostics) {
  const std::string_view content = trimmed(line.comment.substr(1));
  if (!content.starts_with(key)) return;
  const std::string_view value = trimmed(content.substr(key.size()));
  const TextPosition at{line.number, line.commentColumn};
  LevelNumber number;
  if (count) {
    diagnostics.error(at, "second '" + std::string(key) + "': remove one of them");
  } else if (parseNumber(value, kMaxCount, number) != NumberFault::kNone || number.whole() < low ||
             value.find('.') != std::string_view::npos) {
    diagnostics.error(at, "'" + std::string(key) + "' must be a whole number between " + std::to_string(low) + " and " +
                              std::to_string(kMaxCount) + ", not " + quoted(value));
  } else {
    count = static_cast<std::uint32_t>(number.whole());
  }
}

void readNeeds(const LevelLine& line, LevelDraft& draft, Diagnostics& diagnostics) {
  constexpr std::string_view key = "needs:";
  const std::string_view content = trimmed(line.comment.substr(1));
  if (!content.starts_with(key)) return;
  const TextPosition at{line.number, line.commentColumn};
  if (!draft.needs.empty()) return diagnostics.error(at, "second 'needs:': remove one of them");
  draft.needsAt = at;
  for (std::size_t begin = key.size(), end = 0; end != content.size(); begin = end + 1) {
    end = std::min(content.find(',', begin), content.size());
    const std::string_view text = trimmed(content.substr(begin, end - begin));
    const auto need = needOf(text);
    if (!need) {
      return diagnostics.error(
          at, "'needs:' must name keys, plates or checkpoints, such as 'key 1, checkpoint', not " + quoted(text));
    }
    draft.needs.push_back(*need);
  }
}

// What a comment before the solid says of the level.
void readComment(const LevelLine& line, LevelDraft& draft, Diagnostics& diagnostics) {
  if (line.comment.empty()) return;
  readName(line, "title:", draft.title, diagnostics);
  readName(line, "author:", draft.author, diagnostics);
  readCount(line, "crossings:", 0, draft.crossings, diagnostics);
  readCount(line, "players:", 1, draft.players, diagnostics);
  readNeeds(line, draft, diagnostics);
}

// A segment of the draft with its position in the text.
struct PlacedSegment {
  std::size_t face;
  Segment segment;
  TextPosition at;
};

void warnOfDuplicates(std::vector<PlacedSegment> placed, Diagnostics& diagnostics) {
  const auto key = [](const PlacedSegment& one) {
    const auto [a, b] = one.segment;
    const bool swapped = std::tie(b.x, b.y) < std::tie(a.x, a.y);
    const Point first = swapped ? b : a;
    const Point last = swapped ? a : b;
    return std::tuple(one.face, first.x, first.y, last.x, last.y);
  };
  std::stable_sort(placed.begin(), placed.end(),
                   [&](const PlacedSegment& a, const PlacedSegment& b) { return key(a) < key(b); });
  for (std::size_t i = 1; i < placed.size(); ++i) {
    if (key(placed[i - 1]) != key(placed[i])) continue;
    diagnostics.warning(placed[i].at,
                        "duplicate of line " + std::to_string(placed[i - 1].at.line) + ": remove one of the two");
  }
}

// Of segments that a player touches at the same time, the contact is with the first one. So a plate that lies on a
// floor is pressed.
void putElementsFirst(LevelDraft& draft) {
  std::size_t next = 0;
  for (std::size_t face = 0; face < draft.segments.size(); ++face) {
    const std::vector<Segment> segments = std::move(draft.segments[face]);
    const std::vector<TextPosition> positions = std::move(draft.positions[face]);
    std::vector<std::uint32_t> order;  // elements, then the others
    std::vector<bool> isElement(segments.size());
    for (; next < draft.elements.size() && draft.elements[next].face == face; ++next) {
      std::uint32_t& segment = draft.elements[next].segment;
      isElement[segment] = true;
      order.push_back(std::exchange(segment, static_cast<std::uint32_t>(order.size())));
    }
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
      if (!isElement[i]) order.push_back(i);
    }
    draft.segments[face].clear();
    draft.positions[face].clear();
    for (const std::uint32_t i : order) {
      draft.segments[face].push_back(segments[i]);
      draft.positions[face].push_back(positions[i]);
    }
  }
}

// Gives meaning to the lines of a level text.
class LevelReader {
 public:
  explicit LevelReader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  LevelDraft read(LevelText text);

 private:
  void readLine(const LevelLine& line);
  void readHeader(const LevelLine& line);
  void readSolid(const LevelLine& line);
  std::optional<LevelPlace> readPlace(const LevelLine& line, std::string_view what, std::span<const Field> fields);
  void readFaceSize(const LevelLine& line);
  void readFaceMark(const LevelLine& line);
  void readSegment(const LevelLine& line);
  void addSegment(const LevelLine& line, std::span<const LevelNumber> numbers);
  void warnOfShape(TextPosition at, FinePoint a, FinePoint b, const Segment& segment);
  void addElement(const LevelLine& line, const Segment& segment);
  void reportMissingHeader(TextPosition at);
  void checkInside(std::optional<LevelPlace>& place, std::string_view what);

  Diagnostics& diagnostics_;
  LevelDraft draft_;
  std::size_t header_ = 0;        // header lines read so far
  std::size_t segments_ = 0;      // lines of faces read so far, one segment each
  std::optional<FaceArea> area_;  // set once solid and face size are known, and so are posts_
  std::vector<Post> posts_;
  std::vector<PlacedSegment> placed_;  // every segment of the draft
};

LevelDraft LevelReader::read(LevelText text) {
  for (LevelLine line; text.next(line);) readLine(line);
  const TextPosition end{text.lines(), text.endOfLine()};
  reportMissingHeader(end);
  if (draft_.solid && static_cast<std::size_t>(text.faces()) < draft_.segments.size()) {
    diagnostics_.error(end, "the level ends after " + std::to_string(text.faces()) + " of " +
                                std::to_string(draft_.segments.size()) + " faces: each begins with a '%'");
  }
  checkInside(draft_.start, "the start");
  checkInside(draft_.goal, "the goal");
  putElementsFirst(draft_);
  warnOfDuplicates(std::move(placed_), diagnostics_);
  return std::move(draft_);
}

// A comment behind a fault counts as one on a line of its own.
void LevelReader::readLine(const LevelLine& line) {
  if (line.fault) diagnostics_.error({line.number, line.fault->column}, line.fault->message);
  const bool isBare = line.tokens.empty() || line.isUnreadable();
  if (header_ == 0 && isBare && !(line.fault && line.fault->inComment)) readComment(line, draft_, diagnostics_);
  switch (line.role) {
    case LevelLine::Role::kNone:
      return;
    case LevelLine::Role::kHeader:
      return readHeader(line);
    case LevelLine::Role::kFaceMark:
      return readFaceMark(line);
    case LevelLine::Role::kSegment:
      if (!line.isUnreadable()) readSegment(line);
  }
}

void LevelReader::readHeader(const LevelLine& line) {
  const std::size_t index = header_++;
  if (line.isUnreadable()) return;
  const std::int64_t faces = draft_.solid ? PlatonicSolid::of(*draft_.solid).faces() : FaceArea::kMaxUnits;
  const Field start[] = {
      {"face", 0, faces - 1, true}, Field::coordinate("x"), Field::coordinate("y"), {"degrees", -360, 360, true}};
  switch (index) {
    case 0:
      return readSolid(line);
    case 1:
      draft_.start = readPlace(line, "the start is 'face x y degrees'", start);
      return;
    case 2:
      draft_.goal = readPlace(line, "the goal is 'face x y'", std::span(start).first(3));
      return;
    default:
      return readFaceSize(line);
  }
}

void LevelReader::readSolid(const LevelLine& line) {
  const LevelToken& name = line.tokens[0];
  draft_.solid = kindOf(name.text);
  if (!draft_.solid) {
    diagnostics_.error({line.number, name.column},
                       "unknown solid " + quoted(name.text) +
                           ": use TETRAHEDRON, HEXAHEDRON, OCTAHEDRON, DODECAHEDRON or ICOSAHEDRON");
    return;
  }
  draft_.segments.resize(static_cast<std::size_t>(PlatonicSolid::of(*draft_.solid).faces()));
  draft_.positions.resize(draft_.segments.size());
  if (line.tokens.size() > 1) {
    diagnostics_.error({line.number, line.tokens[1].column},
                       "unexpected " + quoted(line.tokens[1].text) + " after the solid: remove it");
  }
}

std::optional<LevelPlace> LevelReader::readPlace(const LevelLine& line, std::string_view what,
                                                 std::span<const Field> fields) {
  std::array<LevelNumber, 4> numbers;
  if (!readFields(line, line.tokens, what, fields, numbers, diagnostics_)) return std::nullopt;
  LevelPlace place;
  place.face = static_cast<std::uint32_t>(numbers[0].whole());
  place.point = {numbers[1].subunits(), numbers[2].subunits()};
  place.angle = Angle::degrees(static_cast<std::int32_t>(numbers[3].whole()));
  place.at = {line.number, line.tokens[1].column};
  return place;
}

void LevelReader::readFaceSize(const LevelLine& line) {
  const Field field{"face size", kMinFaceSize, kMaxFaceSize, true};
  LevelNumber size;
  if (!readFields(line, line.tokens, "the face size is one number", {&field, 1}, {&size, 1}, diagnostics_)) return;
  draft_.faceSize = static_cast<std::int32_t>(size.whole());
  if (!draft_.solid) return;
  area_.emplace(facePolygon(*draft_.solid, *draft_.faceSize));
  posts_ = postsOf(*draft_.solid, *draft_.faceSize);
}

void LevelReader::readFaceMark(const LevelLine& line) {
  const TextPosition at{line.number, line.tokens[0].column};
  reportMissingHeader(at);
  const std::size_t faceCount = draft_.segments.size();
  if (draft_.solid && static_cast<std::size_t>(line.face) >= faceCount) {
    diagnostics_.error(at, "too many '%': this is number " + std::to_string(line.face + 1) + ", but the solid has " +
                               std::to_string(faceCount) + " faces");
  }
  if (line.tokens.size() > 1) {
    diagnostics_.error({line.number, line.tokens[1].column},
                       "unexpected " + quoted(line.tokens[1].text) + " after '%': move it to the next line");
  }
}

void LevelReader::reportMissingHeader(TextPosition at) {
  for (; header_ < LevelLine::kHeaderLines; ++header_) {
    diagnostics_.error(at, "missing line: " + std::string(kHeaderNames[header_]));
  }
}

void LevelReader::readSegment(const LevelLine& line) {
  static constexpr std::array<Field, 4> fields = {Field::coordinate("x0"), Field::coordinate("y0"),
                                                  Field::coordinate("x1"), Field::coordinate("y1")};
  std::array<LevelNumber, 4> numbers;
  const auto ends = std::span(line.tokens).first(std::min(line.tokens.size(), fields.size()));  // without the word
  const bool good = readFields(line, ends, "a line is 'x0 y0 x1 y1'", fields, numbers, diagnostics_);
  const TextPosition at{line.number, line.tokens[0].column};
  if (segments_++ == 0 && line.face < 0) {
    diagnostics_.error(at, "line before the first '%': every face begins with a '%'");
  }
  if (segments_ == LevelDraft::kMaxLines + 1) {
    diagnostics_.error(at, "more than " + std::to_string(LevelDraft::kMaxLines) + " lines: remove some");
  }
  if (good && segments_ <= LevelDraft::kMaxLines) addSegment(line, numbers);
}

void LevelReader::addSegment(const LevelLine& line, std::span<const LevelNumber> numbers) {
  if (!area_ || line.face < 0 || static_cast<std::size_t>(line.face) >= draft_.segments.size()) return;
  const auto face = static_cast<std::size_t>(line.face);
  const TextPosition at{line.number, line.tokens[0].column};
  const FinePoint a = finePoint(numbers[0], numbers[1]);
  const FinePoint b = finePoint(numbers[2], numbers[3]);
  const auto segment = area_->clip(a, b);
  if (!segment) {
    diagnostics_.error(at, "the line is outside its face: move or remove it");
    return;
  }
  warnOfShape(at, a, b, *segment);
  if (line.tokens.size() > numbers.size()) addElement(line, *segment);
  draft_.segments[face].push_back(*segment);
  draft_.positions[face].push_back(at);
  placed_.push_back({face, *segment, at});
}

// `a` and `b` are its ends in the text.
void LevelReader::warnOfShape(TextPosition at, FinePoint a, FinePoint b, const Segment& segment) {
  if (isPoint(a, b)) {
    diagnostics_.warning(at, "the line has no length: it blocks as a point");
  } else if (isTouch(a, b, segment)) {
    diagnostics_.warning(at, "the line only touches its face: move it inside, or remove it");
  }
  if (std::any_of(posts_.begin(), posts_.end(), [&](const Post& post) { return insidePost(post, segment); })) {
    diagnostics_.warning(at, "the line has no effect: it is in a corner of its face, which blocks already; remove it");
  }
}

void LevelReader::addElement(const LevelLine& line, const Segment& segment) {
  const auto words = std::span(line.tokens).subspan(4);
  const auto edges = static_cast<std::uint32_t>(PlatonicSolid::of(*draft_.solid).edgesPerFace());
  const auto word = readElementWord(line, words, edges, diagnostics_);
  if (!word) return;
  const TextPosition at{line.number, words[0].column};
  if (word->kind == ElementKind::kOneway && segment.a == segment.b)
    diagnostics_.error(at, "a 'oneway' without length has no sides: give it two ends");
  if (draft_.elements.size() == LevelDraft::kMaxElements)
    diagnostics_.error(at, "more than " + std::to_string(LevelDraft::kMaxElements) + " lines with a word: remove some");
  if (draft_.elements.size() >= LevelDraft::kMaxElements) return;
  const auto face = static_cast<std::size_t>(line.face);
  draft_.elements.push_back({word->kind, word->number, word->openTicks, static_cast<std::uint32_t>(face),
                             static_cast<std::uint32_t>(draft_.segments[face].size()), segment});
}

void LevelReader::checkInside(std::optional<LevelPlace>& place, std::string_view what) {
  if (!place || !area_ || area_->contains(place->point)) return;
  diagnostics_.error(place->at, std::string(what) + " is outside its face: move it inside");
  place.reset();
}

}  // namespace

LevelDraft readLevel(std::string_view text, Diagnostics& diagnostics) {
  return LevelReader(diagnostics).read(LevelText(text));
}

}  // namespace platon
