#include "client/editor/editor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "client/editor/picking.h"
#include "client/ui/solid_text.h"
#include "levels/reach/upright_faces.h"

namespace platon {
namespace {

constexpr std::size_t kLongestError = 150;

std::string placeText(const FacePlace& at) {
  return "face " + std::to_string(at.face) + " · " + coordinateText(std::round(at.place.x)) + ", " +
         coordinateText(std::round(at.place.y));
}

std::string firstError(std::string_view file, const std::vector<Diagnostic>& found) {
  const auto error = std::find_if(found.begin(), found.end(), [](const Diagnostic& each) { return each.error; });
  return error == found.end() ? std::string() : format(file, *error);
}

}  // namespace

Editor::Editor(std::string file, EditedLevel level)
    : file_(std::move(file)), level_(std::move(level)), tools_(level_), menu_(level_) {
  const Marker& start = level_.stage()->start;
  view_.showAll(mesh(), mesh().pose(start.face, start.place, start.angle));
}

void Editor::resize(std::uint32_t w, std::uint32_t h, double uiScale) {
  if (w == 0 || h == 0) return;
  view_.resize(w, h);
  if (play_) play_->resize(w, h);
  menu_.resize(w, h, uiScale);
}

void Editor::handle(const PointerEvent& event) {
  using Kind = PointerEvent::Kind;
  if (menu_.isOpen()) {
    view_.look(event);
    return menu_.handle(event);
  }
  view_.handle(event, mesh(), !play_);
  const Camera seen = camera();
  tools_.move(event, seen);
  if (event.button != PointerEvent::Button::kLeft) return;
  bool edited = false;
  if (event.kind == Kind::kPress && tools_.pointer()) {
    edited = tools_.press(event, seen);
    if (tools_.tool() == EditTool::kPlay) placeBall();
  }
  if (event.kind == Kind::kRelease) edited = tools_.release();
  if (edited) message_.clear();
}

void Editor::handle(const KeyEvent& event) {
  if (menu_.isOpen()) {
    if (play_ && event.kind == KeyEvent::Kind::kRelease) play_->handle(event, true);
    return menu_.handle(event);
  }
  if (event.kind == KeyEvent::Kind::kCharacter) return;
  if (event.key == Key::kF11 && event.kind == KeyEvent::Kind::kPress) fullscreen_ = !fullscreen_;
  if (event.key == Key::kF1 && event.kind == KeyEvent::Kind::kPress) help_ = !help_;
  if (play_) return handleInPlay(event);
  if (event.kind == KeyEvent::Kind::kRelease || view_.handle(event, mesh())) return;
  if (event.ctrl) return handleCommand(event);
  if (event.kind == KeyEvent::Kind::kPress) handleEdit(event.key, event.shift);
}

void Editor::handleInPlay(const KeyEvent& event) {
  const bool isCommand = event.ctrl && event.kind != KeyEvent::Kind::kRelease;
  if (event.key == Key::kEscape && event.kind == KeyEvent::Kind::kPress) {
    play_.reset();
  } else if (!isCommand) {
    play_->handle(event, false);
  }
}

void Editor::handleCommand(const KeyEvent& event) {
  if (event.key == Key::kS) menu_.askToSave();
  if (event.key == Key::kY || event.key == Key::kZ) undo(event.key == Key::kZ && !event.shift);
}

void Editor::undo(bool back) {
  const std::shared_ptr<const Level> before = level_.document().level();
  const bool done = back ? level_.undo() : level_.redo();
  message_ = done ? "" : back ? "nothing to undo" : "nothing to redo";
  showOther(before);
}

void Editor::handleEdit(Key key, bool shift) {
  const bool leaves = key == Key::kEscape && !tools_.isHolding();
  if (tools_.handle(key, shift)) message_.clear();
  if (leaves) askToLeave();
  if (key == Key::kC && tools_.pointer()) view_.centre(mesh().pose(tools_.pointer()->face, {0, 0}, 0));
  if (key == Key::kH) {
    showReached_ = !showReached_;
    setReport(std::move(report_));
  }
}

void Editor::markSaved() {
  level_.markSaved();
  message_ = level_.document().valid() ? "saved" : "saved, but it cannot be played until its error is corrected";
  menu_.endSave(true);
}

void Editor::failSave(const std::string& fault) {
  message_ = "not saved: " + fault;
  menu_.endSave(false);
}

void Editor::reload(std::string_view text) {
  const std::shared_ptr<const Level> before = level_.document().level();
  level_.reload(text);
  showOther(before);
  message_ = "another program has changed the file: the new text is shown";
}

// Places that are marked for one solid may not be on another one.
void Editor::showOther(const std::shared_ptr<const Level>& before) {
  tools_.letGo();
  const Level& now = *level_.document().level();
  if (now.solid != before->solid || now.faceSize != before->faceSize) below_.reset();
}

const std::shared_ptr<const Level>& Editor::analysed() const {
  return play_ ? play_->level() : level_.document().level();
}

void Editor::setReport(LevelReport report) {
  report_ = std::move(report);
  // Until more is known, the marks of the level before the last edit stay: they would only flicker.
  const bool known = report_.reached || report_.way != LevelReport::Way::kSearching;
  if (known) below_ = marksBelow(report_, showReached_);
}

void Editor::advance(double seconds) {
  if (play_) play_->advance(seconds, menu_.isOpen());
}

Camera Editor::camera() const { return play_ ? play_->camera() : view_.camera(mesh()); }

Scene Editor::scene() const {
  if (play_) {
    Scene scene = play_->scene();
    scene.marksBelow = below_;
    return scene;
  }
  SceneSource source;
  source.stage = level_.stage();
  source.game = &level_.idle();
  Scene scene = makeScene(source);
  scene.marksBelow = below_;
  scene.marksAbove = tools_.marks(camera());
  return scene;
}

EditorStatus Editor::status() const {
  const Level& level = *level_.document().level();
  EditorStatus status;
  status.file = file_;
  status.title = level.title.empty() ? textOf(level.solid) : level.title;
  status.unsaved = level_.unsaved();
  status.tool = tools_.tool();
  status.word = tools_.word();
  status.grid = tools_.grid();
  if (tools_.pointer()) status.place = placeText(*tools_.pointer());
  status.message = message_;
  status.error = firstError(file_, level_.document().diagnostics());
  if (status.error.size() > kLongestError) status.error = status.error.substr(0, kLongestError) + "…";
  status.playing = play_.has_value();
  status.arrived = play_ && play_->game().player(0).arrived != 0;
  status.help = help_;
  status.report = report_;
  return status;
}

// Of the ups that a player can have on the face, the one nearest to that of the picture; degrees.
int Editor::upOfBall(int face) const {
  const double wanted = upOfPicture(mesh(), face, camera());
  const auto distance = [&](const UprightFace& upright) {
    return std::abs(std::remainder(upright.up.centidegrees() / 100.0 - wanted, 360.0));
  };
  const UprightFaces faces(*level_.document().level());
  const UprightFace* nearest = nullptr;
  for (const UprightFace& upright : faces.all()) {
    if (static_cast<int>(upright.face) != face) continue;
    if (nearest == nullptr || distance(upright) < distance(*nearest)) nearest = &upright;
  }
  return nearest->up.centidegrees() / 100;
}

void Editor::placeBall() {
  const FacePlace place = *tools_.pointer();
  LevelDocument document = level_.document();
  document.setStart(place, upOfBall(place.face));
  document.check();
  if (!document.valid()) {
    message_ = "the ball does not fit here: " + document.diagnostics().front().message;
    return;
  }
  const Camera seen = camera();
  play_.emplace(document.level(), seen);
  message_.clear();
}

}  // namespace platon
