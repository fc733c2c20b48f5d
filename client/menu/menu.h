#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "client/menu/menu_layout.h"
#include "client/menu/menu_page.h"
#include "client/menu/text_field.h"
#include "client/ui/font.h"
#include "client/ui/key.h"
#include "client/ui/overlay.h"
#include "client/ui/pointer_event.h"

namespace platon {

/// Shows pages, and moves through them by keys, gamepad and mouse. A page is made anew for each event and each picture,
/// so it always shows the present state.
class Menu {
 public:
  using PageMaker = std::function<MenuPage()>;

  /// What the menu has done, from the least to the most important.
  enum class Feedback : std::uint8_t {
    kNone,
    kMoved,  ///< the focus, or a value
    kChosen  ///< an item, or another page
  };

  /// The picture of the virtual screen has this width; one unit of the menu is `scale` of its units, at least 0.5.
  void resize(float width, float scale);
  void setClipboard(TextField::Clipboard clipboard) { clipboard_ = std::move(clipboard); }

  bool isOpen() const { return !pages_.empty(); }
  /// Shows this page instead of all others. The focus is on its first item that can have it.
  void open(PageMaker page);
  /// Shows this page; going back leads to the present one.
  void push(PageMaker page);
  /// Shows the page before; closes the menu if there is none.
  void back();
  void close();

  /// Item of the page that has the focus. The menu is open.
  std::size_t focus() const { return pages_.back().focus; }
  /// Gives the focus to an item of the page. The menu is open.
  void setFocus(std::size_t item);

  /// While the menu is closed, it only notes where the pointer is.
  void handle(const KeyEvent& event, const Font& font);
  void handle(const PointerEvent& event, const Font& font);

  /// The most important thing that the menu has done since the last call, by keys, gamepad, mouse or program.
  Feedback takeFeedback() { return std::exchange(feedback_, Feedback::kNone); }

  /// Whether only the item whose value is being changed is shown, so that the picture behind it can be judged.
  bool standsAside() const { return aside_; }
  /// Whether it stands aside for a value that can be judged only on a game that runs.
  bool showsMotion() const;
  /// The picture of the menu; empty while it is closed. `dimsPicture`: what is behind it is dimmed.
  Overlay overlay(const Font& font, bool dimsPicture) const;
  /// Where the parts of the page are, in units of the menu. The menu is open.
  MenuLayout layout(const Font& font) const;

 private:
  enum class Command { kNone, kUp, kDown, kLess, kMore, kChoose, kBack };

  struct Shown {
    PageMaker make;
    std::size_t focus = 0;
    std::size_t first = 0;  // item of the first row
  };

  static Command commandOf(const KeyEvent& event);
  MenuPage present() const;
  MenuPage make();
  MenuLayout layoutOf(const MenuPage& page, const Font& font, bool followsFocus) const;
  void note(Feedback feedback) { feedback_ = std::max(feedback_, feedback); }
  void focusOn(std::size_t item);
  void choose(const MenuItem& item);
  void moveFocus(const MenuPage& page, int direction);
  void perform(Command command, const MenuPage& page);
  void change(const MenuPage& page, int direction);
  void leave(const MenuPage& page);
  bool rests(glm::vec2 place);
  void point(const MenuPage& page, glm::vec2 place, const Font& font);
  void press(const MenuPage& page, glm::vec2 place, const Font& font);
  void click(const MenuPage& page, const MenuRow& row, glm::vec2 place);
  void drag(const MenuPage& page, const MenuRow& row, glm::vec2 place);
  void scroll(const MenuPage& page, const PointerEvent& event, glm::vec2 place, const Font& font);

  std::vector<Shown> pages_;  // the last one is shown
  TextField::Clipboard clipboard_;
  glm::vec2 screen_{1280, Overlay::kHeight};  // in units of the menu
  float width_ = 1280;
  float scale_ = 1;
  std::optional<glm::vec2> pointer_;  // where it is, as far as known
  std::optional<glm::vec2> rest_;     // where it has been since the last key or page; nothing: it has moved since
  bool dragging_ = false;             // the slider that has the focus
  bool aside_ = false;
  Feedback feedback_ = Feedback::kNone;
};

}  // namespace platon
