#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "client/editor/editor.h"
#include "client/ui/overlay.h"

namespace platon {

/// An editor of a cube with a floor on face 0, and hands that use its mouse and keys.
class TestEditor : public Editor {
 public:
  static std::string levelText(const std::string& segments = "") {
    return "# title: Test\nHEXAHEDRON\n0 -100 -188 0\n0 100 -180\n480\n%\n-200 -200 200 -200  # floor\n" + segments +
           "%\n%\n%\n%\n%\n";
  }

  explicit TestEditor(const std::string& segments = "") : Editor("test.level", EditedLevel(levelText(segments), true)) {
    // The solid is seen from the front.
    move({0, {0, 0}});
    key(Key::kC);
  }

  void key(Key key, bool ctrl = false, bool shift = false) {
    handle(KeyEvent{key, KeyEvent::Kind::kPress, false, ctrl, shift});
    handle(KeyEvent{key, KeyEvent::Kind::kRelease, false, ctrl, shift});
  }
  /// Moves the pointer to where the place is drawn.
  void move(const FacePlace& at, bool alt = false, bool shift = false) {
    send(PointerEvent::Kind::kMove, screenOf(at), alt, shift);
  }
  void press(const FacePlace& at, bool alt = false) {
    move(at, alt);
    send(PointerEvent::Kind::kPress, screenOf(at), alt, false);
  }
  void release(const FacePlace& at, bool alt = false, bool shift = false) {
    move(at, alt, shift);
    send(PointerEvent::Kind::kRelease, screenOf(at), alt, shift);
  }
  void click(const FacePlace& at) {
    press(at);
    release(at);
  }
  void drag(const FacePlace& from, const FacePlace& to, bool alt = false, bool shift = false) {
    press(from, alt);
    release(to, alt, shift);
  }

  const std::vector<EditedSegment>& all() const { return level().document().segments(); }

 private:
  glm::dvec2 screenOf(const FacePlace& at) const {
    const Camera seen = camera();
    const glm::dvec4 clip = seen.viewProjection() * glm::dvec4(scene().stage->mesh.toWorld(at.face, at.place), 1);
    return {(clip.x / clip.w + 1) / 2 * 1280, (1 - clip.y / clip.w) / 2 * Overlay::kHeight};
  }
  void send(PointerEvent::Kind kind, glm::dvec2 place, bool alt, bool shift) {
    PointerEvent event;
    event.kind = kind;
    event.place = place;
    event.alt = alt;
    event.shift = shift;
    handle(event);
  }
};

}  // namespace platon
