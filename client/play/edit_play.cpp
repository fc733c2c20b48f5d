#include "client/play/edit_play.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "client/editor/new_level.h"
#include "client/files/settings_file.h"
#include "client/files/user_folders.h"
#include "client/gl/image.h"
#include "client/play/play_window.h"
#include "client/ui/high_contrast_overlay.h"
#include "client/ui/text_scale.h"
#include "protocol/program_error.h"

namespace platon {

namespace {

constexpr double kOffscreenSeconds = 10;
constexpr Moment kAnalysisInterval = std::chrono::milliseconds(10);

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

std::unique_ptr<Window> openEditWindow(bool offscreen) {
  if (offscreen) return nullptr;
  return std::unique_ptr<Window>(
      new Window(openWindow("to draw the editor without one, use --offscreen --screenshot")));
}

std::optional<Offscreen> openOffscreen(bool offscreen) {
  if (!offscreen) return std::nullopt;
  return std::optional<Offscreen>(std::in_place);
}

}  // namespace

EditPlay::EditPlay(const ClientOptions& options, const Clock& clock)
    : options_(options),
      clock_(clock),
      file_(options.edit),
      editor_(file_.path().filename().string(), levelOf(file_, options.solid)),
      window_(openEditWindow(options.offscreen)),
      offscreen_(openOffscreen(options.offscreen)),
      renderer_(kPictureWidth, kPictureHeight, font_),
      startedAt_(clock_.now()) {
  if (!window_) return;
  settings_ = SettingsFile(configFolder()).load();
  renderer_.setQuality(settings_.quality.quality());
}

void EditPlay::run(const std::function<bool()>& stopRequested) {
  window_ ? runWindow(stopRequested) : runOffscreen(stopRequested);
  if (!options_.screenshot.empty()) takeScreenshot();
}

void EditPlay::runWindow(const std::function<bool()>& stopRequested) {
  Moment before = clock_.now();
  for (Moment now = before; timeIsLeft(now) && !editor_.leaving() && !stopRequested(); now = clock_.now()) {
    handleEvents();
    editor_.advance(toSeconds(now - before));
    before = now;
    updateAnalysis();
    takeFileChange(file_.pollChange(FileWatch::Time(now)));
    showTitle();
    if (!window_->minimised()) show();
    clock_.sleepUntil(now + frameTimeOf(!window_->focused(), settings_.frameCap));
  }
}

// Waits for the analysis, at most for the time of the options.
void EditPlay::runOffscreen(const std::function<bool()>& stopRequested) {
  const double seconds = options_.seconds.value_or(kOffscreenSeconds);
  for (Moment now = clock_.now(); toSeconds(now - startedAt_) < seconds && !stopRequested(); now = clock_.now()) {
    updateAnalysis();
    if (editor_.status().report.finished) break;
    clock_.sleepUntil(now + kAnalysisInterval);
  }
}

bool EditPlay::timeIsLeft(Moment now) const {
  return !options_.seconds || toSeconds(now - startedAt_) < *options_.seconds;
}

void EditPlay::handleEvents() {
  window_->poll();
  renderer_.resize(window_->pixelWidth(), window_->pixelHeight());
  editor_.resize(window_->pixelWidth(), window_->pixelHeight(), settings_.uiScale);
  const auto handle = [this](const auto& event) { editor_.handle(event); };
  for (const WindowEvent& event : window_->takeEvents()) std::visit(handle, event);
  window_->setFullscreen(editor_.fullscreen());
  if (window_->closing()) {
    window_->stayOpen();
    editor_.askToLeave();
  }
  if (editor_.takeSave()) save();
}

void EditPlay::updateAnalysis() {
  if (analysed_ != editor_.analysed()) {
    analysed_ = editor_.analysed();
    analysis_.start(analysed_);
  }
  std::optional<LevelReport> report = analysis_.take();
  if (report) editor_.setReport(std::move(*report));
}

// What another program has written meanwhile is replaced only when the user asks again.
void EditPlay::save() {
  takeFileChange(file_.takeChange());
  if (std::exchange(conflicts_, false)) {
    return editor_.failSave("another program has changed the file; save again to replace its text");
  }
  const std::optional<std::string> fault = file_.save(editor_.level().text());
  fault ? editor_.failSave(*fault) : editor_.markSaved();
}

void EditPlay::takeFileChange(const std::optional<std::string>& text) {
  if (!text) return;
  conflicts_ = editor_.level().unsaved() || !loadLevel(*text).level;
  if (!conflicts_) return editor_.reload(*text);
  editor_.markUnsaved();
  editor_.say("another program has changed the file");
}

void EditPlay::showTitle() {
  const EditorStatus status = editor_.status();
  const std::string title = status.file + (status.unsaved ? " *" : "") + " – Platon";
  if (title != title_) window_->setTitle(title);
  title_ = title;
}

void EditPlay::draw() {
  const Camera camera = editor_.camera();
  const float scale = textScale(settings_.uiScale, camera.height());
  const glm::vec2 screen(Overlay::widthFor(camera.width(), camera.height()), Overlay::kHeight);
  const Overlay panel = makeEditorPanel(editor_.status(), font_, screen / scale);
  std::array overlays{scaledBy(panel, scale), editor_.menuOverlay()};
  const PictureStyle style = styleOf(settings_);
  if (style.highContrast) std::for_each(overlays.begin(), overlays.end(), raiseContrast);
  renderer_.setFaceNumbers(true);  // levels name faces by their numbers
  renderer_.draw(editor_.scene(), camera, overlays, style);
}

void EditPlay::show() {
  draw();
  renderer_.present();
  window_->show();
}

void EditPlay::takeScreenshot() {
  draw();
  writePng(renderer_.read(), options_.screenshot);
  std::printf("screenshot: %s\n", options_.screenshot.c_str());
}

}  // namespace platon
