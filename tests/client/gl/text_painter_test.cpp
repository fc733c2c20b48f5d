#include "client/gl/text_painter.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "client/gl/gl_loader.h"
#include "client/gl/offscreen.h"
#include "client/gl/render_target.h"

namespace platon::text_painter_test {
namespace {

constexpr std::uint32_t kWidth = 400;
constexpr std::uint32_t kHeight = 60;

std::string utf8Of(char32_t point) {
  std::string bytes;
  bytes += static_cast<char>(0xE0 | point >> 12);
  bytes += static_cast<char>(0x80 | (point >> 6 & 0x3F));
  bytes += static_cast<char>(0x80 | (point & 0x3F));
  return bytes;
}

// A name of 20 glyphs that no other `index` has.
std::string hostileName(int index) {
  std::string name;
  for (int i = 0; i < 20; ++i) name += utf8Of(static_cast<char32_t>(0x1000 + 20 * index + i));
  return name;
}

// The largest difference of a colour component.
int difference(const Image& a, const Image& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
  return largest;
}

class TextPainterTest : public testing::Test {
 protected:
  // White text on black. `before` is added in the same flush, outside the picture.
  Image draw(TextPainter& painter, const std::string& text, const std::string& before = "") {
    target_.bindSampled();
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    target_.resolve();
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    painter.add(before, {0, -5000}, {32, 0}, {0, 32}, {1, 1, 1, 1});
    painter.add(text, {10, 20}, {32, 0}, {0, 32}, {1, 1, 1, 1});
    painter.flush(glm::ortho(0.0F, float{kWidth}, 0.0F, float{kHeight}), 0);
    EXPECT_EQ(takeGlErrors(), "");
    return target_.read();
  }
  Image drawWithNewPainter(const std::string& text) {
    TextPainter painter(font_);
    return draw(painter, text);
  }

  Offscreen context_;
  Font font_;
  RenderTarget target_{kWidth, kHeight, 1};
};

TEST_F(TextPainterTest, TextIsWhereItIsAdded) {
  const Image image = drawWithNewPainter("I");
  const auto bright = [&](int x, int y) {
    return image.pixels[3 * (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x))] > 200;
  };
  const int stem = 10 + static_cast<int>(font_.advance(U'I') * 32 / 2);
  EXPECT_TRUE(bright(stem, static_cast<int>(kHeight) - 20 - 10));
  EXPECT_FALSE(bright(stem, static_cast<int>(kHeight) - 20 + 4)) << "below the baseline";
  EXPECT_FALSE(bright(stem + 20, static_cast<int>(kHeight) - 20 - 10)) << "to the right";
}

TEST_F(TextPainterTest, FlushRemovesAllText) {
  TextPainter painter(font_);
  draw(painter, "Text");
  const Image empty = draw(painter, "");
  EXPECT_EQ(*std::max_element(empty.pixels.begin(), empty.pixels.end()), 0);
}

TEST_F(TextPainterTest, TwoHundredHostileNamesOneAfterAnotherDoNotBlankTheText) {
  TextPainter painter(font_);
  for (int i = 0; i < 200; ++i) draw(painter, hostileName(i));
  EXPECT_LE(difference(draw(painter, "Platon"), drawWithNewPainter("Platon")), 2);
}

TEST_F(TextPainterTest, TwoHundredHostileNamesAtOnceDoNotBlankTheText) {
  TextPainter painter(font_);
  std::string all;
  for (int i = 0; i < 200; ++i) all += hostileName(i);
  EXPECT_LE(difference(draw(painter, "Platon", all), drawWithNewPainter("Platon")), 2);
  EXPECT_LE(difference(draw(painter, hostileName(7), "Platon" + all), drawWithNewPainter(hostileName(7))), 2);
}

}  // namespace
}  // namespace platon::text_painter_test
