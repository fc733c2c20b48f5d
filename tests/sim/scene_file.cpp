#include "tests/sim/scene_file.h"

#include <optional>
#include <stdexcept>

#include "platon/exact/integer.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "tests/sim/sim_options.h"

namespace platon::sim {
namespace {

struct Word {
  std::string_view text;
  int line;
  int column;
};

struct Placed {
  Point position;
  Word word;
};

std::vector<Word> wordsOf(std::string_view text, int line) {
  std::vector<Word> words;
  text = text.substr(0, text.find('#'));
  constexpr std::string_view space = " \t\r";
  for (std::size_t at = text.find_first_not_of(space); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(space, at), text.size());
    words.push_back({text.substr(at, end - at), line, static_cast<int>(at) + 1});
    at = text.find_first_not_of(space, end);
  }
  return words;
}

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  void line(const std::vector<Word>& words) {
    if (words.empty()) return;
    const Word& name = words.front();
    if (name.text == "shape") {
      shape(words);
    } else if (name.text == "line") {
      if (const auto points = pointsOf(words, 2)) lines_.push_back({(*points)[0], (*points)[1]});
    } else if (name.text == "entity") {
      if (const auto points = pointsOf(words, 1)) entities_.push_back({(*points)[0], name});
    } else if (name.text == "velocity") {
      velocity(words);
    } else {
      fault(name, "unknown word '" + std::string(name.text) + "': use shape, line, entity or velocity");
    }
  }

  Scene finish() {
    if (!shape_ && !shapeSeen_) faultAtEnd("the scene has no shape: add a line 'shape x y x y …'");
    if (entities_.empty()) faultAtEnd("the scene has no entity: add a line 'entity x y'");
    stopAtFaults();
    Scene scene{World(), Convex(*shape_), velocity_.value_or(Point())};
    MapPart part(scene.world, 0);
    for (const Segment& line : lines_) part.line(line.a, line.b);
    part.initialize();
    for (const Placed& placed : entities_) place(scene, part, placed);
    stopAtFaults();
    return scene;
  }

  void setEnd(int line) { lastLine_ = line; }

 private:
  void fault(const Word& word, const std::string& message) { fault(word.line, word.column, message); }
  void faultAtEnd(const std::string& message) { fault(lastLine_, 1, message); }
  void fault(int line, int column, const std::string& message) {
    faults_ += file_ + ":" + std::to_string(line) + ":" + std::to_string(column) + ": error: " + message + "\n";
  }
  void stopAtFaults() const {
    if (!faults_.empty()) throw InputError(faults_.substr(0, faults_.size() - 1));
  }

  std::optional<std::vector<Point>> pointsOf(const std::vector<Word>& words, std::size_t count) {
    if (count != 0 && words.size() != 1 + 2 * count) {
      fault(words.front(), "'" + std::string(words.front().text) + "' takes " + std::to_string(2 * count) +
                               " numbers, not " + std::to_string(words.size() - 1));
      return std::nullopt;
    }
    std::vector<std::int32_t> numbers;
    for (std::size_t i = 1; i < words.size(); ++i) {
      const auto number = wholeNumber(words[i].text, -kCoordinateLimit + 1, kCoordinateLimit - 1);
      if (!number) fault(words[i], "'" + std::string(words[i].text) + "' is not an integer below 2^29 in magnitude");
      numbers.push_back(static_cast<std::int32_t>(number.value_or(0)));
    }
    if (numbers.size() % 2 != 0) {
      fault(words.front(), "odd number of coordinates");
      return std::nullopt;
    }
    std::vector<Point> points;
    for (std::size_t i = 0; i < numbers.size(); i += 2) points.emplace_back(numbers[i], numbers[i + 1]);
    return points;
  }

  void shape(const std::vector<Word>& words) {
    if (shapeSeen_) fault(words.front(), "second shape: remove one of them");
    shapeSeen_ = true;
    shape_ = pointsOf(words, 0);
    if (!shape_) return;
    if (const auto reason = Convex::fault(*shape_)) fault(words.front(), *reason);
  }

  void velocity(const std::vector<Word>& words) {
    if (velocity_) fault(words.front(), "second velocity: remove one of them");
    const auto points = pointsOf(words, 1);
    velocity_ = points ? points->front() : Point();
    if (!isVelocity(*velocity_)) fault(words.front(), "the velocity must be below 2^28 subunits per tick");
  }

  void place(Scene& scene, MapPart& part, const Placed& placed) {
    try {
      Entity entity(scene.world, scene.shape);
      part.insert(entity, placed.position, Angle());
    } catch (const std::invalid_argument& reason) {
      fault(placed.word, reason.what());
    }
  }

  const std::string& file_;
  std::string faults_;
  std::optional<std::vector<Point>> shape_;
  bool shapeSeen_ = false;
  std::vector<Segment> lines_;
  std::vector<Placed> entities_;
  std::optional<Point> velocity_;
  int lastLine_ = 1;
};

}  // namespace

Scene loadScene(const std::string& file, std::string_view text) {
  Reader reader(file);
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    reader.line(wordsOf(text.substr(0, end), number));
    reader.setEnd(number);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  return reader.finish();
}

}  // namespace platon::sim
