#include "client/editor/editor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "client/editor/face_picker.h"
#include "client/ui/solid_text.h"
#include "client/ui/text_scale.h"
#include "levels/reach/upright_faces.h"

namespace platon {
namespace {

constexpr double kTickSeconds = 1.0 / kTicksPerSecond;
constexpr double kMaxSeconds = 0.1;  // of play in one picture
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

Editor::Editor(std::string file, EditedLevel level) : file_(std::move(file)), level_(std::move(level)) {
  showLevel();
  const Marker& start = stage_->start;
  view_.showAll(mesh(), mesh().pose(start.face, start.place, start.angle));
}

void Editor::resize(std::uint32_t w, std::uint32_t h, double uiScale) {
  if (w == 0 || h == 0) return;
  width_ = w;
  height_ = h;
  playCamera_.resize(w, h);
  menu_.resize(Overlay::widthFor(w, h), textScale(uiScale, h));
}

void Editor::markSaved() {
  level_.markSaved();
  message_ = level_.document().valid() ? "saved" : "saved, but nobody can play it before its error is corrected";
  if (leaveWhenSaved_) leaving_ = true;
}

void Editor::failSave(const std::string& fault) {
  message_ = "not saved: " + fault;
  leaveWhenSaved_ = false;
}

void Editor::reload(std::string_view text) {
  level_.reload(text);
  selected_.reset();
  showLevel();
  message_ = "another program has changed the file: its text is shown";
}

void Editor::edit(const std::function<void(LevelDocument&)>& change) {
  level_.edit(change);
  message_.clear();
  showLevel();
}

// The indices of segments change with the text.
void Editor::showLevel() {
  if (selected_ && *selected_ >= segments().size()) selected_.reset();
  hovered_.reset();
  gesture_.reset();
  if (shown_ == level_.document().level()) return;
  const SolidKind before = shown_ ? shown_->solid : SolidKind::kHexahedron;
  const std::int32_t size = shown_ ? shown_->faceSize : 0;
  shown_ = level_.document().level();
  stage_ = makeStageModel(*shown_);
  idle_.emplace(shown_);
  if (shown_->solid != before || shown_->faceSize != size) below_.reset();
  if (pointer_ && pointer_->face >= mesh().faces()) pointer_.reset();
}

const std::shared_ptr<const Level>& Editor::analysed() const { return play_ ? play_->level() : shown_; }

void Editor::setReport(LevelReport report) {
  report_ = std::move(report);
  // Until more is known, the marks of the level before the last edit stay: they would only flicker.
  const bool known = report_.reached || report_.way != LevelReport::Way::kSearching;
  if (known) below_ = marksBelow(report_, showReached_);
}

void Editor::advance(double seconds) {
  if (!play_) return;
  untilTick_ += std::min(seconds, kMaxSeconds);
  for (; untilTick_ >= kTickSeconds; untilTick_ -= kTickSeconds) {
    const HeldKeys held = mapper_.takeHeld();
    play_->tick(menu_.isOpen() ? Input() : steering_.input(held, 0, ControlFrame::kPlayer));
  }
  const Scene now = play_->scene(untilTick_ / kTickSeconds);
  playCamera_.lerp(now.focus, now.stage->mesh, seconds);
}

Camera Editor::camera() const { return play_ ? playCamera_ : view_.camera(mesh(), width_, height_); }

Scene Editor::scene() const {
  if (play_) {
    Scene scene = play_->scene(untilTick_ / kTickSeconds);
    scene.marksBelow = below_;
    return scene;
  }
  SceneSource source;
  source.stage = stage_;
  source.game = &*idle_;
  Scene scene = makeScene(source);
  scene.marksBelow = below_;
  EditorMarks marks;
  if (hovered_ && !gesture_) marks.hovered = segments()[hovered_->segment];
  if (selected_ && !gesture_) marks.selected = segments()[*selected_];
  if (gesture_) marks.drawn = gesture_->pieces();
  marks.faulty = level_.faulty();
  const double scale = pointer_ ? screenScale(mesh(), camera(), *pointer_) : 1;
  const bool aims = tool_ == EditTool::kDraw || tool_ == EditTool::kStart || tool_ == EditTool::kGoal;
  if (pointer_ && aims)
    marks.pointer = FacePlace{pointer_->face, snapped(mesh(), segments(), *pointer_, snapOptions(free_))};
  scene.marksAbove = marksAbove(marks, scale > 0.01 ? 2 / scale : 4);
  return scene;
}

EditorStatus Editor::status() const {
  EditorStatus status;
  status.file = file_;
  status.title = shown_->title.empty() ? textOf(shown_->solid) : shown_->title;
  status.unsaved = level_.unsaved();
  status.tool = tool_;
  status.word = selected_ ? segments()[*selected_].word : word_;
  status.grid = kGrids[grid_];
  if (pointer_) status.place = placeText(*pointer_);
  status.message = message_;
  status.error = firstError(file_, level_.document().diagnostics());
  if (status.error.size() > kLongestError) status.error = status.error.substr(0, kLongestError) + "…";
  status.playing = play_.has_value();
  status.arrived = play_ && play_->game().player(0).arrived != 0;
  status.help = help_;
  status.report = report_;
  return status;
}

SnapOptions Editor::snapOptions(bool free) const {
  // Start and goal belong between the segments, not onto them.
  if (tool_ == EditTool::kStart || tool_ == EditTool::kGoal) return {kGrids[grid_], 0, free};
  const double scale = pointer_ ? screenScale(mesh(), camera(), *pointer_) : 1;
  return {kGrids[grid_], kReach / std::max(scale, 0.05), free};
}

// Half the angle of an edge, in which the up of the start is turned on triangles and pentagons; degrees.
int Editor::turnOfStart() const {
  const int edges = mesh().solid().edgesPerFace();
  return edges == 3 ? 60 : edges == 4 ? 90 : 36;
}

void Editor::centre() {
  if (pointer_) view_.centre(mesh().pose(pointer_->face, {0, 0}, 0));
}

// Degrees from the face's +y to the up of the picture.
double Editor::upOfPicture(int face) const {
  const glm::dvec2 up(glm::inverse(mesh().faceToWorld(face)) * glm::dvec4(camera().up(), 0));
  return std::atan2(-up.x, up.y) * 180 / std::numbers::pi;
}

// The up of the start, degrees: nearly that of the picture.
int Editor::upOfStart(int face) const {
  const int turn = turnOfStart();
  return (static_cast<int>(std::lround(upOfPicture(face) / turn)) * turn + 360) % 360;
}

// Of the ups that a player can have on the face, the one nearest to that of the picture; degrees.
int Editor::upOfBall(int face) const {
  const double wanted = upOfPicture(face);
  const auto distance = [&](const UprightFace& upright) {
    return std::abs(std::remainder(upright.up.centidegrees() / 100.0 - wanted, 360.0));
  };
  const UprightFaces faces(*shown_);
  const UprightFace* nearest = nullptr;
  for (const UprightFace& upright : faces.all()) {
    if (static_cast<int>(upright.face) != face) continue;
    if (nearest == nullptr || distance(upright) < distance(*nearest)) nearest = &upright;
  }
  return nearest->up.centidegrees() / 100;
}

void Editor::placeBall() {
  LevelDocument document = level_.document();
  document.setStart(*pointer_, upOfBall(pointer_->face));
  document.check();
  if (!document.valid()) {
    message_ = "the ball does not fit here: " + document.diagnostics().front().message;
    return;
  }
  if (!play_) playCamera_ = camera();
  play_.emplace(document.level());
  untilTick_ = 0;
  mapper_ = InputMapper();
  message_.clear();
}

}  // namespace platon
