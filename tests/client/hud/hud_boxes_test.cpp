// No parts of the display overlap, whatever it shows and however small the picture is.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "client/hud/hud.h"
#include "client/hud/hud_space.h"
#include "client/ui/overlay.h"
#include "client/ui/replay_bar.h"

namespace platon::hud_boxes_test {
namespace {

struct Picture {
  std::uint32_t width;
  std::uint32_t height;
  float scale;
};

constexpr Picture kPictures[] = {{640, 360, 1},      {1280, 720, 1},    {3840, 2160, 1},   {640, 360, 1.75F},
                                 {1280, 720, 1.75F}, {960, 720, 1},     {960, 720, 1.75F}, {1280, 1024, 1.5F},
                                 {2560, 1080, 1},    {1280, 720, 0.75F}};

const Font& font() {
  static const Font font;
  return font;
}

Scene longScene(int players, bool timed, bool arrived) {
  const LevelResult result =
      loadLevel("# title: " + std::string(100, 'W') + "\nHEXAHEDRON\n0 0 0 0\n1 0 0\n480\n%\n%\n%\n%\n%\n%\n");
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  Scene scene;
  scene.stage = makeStageModel(*result.level);
  scene.secondsLeft = 299;
  scene.timed = timed;
  for (int i = 0; i < players; ++i) {
    PlayerDrawing player;
    player.slot = static_cast<std::uint32_t>(i);
    player.pose = scene.stage->mesh.pose(3, {0, 0}, 0);  // behind the solid: name tags may cover each other
    player.number = std::to_string(i + 1);
    player.name = std::string(32, 'W');
    player.finishSeconds = 299.99;
    player.roundTripMs = 1016;
    scene.players.push_back(player);
  }
  PlayerDrawing ghost = scene.players.front();
  ghost.number = "G";
  for (int i = 0; i < 6; ++i) {
    ghost.pose = scene.stage->mesh.pose(0, {-200 + 80 * i, 60 * (i % 3)}, 0);
    scene.ghosts.push_back(ghost);
  }
  scene.players.back().local = true;
  scene.attempt = {arrived ? 299.99 : 299.98, arrived};
  scene.focus = scene.stage->mesh.pose(0, {0, 0}, 0);
  return scene;
}

// All others far from the picture, at every side of it.
void scatter(Scene& scene) {
  const Pose& focus = scene.focus;
  const glm::dvec3 right = glm::cross(focus.up, focus.normal);
  for (std::size_t i = 0; i + 1 < scene.players.size(); ++i) {
    const double angle = 0.7 * static_cast<double>(i);
    scene.players[i].pose.position = focus.position + 3000.0 * (std::cos(angle) * right + std::sin(angle) * focus.up);
  }
}

// The keys with the longest names, two for each control.
Bindings longKeys() {
  constexpr std::array kKeys{Key::kKeypad0, Key::kKeypad1,  Key::kKeypad2,   Key::kKeypad3,   Key::kKeypad4,
                             Key::kKeypad5, Key::kKeypad6,  Key::kKeypad7,   Key::kKeypad8,   Key::kKeypad9,
                             Key::kPageUp,  Key::kInsert,   Key::kBackslash, Key::kSpace,     Key::kControl,
                             Key::kShift,   Key::kEnter,    Key::kDelete,    Key::kHome,      Key::kEnd,
                             Key::kTab,     Key::kPageDown, Key::kArrowUp,   Key::kArrowDown, Key::kF10,
                             Key::kF12,     Key::kComma,    Key::kPeriod,    Key::kF2,        Key::kF4};
  static_assert(kKeys.size() == 2 * kControlCount);
  Bindings bindings;
  for (std::size_t i = 0; i < kKeys.size(); ++i) bindings.bind(static_cast<Control>(i / 2), kKeys[i]);
  return bindings;
}

HudStatus everything(const NetGraph& graph) {
  HudStatus status;
  status.message = "lost the connection to a.long.name.of.a.server.example.org:65535; reconnecting …";
  status.notice = "The server restarts at noon, and everybody is invited to come back after it";
  status.vote = VoteStatus{100, 256, true};
  status.run = {.best = 299.99, .difference = -299.99, .isNewBest = false};
  status.chat = {"Ann: " + std::string(120, 'W'), "Ben: wait for me", "Cid: " + std::string(60, 'm')};
  status.hint = "watching " + std::string(20, 'W') + "… · E: next";
  status.netGraph = &graph;
  status.keys = KeyHints(longKeys(), false);
  return status;
}

HudBox boxOf(const Overlay::Text& text) {
  Overlay alone;
  alone.texts.push_back(text);
  return boundsOf(alone, font());
}

// Name tags, which alone are translucent, may cover each other.
bool isTag(const Overlay::Text& text) { return text.colour.a < 1; }

// Panels that are not on another one, and texts that are on no panel and no name tags.
std::vector<HudBox> boxesOf(const Overlay& hud) {
  std::vector<HudBox> boxes;
  const auto isInside = [&](const HudBox& box) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const HudBox& outer) {
      return box.low.x >= outer.low.x - 0.5F && box.low.y >= outer.low.y - 0.5F && box.high.x <= outer.high.x + 0.5F &&
             box.high.y <= outer.high.y + 0.5F;
    });
  };
  for (const Overlay::Panel& panel : hud.panels) {
    const HudBox box{panel.low, panel.high};
    if (!isInside(box)) boxes.push_back(box);
  }
  for (const Overlay::Text& text : hud.texts) {
    const HudBox box = boxOf(text);
    if (!isTag(text) && !isInside(box)) boxes.push_back(box);
  }
  return boxes;
}

