#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/menu/menu.h"
#include "client/menu/pages/replays_page.h"
#include "client/replay/run_list.h"
#include "platon/game/level.h"

namespace platon {

/// The pages about recordings: the list of all, and what can be done with one.
class ReplayPages {
 public:
  using File = std::filesystem::path;
  struct Calls {
    std::function<void(const File&)> watch;
    /// Returns why there can be no race, as the end of a sentence, or an empty text.
    std::function<std::string(const std::shared_ptr<const Level>&, const File&)> race;
    std::function<std::optional<MedalTimes>(const std::shared_ptr<const Level>&)> medalsOf;
  };

  /// `menu` outlives the pages. `runs` and `ghosts` are folders; an empty path has no recordings.
  ReplayPages(Menu& menu, File runs, File ghosts, Calls calls);

  /// Shows the list above the present page.
  void showList();
  /// Shows the list above the present page, and above it the page of this recording, which may be anywhere.
  void showRun(const File& file);
  /// The player looks at other pages now.
  void leave() { chosen_.reset(), inList_ = false; }

  /// The level of the recording that the player looks at, as soon as it has been read; null if there is none.
  std::shared_ptr<const Level> shownLevel() const;

 private:
  void load();
  void refresh();
  ReplayEntry entryOf(const ListedRun& run) const;
  void poll();
  const File& fileOf(std::size_t index) const { return list_.runs()[index].file; }
  MenuPage listPage();
  MenuPage pageOf(std::size_t index);
  void choose(std::size_t index);
  bool canRace(std::size_t index) const;
  void race(std::size_t index);
  bool canKeep(std::size_t index) const;
  void keep(std::size_t index);
  std::shared_ptr<const Level> levelOf(std::size_t index) const { return list_.runs()[index].level; }

  Menu* menu_;
  RunList list_;
  File ghosts_;
  Calls calls_;
  std::vector<ReplayEntry> entries_;  // of list_
  bool inList_ = false;
  std::optional<std::size_t> chosen_;  // of list_, whose page is shown
  std::string fault_;                  // of the last copy or race
};

}  // namespace platon
