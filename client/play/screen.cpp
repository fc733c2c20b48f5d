#include "client/play/screen.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "client/gl/gl_context.h"

namespace platon {

ScreenStack::ScreenStack(std::unique_ptr<Screen> first) { screens_.push_back(std::move(first)); }

void ScreenStack::handle(const WindowEvent& event) {
  if (isOpen()) perform(screens_.back()->handle(event));
}

void ScreenStack::update(const Frame& frame) {
  if (!isOpen()) return;
  for (std::size_t i = 0; i + 1 < screens_.size(); ++i) {
    if (!screens_[i]->updateBehind(frame)) continue;
    while (screens_.size() > i + 1) pop();
    perform(screens_.back()->reveal({}));
  }
  if (isOpen()) perform(screens_.back()->update(frame));
}

void ScreenStack::draw(const Frame& frame) {
  if (isOpen()) screens_.back()->draw(frame);
}

void ScreenStack::close() {
  while (!screens_.empty()) pop();
}

void ScreenStack::pop() {
  screens_.back()->leave();
  screens_.pop_back();
}

void ScreenStack::perform(Next next) {
  if (auto* const push = std::get_if<Push>(&next)) {
    screens_.push_back(std::move(push->screen));
  } else if (auto* const replace = std::get_if<Replace>(&next)) {
    pop();
    screens_.push_back(std::move(replace->screen));
  } else if (const auto* const close = std::get_if<Close>(&next)) {
    pop();
    if (!screens_.empty()) perform(screens_.back()->reveal(close->ending));
  } else if (const auto* const quit = std::get_if<Quit>(&next)) {
    if (quit->error) throw ProgramError(*quit->error);
    quit_ = true;
  }
}

Time frameTimeOf(bool calm, double frameCap) {
  if (calm) return kCalmFrameTime;
  return frameCap < 1 ? kMinFrameTime : std::max(kMinFrameTime, Time(static_cast<Time::rep>(1e6 / frameCap)));
}

DesktopWindow openWindow(const std::string& otherwise) {
  try {
    return {kWindowTitle, static_cast<int>(kPictureWidth), static_cast<int>(kPictureHeight)};
  } catch (const NoOpenGl& error) {
    throw ProgramError(ProgramError::kFailed, error.what());
  } catch (const std::runtime_error& error) {
    throw ProgramError(ProgramError::kUsage, error.what() + ("; " + otherwise));
  }
}

void writeScreenshot(const Image& picture, const std::string& file) {
  writePng(picture, file);
  std::printf("screenshot: %s\n", file.c_str());
}

}  // namespace platon
