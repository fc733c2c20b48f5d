#include "client/menu/pages/editor_page.h"

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace platon::editor_page_test {
namespace {

TEST(EditorPage, AFileNameHasLettersDigitsAndUnderscoresForSpaces) {
  EXPECT_EQ(levelFileNameOf("My first room"), "My_first_room.level");
  EXPECT_EQ(levelFileNameOf("  two  spaces "), "two_spaces.level");
  EXPECT_EQ(levelFileNameOf("07-a_b"), "07-a_b.level");
  EXPECT_EQ(levelFileNameOf("../../etc/passwd"), "etcpasswd.level");
  EXPECT_EQ(levelFileNameOf("Höhle"), "Hhle.level");
  for (const char* const nothing : {"", "   ", "../", "Лев", "/"}) EXPECT_EQ(levelFileNameOf(nothing), "") << nothing;
}

TEST(EditorPage, MakesANewLevelOrEditsOneOfThePlayer) {
  EditForm form;
  form.folder = "levels of Ann";
  form.files = {"a.level", "b.level"};
  std::string called;
  const MenuPage page = editorPage(
      form, [&called] { called += "new "; }, [&called](const std::string& file) { called += file + " "; });
  EXPECT_NE(page.notes.front().find("levels of Ann"), std::string::npos);
  EXPECT_EQ(page.items.front().field, &form.name);
  for (const MenuItem& item : page.items) {
    if (item.choose) item.choose();
  }
  EXPECT_EQ(called, "new a.level b.level ");
}

TEST(EditorPage, TheSolidGoesRoundThroughAllFive) {
  EditForm form;
  std::vector<std::string> names;
  for (int i = 0; i < kSolidKinds; ++i) {
    const MenuItem solid = editorPage(form, {}, {}).items[1];
    names.push_back(solid.value);
    solid.step(1);
  }
  EXPECT_EQ(form.solid, SolidKind::kHexahedron) << "round";
  EXPECT_EQ(names.front(), "Cube · earth");
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), std::size_t{kSolidKinds});
  editorPage(form, {}, {}).items[1].step(-1);
  EXPECT_EQ(form.solid, SolidKind::kTetrahedron);
}

TEST(EditorPage, AFaultTakesThePlaceOfTheNote) {
  EditForm form;
  form.fault = "Enter a name.";
  const MenuPage page = editorPage(form, {}, {});
  EXPECT_TRUE(page.warning);
  EXPECT_EQ(page.notes, std::vector<std::string>{"Enter a name."});
}

}  // namespace
}  // namespace platon::editor_page_test
