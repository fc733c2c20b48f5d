#include "client/play/editor_screen.h"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "client/editor/level_document.h"
#include "client/ui/overlay.h"
#include "protocol/program_error.h"

namespace platon {

namespace {

// That of the file, or a new one. Throws ProgramError if so much of its text is wrong that nothing can be shown.
EditedLevel levelOf(EditFile& file, SolidKind solid) {
  if (!file.exists()) return {newLevelText(solid, titleOf(file.path().filename().string())), false};
  EditedLevel level(file.load(), true);
  if (level.document().level()) return level;
  std::string messages;
  for (const Diagnostic& diagnostic : level.document().diagnostics())
    messages += (messages.empty() ? "" : "\n") + format(file.path().string(), diagnostic);
  throw ProgramError(ProgramError::kInvalid, messages);
}

}  // namespace

EditSession::EditSession(const std::string& file, SolidKind solid)
    : file_(file), editor_(file_.path().filename().string(), levelOf(file_, solid)) {}

bool EditSession::analyse() {
  if (analysed_ != editor_.analysed()) {
    analysed_ = editor_.analysed();
    analysis_.start(analysed_);
  }
  std::optional<LevelReport> report = analysis_.take();
  if (report) editor_.setReport(std::move(*report));
  return editor_.status().report.finished;
}

void EditSession::save() {
  takeFileChange(file_.takeChange());
  if (std::exchange(conflicts_, false)) {
    return editor_.failSave("another program has changed the file; save again to overwrite it");
  }
  const std::optional<std::string> fault = file_.save(editor_.level().text());
  fault ? editor_.failSave(*fault) : editor_.markSaved();
}

void EditSession::takeFileChange(const std::optional<std::string>& text) {
  if (!text) return;
  conflicts_ = editor_.level().unsaved() || !loadLevel(*text).level;
  if (!conflicts_) return editor_.reload(*text);
  editor_.markUnsaved();
  editor_.say("another program has changed the file");
}

EditorPicture::EditorPicture(const Settings& settings)
    : settings_(settings), renderer_(kPictureWidth, kPictureHeight, font_) {
  renderer_.setFaceNumbers(true);  // levels name faces by their numbers
}

void EditorPicture::draw(const Editor& editor) {
  const Camera camera = editor.camera();
  const float scale = textScale(settings_.uiScale, camera.height());
  const glm::vec2 screen(Overlay::widthFor(camera.width(), camera.height()), Overlay::kHeight);
  const Overlay panel = makeEditorPanel(editor.status(), font_, screen / scale);
  std::array overlays{scaledBy(panel, scale), editor.menuOverlay()};
  const PictureStyle style = styleOf(settings_);
  if (style.highContrast) std::for_each(overlays.begin(), overlays.end(), raiseContrast);
  renderer_.draw(editor.scene(), camera, overlays, style);
}

EditorScreen::EditorScreen(EditSession& session, Window& window, const Settings& settings, std::string screenshot)
    : session_(&session),
      window_(&window),
      settings_(settings),
      picture_(settings),
      screenshot_(std::move(screenshot)) {
  picture_.setQuality(settings.quality.quality());
  session.editor().setFullscreen(settings.fullscreen);
  fit();
}

void EditorScreen::fit() {
  picture_.resize(window_->pixelWidth(), window_->pixelHeight());
  session_->editor().resize(window_->pixelWidth(), window_->pixelHeight(), settings_.uiScale);
}

Next EditorScreen::handle(const WindowEvent& event) {
  Editor& editor = session_->editor();
  if (const auto* const key = std::get_if<KeyEvent>(&event)) editor.handle(*key);
  if (const auto* const pointer = std::get_if<PointerEvent>(&event)) editor.handle(*pointer);
  if (std::holds_alternative<CloseAsked>(event)) editor.askToLeave();
  if (editor.takeSave()) session_->save();
  if (editor.leaving()) return Close();
  return Stay();
}

Next EditorScreen::update(const Frame& frame) {
  fit();
  window_->setFullscreen(editor().fullscreen());
  session_->editor().advance(frame.seconds);
  session_->analyse();
  session_->followFile(frame.now);
  showTitle();
  return Stay();
}

void EditorScreen::showTitle() {
  const EditorStatus status = editor().status();
  const std::string title = status.file + (status.unsaved ? " *" : "") + " – Platon";
  if (title != title_) window_->setTitle(title);
  title_ = title;
}

void EditorScreen::draw(const Frame& /*frame*/) {
  picture_.draw(editor());
  if (window_->onScreen()) picture_.present();
}

void EditorScreen::leave() {
  window_->setTitle(kWindowTitle);
  if (screenshot_.empty()) return;
  picture_.draw(editor());
  writeScreenshot(picture_.read(), screenshot_);
}

}  // namespace platon