HudBox innerOf(const HudBox& box) { return {box.low + 0.5F, box.high - 0.5F}; }

void expectTextsApart(const std::vector<Overlay::Text>& texts) {
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (isTag(texts[i]) && isTag(texts[j])) continue;
      EXPECT_FALSE(innerOf(boxOf(texts[i])).overlaps(boxOf(texts[j]))) << texts[i].content << "\n" << texts[j].content;
    }
  }
}

void expectTagsBeside(const std::vector<Overlay::Panel>& panels, const std::vector<Overlay::Text>& texts) {
  for (const Overlay::Text& text : texts) {
    for (const Overlay::Panel& panel : panels) {
      EXPECT_FALSE(isTag(text) && innerOf(boxOf(text)).overlaps({panel.low, panel.high})) << text.content;
    }
  }
}

// The display, and above it the bar of a replay if there is one.
Overlay drawn(const Scene& scene, HudStatus status, const Picture& picture, bool replay) {
  Camera camera;
  camera.set(scene.focus, scene.stage->mesh, picture.width, picture.height);
  status.scale = textScale(picture.scale, picture.height);
  Overlay bar;
  if (replay) {
    const glm::vec2 screen(Overlay::widthFor(picture.width, picture.height), Overlay::kHeight);
    bar = scaledBy(makeReplayBar({100, 200, 1, false, false, true}, font(), screen / status.scale), status.scale);
    status.foot = Overlay::kHeight - boundsOf(bar, font()).low.y;
  }
  Overlay hud = makeHud(scene, camera, status, font());
  hud.panels.insert(hud.panels.end(), bar.panels.begin(), bar.panels.end());
  hud.texts.insert(hud.texts.end(), bar.texts.begin(), bar.texts.end());
  return hud;
}

void expectOrder(const Scene& scene, const HudStatus& status, const Picture& picture, bool replay = false) {
  const Overlay hud = drawn(scene, status, picture, replay);
  expectTextsApart(hud.texts);
  expectTagsBeside(hud.panels, hud.texts);
  const float pixels = static_cast<float>(picture.height) / Overlay::kHeight;
  for (const Overlay::Text& text : hud.texts)
    EXPECT_GT(text.size * pixels, kSmallestTextPixels - 0.01F) << text.content;
  const std::vector<HudBox> boxes = boxesOf(hud);
  const float width = Overlay::widthFor(picture.width, picture.height);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_GE(boxes[i].low.x, 0);
    EXPECT_GE(boxes[i].low.y, 0);
    EXPECT_LE(boxes[i].high.x, width + 0.01F);
    EXPECT_LE(boxes[i].high.y, Overlay::kHeight + 0.01F);
    for (std::size_t j = 0; j < i; ++j) {
      const HudBox inner = innerOf(boxes[i]);
      EXPECT_FALSE(inner.overlaps(boxes[j]))
          << "x " << inner.low.x << ".." << inner.high.x << " y " << inner.low.y << ".." << inner.high.y << " and x "
          << boxes[j].low.x << ".." << boxes[j].high.x << " y " << boxes[j].low.y << ".." << boxes[j].high.y;
    }
  }
}

bool shows(const Overlay& hud, const std::string& content) {
  return std::any_of(hud.texts.begin(), hud.texts.end(),
                     [&](const Overlay::Text& text) { return text.content == content; });
}

NetGraph filledGraph() {
  NetGraph graph;
  for (std::size_t i = 0; i < NetGraph::kSamples; ++i) graph.add({});
  return graph;
}

