#include "client/menu/pages/host_page.h"

#include <algorithm>
#include <cmath>

namespace platon {
namespace {

constexpr double kMaxHosted = 64;
constexpr const char* kDefaultPort = "7777";

MenuItem levelItem(HostForm& form, std::span<const LevelEntry> levels) {
  MenuItem item{MenuItem::Kind::kChoice, "First level", levels.empty() ? "" : levels[form.level].title};
  item.step = [&form, levels](int direction) {
    if (levels.empty()) return;
    const std::size_t count = levels.size();
    form.level = (form.level + count + static_cast<std::size_t>(direction)) % count;
  };
  return item;
}

MenuItem rotationItem(HostForm& form) {
  MenuItem item{MenuItem::Kind::kChoice, "Then", form.onlyLevel ? "the same level" : "the next levels"};
  item.flips = true;
  item.step = [&form](int) { form.onlyLevel = !form.onlyLevel; };
  return item;
}

MenuItem playersItem(HostForm& form) {
  MenuItem item{MenuItem::Kind::kSlider, "Player limit", std::to_string(std::lround(form.players)),
                (form.players - 1) / (kMaxHosted - 1)};
  item.step = [&form](int direction) { form.players = std::clamp(form.players + direction, 1.0, kMaxHosted); };
  item.set = [&form](double part) { form.players = std::round(1 + part * (kMaxHosted - 1)); };
  return item;
}

MenuItem fieldItem(const char* name, TextField& field) {
  MenuItem item{MenuItem::Kind::kText, name};
  item.field = &field;
  return item;
}

}  // namespace

HostForm::HostForm() { port.setText(kDefaultPort); }

MenuPage hostPage(HostForm& form, std::span<const LevelEntry> levels, const std::function<void()>& host) {
  MenuPage page{"Host a game"};
  page.place = MenuPage::Place::kLeft;
  page.warning = !form.fault.empty();
  page.notes.push_back(form.fault.empty() ? "Others join at your address, on the UDP port below." : form.fault);
  page.items = {levelItem(form, levels),
                rotationItem(form),
                playersItem(form),
                fieldItem("Port", form.port),
                fieldItem("Password, if any", form.password),
                {.name = "Start", .choose = host}};
  return page;
}

}  // namespace platon
