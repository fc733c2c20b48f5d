#include "client/menu/pages/levels_page.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "client/menu/menu_layout.h"
#include "client/scene/scene.h"
#include "client/scene/stage_model.h"
#include "client/ui/overlay.h"
#include "platon/game/level.h"

namespace platon::levels_page_test {
namespace {

const std::vector<LevelEntry> kLevels{
    {"One", "CUBE", 1, 741}, {"Two", "CUBE", 2, {}}, {"Three", "TETRAHEDRON", 2, 300}, {"Four", "CUBE"}};

TEST(LevelsPage, EachSolidHasAHeadingAndLevelsForSeveralPlayersStandBelow) {
  const MenuPage page = levelsPage(kLevels, nullptr);
  std::vector<std::string> names;
  for (const MenuItem& item : page.items) names.push_back(item.name);
  EXPECT_EQ(names, (std::vector<std::string>{"CUBE", "One", "Four", "For 2 players", "Two", "Three"}));
}

TEST(LevelsPage, ShowsBestTimesWhereThereAreSomeAndTheSolidBelow) {
  const MenuPage page = levelsPage(kLevels, nullptr);
  EXPECT_EQ(page.items[1].value, "★ 12.35 s");
  EXPECT_EQ(page.items[2].value, "");
  EXPECT_EQ(page.items[4].value, "CUBE");
  EXPECT_EQ(page.items[5].value, "TETRAHEDRON · ★ 5.00 s");
}

TEST(LevelsPage, AMedalHasItsStarsAndItsColour) {
  const std::vector<LevelEntry> levels{{"One", "CUBE", 1, 900, medalTimesOf(600)},
                                       {"Two", "CUBE", 1, 9000, medalTimesOf(600)},
                                       {"Three", "CUBE", 1, {}, medalTimesOf(600)}};
  const MenuPage page = levelsPage(levels, nullptr);
  EXPECT_EQ(page.items[1].value, "★★☆ 15.00 s");
  EXPECT_EQ(page.items[1].valueColour, colourOf(Medal::kSilver));
  EXPECT_EQ(page.items[2].value, "☆☆☆ 150.00 s");
  EXPECT_EQ(page.items[2].valueColour, colourOf(Medal::kNone));
  EXPECT_EQ(page.items[3].value, "");
}

TEST(LevelsPage, AGoalThatWasReachedWithoutATimeHasACheckMark) {
  const std::vector<LevelEntry> levels{{.title = "One", .solid = "CUBE", .reached = true},
                                       {.title = "Two", .solid = "CUBE", .bestTicks = 60, .reached = true}};
  const MenuPage page = levelsPage(levels, nullptr);
  EXPECT_EQ(page.items[1].value, "✓");
  EXPECT_EQ(page.items[2].value, "★ 1.00 s");
}

TEST(LevelsPage, ATimeOfOlderRulesSaysSoAndGivesNoMedal) {
  LevelEntry level{.title = "One", .solid = "CUBE", .medals = medalTimesOf(600), .olderTicks = 741};
  const auto valueOf = [](const LevelEntry& entry) { return levelsPage({&entry, 1}, nullptr).items[1].value; };
  EXPECT_EQ(valueOf(level), "12.35 s, older rules");
  EXPECT_FALSE(levelsPage({&level, 1}, nullptr).items[1].valueColour);
  level.reached = true;
  EXPECT_EQ(valueOf(level), "✓ 12.35 s, older rules");
  level.players = 2;
  EXPECT_EQ(valueOf(level), "CUBE · ✓ 12.35 s, older rules");
  level.bestTicks = 900;
  EXPECT_EQ(valueOf(level), "CUBE · ★★☆ 15.00 s");
}

TEST(LevelsPage, ItemsAndLevelsBelongTogether) {
  std::vector<std::size_t> chosen;
  const MenuPage page = levelsPage(kLevels, [&](std::size_t level) { chosen.push_back(level); });
  for (std::size_t level = 0; level < kLevels.size(); ++level) {
    const std::size_t item = itemOfLevel(kLevels, level);
    EXPECT_EQ(page.items[item].name, kLevels[level].title);
    EXPECT_EQ(levelOfItem(kLevels, item), level);
    page.items[item].choose();
  }
  EXPECT_EQ(chosen, (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(levelOfItem(kLevels, 3), 1U) << "a heading";
  EXPECT_EQ(levelOfItem(kLevels, 99), 2U) << "the last row";
}

// Where a point of the solid is in the picture, -1 … 1.
glm::dvec2 placeIn(const Camera& camera, glm::dvec3 point) {
  const glm::dvec4 clip = camera.viewProjection() * glm::dvec4(point, 1);
  return glm::dvec2(clip) / clip.w;
}

// A scene whose ball is here.
Scene sceneAt(const std::shared_ptr<const StageModel>& stage, const Pose& ball) {
  Scene scene;
  scene.stage = stage;
  scene.focus = ball;
  return scene;
}

std::shared_ptr<const StageModel> emptyStage(SolidKind kind) {
  std::string text = std::string(nameOf(kind)) + "\n0 0 0 0\n0 20 0\n480\n";
  for (int face = 0; face < PlatonicSolid::of(kind).faces(); ++face) text += "%\n";
  return makeStageModel(*loadLevel(text).level);
}

void forEveryBall(const std::function<void(const std::shared_ptr<const StageModel>&, const Pose&)>& check) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const auto stage = emptyStage(static_cast<SolidKind>(kind));
    for (int face = 0; face < stage->mesh.faces(); ++face) check(stage, stage->mesh.pose(face, {30, -20}, 1));
  }
}

TEST(Turntable, HasNothingToShowAtFirst) { EXPECT_FALSE(Turntable().shows()); }

TEST(Turntable, TheWholeSolidIsInThePicture) {
  forEveryBall([](const std::shared_ptr<const StageModel>& stage, const Pose& ball) {
    Turntable turntable;
    turntable.show(sceneAt(stage, ball), 0);
    for (const auto& [w, h] : {std::pair(1280U, 720U), {960U, 720U}, {720U, 720U}, {400U, 900U}, {2520U, 1080U}}) {
      const Camera camera = turntable.camera(w, h);
      for (int face = 0; face < stage->mesh.faces(); ++face) {
        for (const glm::dvec2 corner : stage->mesh.polygon()) {
          const glm::dvec2 place = placeIn(camera, stage->mesh.toWorld(face, corner));
          EXPECT_LT(std::max(std::abs(place.x), std::abs(place.y)), 1)
              << stage->mesh.faces() << ", " << w << " × " << h;
        }
      }
    }
  });
}

TEST(Turntable, InAWidePictureTheSolidIsAtTheRightAboveTheCard) {
  Turntable turntable;
  turntable.show(sceneAt(emptyStage(SolidKind::kTetrahedron), {}), 0);
  EXPECT_NEAR(placeIn(turntable.camera(1280, 720), {0, 0, 0}).x, 0.42, 1e-9);
  EXPECT_GT(placeIn(turntable.camera(1280, 720), {0, 0, 0}).y, 0.1);
  EXPECT_LT(glm::length(placeIn(turntable.camera(720, 720), {0, 0, 0})), 1e-9);
}

bool isSeen(const Turntable& turntable, const Pose& ball) {
  return glm::dot(ball.normal, turntable.camera(1280, 720).eye() - ball.position) > 0;
}

TEST(Turntable, ShowsTheBallAtOnceOnAnotherStage) {
  forEveryBall([](const std::shared_ptr<const StageModel>& stage, const Pose& ball) {
    Turntable turntable;
    turntable.show(sceneAt(stage, ball), 0);
    EXPECT_TRUE(isSeen(turntable, ball)) << stage->mesh.faces();
  });
}

TEST(Turntable, TurnsSlowlyToTheBall) {
  forEveryBall([](const std::shared_ptr<const StageModel>& stage, const Pose& ball) {
    Turntable turntable;
    turntable.show(sceneAt(stage, stage->mesh.pose(0, {0, 0}, 0)), 0);
    for (int frame = 0; frame < 600; ++frame) {
      const glm::dvec3 before = turntable.camera(1280, 720).back();
      turntable.show(sceneAt(stage, ball), 1.0 / 30);
      EXPECT_LT(glm::distance(turntable.camera(1280, 720).back(), before) * 30, 0.75);
    }
    EXPECT_TRUE(isSeen(turntable, ball)) << stage->mesh.faces();
  });
}

std::vector<std::string> textsOf(const LevelEntry& level, float width, float scale = 1) {
  const Font font;
  Overlay overlay;
  addLevelCard(overlay, level, font, width, scale);
  std::vector<std::string> texts;
  for (const Overlay::Text& text : overlay.texts) {
    texts.push_back(text.content);
    EXPECT_GT(text.place.x, width / 2);
    EXPECT_LT(text.place.x + font.width(text.content) * text.size, width);
    EXPECT_LT(text.place.y, Overlay::kHeight);
  }
  return texts;
}

bool overlap(const MenuBox& a, const MenuBox& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

TEST(LevelCard, ShowsTitlePlayersAndMedals) {
  LevelEntry level{"Half turn", "Tetrahedron · fire", 2};
  EXPECT_EQ(textsOf(level, 1280), (std::vector<std::string>{"Half turn", "Tetrahedron · fire · 2 players"}));
  level.players = 1;
  level.medals = medalTimesOf(600);
  EXPECT_EQ(textsOf(level, 1280), (std::vector<std::string>{"Half turn", "Tetrahedron · fire · 1 player", "★★★ 11.50 s",
                                                            "★★☆ 15.00 s", "★☆☆ 25.00 s"}));
}

TEST(LevelCard, StaysBesideTheMenuWithLongTexts) {
  const Font font;
  const LevelEntry level{std::string(100, 'W'), "Icosahedron · water", 64, {}, medalTimesOf(2'000'000)};
  for (const float scale : {0.75F, 1.0F, textScale(1, 360), 1.5F, 1.75F}) {
    for (float width = 960; width < 1800; width += 40) {
      SCOPED_TRACE(testing::Message() << width << " at " << scale);
      Overlay card;
      addLevelCard(card, level, font, width, scale);
      const float menu = scale * endOfLeftColumn(glm::vec2(width, Overlay::kHeight) / scale);
      std::vector<MenuBox> boxes;
      for (const Overlay::Text& text : card.texts) {
        const glm::vec2 end = text.place + glm::vec2(font.width(text.content) * text.size, 0.3F * text.size);
        boxes.push_back({text.place - glm::vec2(0, text.size), end});
      }
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_GE(boxes[i].low.x, menu) << card.texts[i].content;
        EXPECT_LE(boxes[i].high.x, width) << card.texts[i].content;
        EXPECT_LE(boxes[i].high.y, Overlay::kHeight);
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(boxes[i], boxes[j])) << card.texts[i].content;
      }
      for (const Overlay::Panel& panel : card.panels) {
        EXPECT_GE(panel.low.x, menu);
        EXPECT_LE(panel.high.x, width);
        EXPECT_LE(panel.high.y, Overlay::kHeight);
      }
    }
  }
}

TEST(LevelCard, LeavesOutWhatHasNoRoomBesideTheMenu) {
  const LevelEntry level{"Half turn", "Tetrahedron · fire", 1, {}, medalTimesOf(600)};
  EXPECT_EQ(textsOf(level, 1280, 1.5F).size(), 2U);
  EXPECT_TRUE(textsOf(level, 1280, 2).empty());
}

TEST(LevelCard, IsLeftOutWhereThereIsNoRoomBesideTheMenu) {
  EXPECT_TRUE(textsOf({"Half turn", "Tetrahedron · fire"}, Turntable::kWide * Overlay::kHeight).empty());
}

}  // namespace
}  // namespace platon::levels_page_test