TEST(HudBoxes, NothingOverlapsInAnyState) {
  const NetGraph graph = filledGraph();
  for (const Picture& picture : kPictures) {
    SCOPED_TRACE(testing::Message() << picture.width << " x " << picture.height << " at " << picture.scale);
    for (const int players : {1, 2, 64}) {
      for (const bool timed : {false, true}) {
        for (const bool help : {false, true}) {
          HudStatus status = everything(graph);
          status.help = help;
          expectOrder(longScene(players, timed, false), status, picture);
          expectOrder(longScene(players, timed, true), status, picture);
          Scene scattered = longScene(players, timed, false);
          scatter(scattered);
          expectOrder(scattered, status, picture);
          status.vote.reset();
          status.summary = RoundSummary{std::string(100, 'W'), 5, 299.99, std::string(32, 'W'), false, !timed};
          expectOrder(longScene(players, timed, true), status, picture);
        }
      }
    }
  }
}

TEST(HudBoxes, NothingOverlapsWhatPlayersReachAndNeed) {
  for (const Picture& picture : kPictures) {
    SCOPED_TRACE(testing::Message() << picture.width << " x " << picture.height << " at " << picture.scale);
    Scene scene = longScene(2, false, true);
    HudStatus status;
    status.keys = KeyHints(longKeys(), false);
    status.medals = MedalTimes{1, 2, 74070};
    status.run = {
        .best = 3599.99, .difference = 3599.99, .isNewBest = false, .notRecorded = "too many players to be recorded"};
    status.summary = RoundSummary{.nextTitle = std::string(100, 'W'), .waits = true};
    expectOrder(scene, status, picture);
    status.run = {.best = 3599.99, .difference = -3599.99, .isNewBest = true};
    expectOrder(scene, status, picture);
    status.summary.reset();
    expectOrder(scene, status, picture);
    scene = longScene(1, true, false);
    scene.neededPlayers = 64;
    expectOrder(scene, status, picture);
    scene.needsRestart = true;
    expectOrder(scene, status, picture);
  }
}

TEST(HudBoxes, TheDisplayKeepsClearOfTheBarOfAReplay) {
  for (const Picture& picture : kPictures) {
    SCOPED_TRACE(testing::Message() << picture.width << " x " << picture.height << " at " << picture.scale);
    for (const int players : {1, 2, 64}) {
      Scene scene = longScene(players, true, false);
      scatter(scene);
      const HudStatus status{.notice = "picture saved: " + std::string(200, 'W')};
      expectOrder(scene, status, picture, true);
      EXPECT_TRUE(shows(drawn(scene, status, picture, true), "Cube · earth"));
      HudStatus helped = everything(filledGraph());
      helped.netGraph = nullptr;
      helped.help = true;
      expectOrder(scene, helped, picture, true);
    }
  }
}

TEST(HudBoxes, TheSignOfAPlayerBelowTheReplayBarIsAboveIt) {
  for (const Picture& picture : kPictures) {
    Scene scene = longScene(2, true, false);
    scene.players[0].name = "Ann";
    scene.players[0].pose.position = scene.focus.position - 3000.0 * scene.focus.up;
    EXPECT_TRUE(shows(drawn(scene, {}, picture, true), "↓ Ann")) << picture.width << " x " << picture.height;
  }
}

TEST(HudBoxes, TheTitleTheTimeAndTheHintAreShownAtEachSize) {
  for (const Picture& picture : kPictures) {
    const Scene scene = longScene(2, true, false);
    const Overlay hud = drawn(scene, {.vote = VoteStatus{1, 2, false}, .hint = "Roll on"}, picture, false);
    for (const char* const content : {"Cube · earth", "4:59", "your time 299.98 s", "Roll on"})
      EXPECT_TRUE(shows(hud, content)) << content;
  }
}

TEST(HudBoxes, TheHelpIsShownAtEachSizeAlsoWithTheGraph) {
  const NetGraph graph = filledGraph();
  for (const Picture& picture : kPictures) {
    const Scene scene = longScene(12, true, false);
    for (const Bindings& bindings : {Bindings(), longKeys()}) {
      const HudStatus status{.help = true, .keys = KeyHints(bindings), .hint = "Roll on", .netGraph = &graph};
      EXPECT_TRUE(shows(drawn(scene, status, picture, false), "run slower"))
          << picture.width << " x " << picture.height << " at " << picture.scale;
    }
  }
}

TEST(HudBoxes, TheScaleEnlargesTheTexts) {
  const Scene scene = longScene(1, false, false);
  Camera camera;
  camera.set(scene.focus, scene.stage->mesh, 1280, 720);
  const float size = makeHud(scene, camera, {}, font()).texts.front().size;
  EXPECT_FLOAT_EQ(makeHud(scene, camera, {.scale = 1.5F}, font()).texts.front().size, 1.5F * size);
}

}  // namespace
}  // namespace platon::hud_boxes_test
