#include "client/play/offscreen/step_play.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <utility>

#include "client/gl/image.h"
#include "client/play/title_screen.h"
#include "client/ui/controls/key_names.h"
#include "client/ui/overlay.h"
#include "platon/game/utf8.h"

namespace platon {
namespace {

constexpr Time kStart = std::chrono::seconds(1000);
// A frame lasts no less than a tick, so that a tick is due in each.
constexpr Time kFrame = std::chrono::microseconds(1'000'000 / kTicksPerSecond + 1);
// As on a desktop: a key that is held repeats after half a second, 30 times a second.
constexpr std::uint64_t kRepeatDelay = kTicksPerSecond / 2;
constexpr std::uint64_t kRepeatFrames = kTicksPerSecond / 30;

constexpr const char* kKeyExamples = "such as a, 7, space, enter, esc, arrow-left, shift or f1";
constexpr const char* kCommands =
    "press KEY, release KEY, tap KEY [SECONDS], type TEXT, move X Y, click X Y, scroll NOTCHES, wait SECONDS, shot "
    "FILE.png or quit";

std::string lowered(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

// The key that types this character, if it is one that a text and the settings name alike.
std::optional<Key> keyThatTypes(char32_t character) {
  if (character == U' ') return Key::kSpace;
  if (character == U'-') return Key::kMinus;
  if (character >= 0x80) return std::nullopt;
  const std::string name(1, static_cast<char>(character));
  return keyOfName(name);
}

// The character that a key types; 0: none.
char32_t characterOf(Key key, bool shift) {
  if (key == Key::kSpace) return U' ';
  if (key == Key::kMinus) return U'-';
  const std::string_view name = shownNameOf(key);
  if (name.size() != 1) return 0;
  const bool isLetter = name[0] >= 'A' && name[0] <= 'Z';
  return static_cast<char32_t>(isLetter && !shift ? name[0] - 'A' + 'a' : name[0]);
}

}  // namespace

// The words of a command behind the first one. What is wrong with them is thrown as std::invalid_argument.
class StepPlay::Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  std::string take() {
    skipSpaces();
    const std::string word(rest_.substr(0, rest_.find(' ')));
    rest_.remove_prefix(word.size());
    skipSpaces();
    return word;
  }
  Key takeKey() {
    const std::string word = take();
    const std::optional<Key> key = keyOfName(word);
    if (!key) throw std::invalid_argument("'" + word + "' is no key: name one, " + kKeyExamples);
    return *key;
  }
  // `what` is to be within these limits.
  double takeNumber(const std::string& what, double least, double most) {
    const std::string word = take();
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool isNumber = error == std::errc() && end == word.data() + word.size();
    if (isNumber && number >= least && number <= most) return number;
    std::array<char, 80> limits{};
    std::snprintf(limits.data(), limits.size(), " must be a number from %g to %g", least, most);
    throw std::invalid_argument(what + limits.data());
  }
  double takeSeconds() { return takeNumber("SECONDS", 0, kMaxSeconds); }
  bool atEnd() const { return rest_.empty(); }
  void end() const {
    if (!atEnd()) throw std::invalid_argument("leave out '" + std::string(rest_) + "', which is too much");
  }
  std::string rest() const { return std::string(rest_); }

 private:
  void skipSpaces() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

