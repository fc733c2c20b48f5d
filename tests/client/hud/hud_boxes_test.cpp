// No parts of the display overlap, whatever it shows and however small the picture is.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/hud/hud.h"
#include "client/hud/hud_space.h"
#include "client/ui/text_scale.h"

namespace platon {
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
  scene.players.back().local = true;
  scene.attempt = {arrived ? 299.99 : 299.98, arrived};
  scene.focus = scene.stage->mesh.pose(0, {0, 0}, 0);
  return scene;
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
  return status;
}

// Panels that are not on another one, and texts that are on no panel.
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
    Overlay alone;
    alone.texts.push_back(text);
    const HudBox box = boundsOf(alone, font());
    if (!isInside(box)) boxes.push_back(box);
  }
  return boxes;
}

void expectOrder(const Scene& scene, HudStatus status, const Picture& picture) {
  Camera camera;
  camera.set(scene.focus, scene.stage->mesh, picture.width, picture.height);
  status.scale = textScale(picture.scale, picture.height);
  const Overlay hud = makeHud(scene, camera, status, font());
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
      const HudBox inner{boxes[i].low + 0.5F, boxes[i].high - 0.5F};
      EXPECT_FALSE(inner.overlaps(boxes[j]))
          << "x " << inner.low.x << ".." << inner.high.x << " y " << inner.low.y << ".." << inner.high.y << " and x "
          << boxes[j].low.x << ".." << boxes[j].high.x << " y " << boxes[j].low.y << ".." << boxes[j].high.y;
    }
  }
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
          status.vote.reset();
          status.summary = RoundSummary{std::string(100, 'W'), 5, 299.99, std::string(32, 'W'), false, !timed};
          expectOrder(longScene(players, timed, true), status, picture);
        }
      }
    }
  }
}

TEST(HudBoxes, TheTitleTheTimeAndTheHintAreShownAtEachSize) {
  for (const Picture& picture : kPictures) {
    Scene scene = longScene(2, true, false);
    Camera camera;
    camera.set(scene.focus, scene.stage->mesh, picture.width, picture.height);
    const HudStatus status{
        .vote = VoteStatus{1, 2, false}, .hint = "Roll on", .scale = textScale(picture.scale, picture.height)};
    const Overlay hud = makeHud(scene, camera, status, font());
    for (const char* const content : {"Cube · earth", "4:59", "your time 299.98 s", "Roll on"}) {
      EXPECT_TRUE(std::any_of(hud.texts.begin(), hud.texts.end(), [&](const Overlay::Text& text) {
        return text.content == content;
      })) << content;
    }
  }
}

TEST(HudBoxes, TheHelpIsShownAtEachSizeAlsoWithTheGraph) {
  const NetGraph graph = filledGraph();
  for (const Picture& picture : kPictures) {
    const Scene scene = longScene(12, true, false);
    Camera camera;
    camera.set(scene.focus, scene.stage->mesh, picture.width, picture.height);
    const HudStatus status{
        .help = true, .hint = "Roll on", .scale = textScale(picture.scale, picture.height), .netGraph = &graph};
    const Overlay hud = makeHud(scene, camera, status, font());
    EXPECT_TRUE(std::any_of(hud.texts.begin(), hud.texts.end(),
                            [](const Overlay::Text& text) { return text.content == "run slower"; }))
        << picture.width << " x " << picture.height << " at " << picture.scale;
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
}  // namespace platon
