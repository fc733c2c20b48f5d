#include "client/menu/pages/editor_page.h"

#include "client/ui/solid_text.h"

namespace platon {
namespace {

constexpr const char* kExtension = ".level";

bool isPlain(char byte) {
  return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || (byte >= '0' && byte <= '9') || byte == '-' ||
         byte == '_';
}

MenuItem solidItem(SolidKind& solid) {
  MenuItem item{MenuItem::Kind::kChoice, "Solid", textOf(solid)};
  item.step = [&solid](int direction) {
    solid = static_cast<SolidKind>((static_cast<int>(solid) + kSolidKinds + direction) % kSolidKinds);
  };
  return item;
}

}  // namespace

std::string levelFileNameOf(const std::string& name) {
  std::string file;
  for (const char byte : name) {
    if (isPlain(byte)) file += byte;
    if (byte == ' ' && !file.empty() && file.back() != '_') file += '_';
  }
  while (file.ends_with('_')) file.pop_back();
  return file.empty() ? file : file + kExtension;
}

MenuPage editorPage(EditForm& form, const std::function<void()>& create,
                    const std::function<void(const std::string& file)>& edit) {
  MenuPage page{"Level editor"};
  page.place = MenuPage::Place::kLeft;
  page.warning = !form.fault.empty();
  page.notes.push_back(form.fault.empty() ? "Make a level of your own, or change one. They are in " + form.folder + "."
                                          : form.fault);
  MenuItem name{MenuItem::Kind::kText, "Name"};
  name.field = &form.name;
  page.items = {std::move(name), solidItem(form.solid), {.name = "Make a new level", .choose = create}};
  if (!form.files.empty()) page.items.push_back({MenuItem::Kind::kHeading, "Your levels"});
  for (const std::string& file : form.files)
    page.items.push_back({.name = file, .choose = [edit, file] { edit(file); }});
  return page;
}

}  // namespace platon