  std::string_view rest_;
};

std::optional<Key> keyOfName(std::string_view name) {
  const std::string lower = lowered(name);
  for (std::size_t i = 0; i < kKeyCount && !lower.empty(); ++i) {
    const Key key = static_cast<Key>(i);
    if (wordOf(key) == lower || lowered(shownNameOf(key)) == lower) return key;
  }
  return std::nullopt;
}

StepPlay::StepPlay(const ClientOptions& options)
    : now_(kStart),
      clock_{[this] { return now_; }, [this](Time until) { now_ = std::max(now_, until); }},
      window_(options.frames.width, options.frames.width * 9 / 16),
      desk_(options, clock_, window_, &OpenalOutput::openLoopback),
      screens_(std::make_unique<TitleScreen>(desk_)) {
  desk_.view.setPainted(false);
  frame();
}

StepPlay::~StepPlay() { screens_.close(); }

std::string StepPlay::obey(const std::string& command) {
  try {
    perform(command);
  } catch (const std::invalid_argument& error) {
    return std::string("error: ") + error.what();
  }
  std::array<char, 32> answer{};
  std::snprintf(answer.data(), answer.size(), "ok %.2f", static_cast<double>(frames_) / kTicksPerSecond);
  return answer.data();
}

void StepPlay::perform(const std::string& command) {
  struct Command {
    std::string_view word;
    void (StepPlay::*perform)(Words& words);
  };
  static constexpr std::array<Command, 10> kTable{{{"press", &StepPlay::press},
                                                   {"release", &StepPlay::release},
                                                   {"tap", &StepPlay::tap},
                                                   {"type", &StepPlay::type},
                                                   {"move", &StepPlay::move},
                                                   {"click", &StepPlay::click},
                                                   {"scroll", &StepPlay::scroll},
                                                   {"wait", &StepPlay::wait},
                                                   {"shot", &StepPlay::shoot},
                                                   {"quit", &StepPlay::quit}}};
  Words words(command);
  const std::string word = words.take();
  const auto* const found =
      std::find_if(kTable.begin(), kTable.end(), [&word](const Command& each) { return each.word == word; });
  if (found == kTable.end()) throw std::invalid_argument("'" + word + "' is no command: give " + kCommands);
  (this->*found->perform)(words);
}

void StepPlay::press(Words& words) {
  const Key key = words.takeKey();
  words.end();
  hold(key);
}

void StepPlay::release(Words& words) {
  const Key key = words.takeKey();
  words.end();
  letGo(key);
}

void StepPlay::tap(Words& words) {
  const Key key = words.takeKey();
  const double seconds = words.atEnd() ? kTapSeconds : words.takeSeconds();
  words.end();
  hold(key);
  pass(seconds);
  letGo(key);
}

void StepPlay::type(Words& words) {
  for (const char32_t character : codePointsOf(words.rest())) {
    const std::optional<Key> key = keyThatTypes(character);
    if (key) sendKey(*key, KeyEvent::Kind::kPress);
    sendCharacter(character);
    frame();
    if (key) sendKey(*key, KeyEvent::Kind::kRelease);
  }
}

void StepPlay::move(Words& words) {
  pointer_.kind = PointerEvent::Kind::kMove;
  const double x = words.takeNumber("X", 0, window_.pixelWidth());
  const double y = words.takeNumber("Y", 0, window_.pixelHeight());
  words.end();
  pointer_.place = glm::dvec2(x, y) * (double{Overlay::kHeight} / window_.pixelHeight());
  send(PointerEvent::Kind::kMove);
}

void StepPlay::click(Words& words) {
  move(words);
  send(PointerEvent::Kind::kPress);
  frame();
  send(PointerEvent::Kind::kRelease);
}

void StepPlay::scroll(Words& words) {
  pointer_.scroll = words.takeNumber("NOTCHES", -100, 100);
  words.end();
  send(PointerEvent::Kind::kScroll);
}

void StepPlay::wait(Words& words) {
  const double seconds = words.takeSeconds();
  words.end();
  pass(seconds);
}

// What has moved since the last frame is in the picture, too.
void StepPlay::shoot(Words& words) {
  const std::string file = words.rest();
  if (file.empty()) throw std::invalid_argument("name the file to write, such as shot 1.png");
  desk_.view.setPainted(true);
  screens_.draw({now_, 0});
  desk_.view.setPainted(false);
  try {
    writePng(screens_.read(), file);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
}

void StepPlay::quit(Words& words) {
  words.end();
  screens_.close();
}

void StepPlay::pass(double seconds) {
  for (long left = std::lround(seconds * kTicksPerSecond); left > 0 && isOpen(); --left) frame();
}

void StepPlay::frame() {
  const Time before = std::exchange(now_, now_ + kFrame);
  ++frames_;
  if (!held_.empty() && frames_ == repeatFrame_) {
    send(held_.back(), KeyEvent::Kind::kRepeat);
    if (!held_.empty()) repeatFrame_ += kRepeatFrames;
  }
  const Frame frame{now_, toSeconds(now_ - before)};
  screens_.update(frame);
  screens_.draw(frame);
}

void StepPlay::hold(Key key) {
  letGo(key);
  held_.push_back(key);
  repeatFrame_ = frames_ + kRepeatDelay;
  send(key, KeyEvent::Kind::kPress);
}

void StepPlay::letGo(Key key) {
  if (std::erase(held_, key) == 0) return;
  repeatFrame_ = 0;  // as on a desktop, no other key goes on repeating
  send(key, KeyEvent::Kind::kRelease);
}

bool StepPlay::holds(Key key) const { return std::find(held_.begin(), held_.end(), key) != held_.end(); }

// A key that types a character sends it after itself, as from a keyboard; with Alt or Ctrl it does not.
void StepPlay::send(Key key, KeyEvent::Kind kind) {
  sendKey(key, kind);
  const char32_t character = characterOf(key, holds(Key::kShift));
  const bool types = character != 0 && !holds(Key::kAlt) && !holds(Key::kControl);
  if (types && kind != KeyEvent::Kind::kRelease) sendCharacter(character);
}

void StepPlay::sendKey(Key key, KeyEvent::Kind kind) {
  screens_.handle(KeyEvent{key, kind, holds(Key::kAlt), holds(Key::kControl), holds(Key::kShift)});
}

void StepPlay::sendCharacter(char32_t character) {
  KeyEvent event;
  event.kind = KeyEvent::Kind::kCharacter;
  event.character = character;
  screens_.handle(event);
}

void StepPlay::send(PointerEvent::Kind kind) {
  pointer_.kind = kind;
  pointer_.alt = holds(Key::kAlt);
  pointer_.shift = holds(Key::kShift);
  screens_.handle(pointer_);
}

}  // namespace platon
