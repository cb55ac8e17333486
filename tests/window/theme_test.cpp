#include "app/window/theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/window/panels/plot.h"

namespace pupflow::window {
namespace {

/// Relative luminance of sRGB (WCAG 2.2).
double luminance(ImU32 packed) {
  const auto linear = [&](int shift) {
    const double share = ((packed >> shift) & 0xff) / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(IM_COL32_R_SHIFT) + 0.7152 * linear(IM_COL32_G_SHIFT) +
         0.0722 * linear(IM_COL32_B_SHIFT);
}

double contrast(ImU32 a, ImU32 b) {
  const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
  return (light + 0.05) / (dark + 0.05);
}

constexpr std::size_t kColors = sizeof(Palette) / sizeof(ImU32);

TEST(Theme, ContrastIsTheOneOfTheStandard) {
  EXPECT_NEAR(contrast(IM_COL32(0, 0, 0, 255), IM_COL32(255, 255, 255, 255)), 21, 1e-9);
  EXPECT_NEAR(contrast(IM_COL32(119, 119, 119, 255), IM_COL32(255, 255, 255, 255)), 4.48, 0.01);
}

TEST(Theme, TextCanBeReadOnWhateverItStandsOn) {
  constexpr double kLeast = 4.5;
  const auto names = {"ink", "faint", "accent", "bad"};
  ImU32 Palette::*const texts[] = {&Palette::ink, &Palette::faint, &Palette::accent, &Palette::bad};
  ImU32 Palette::*const plain[] = {&Palette::panel, &Palette::menu, &Palette::popup};
  ImU32 Palette::*const worked[] = {&Palette::field,          &Palette::field_hovered,
                                    &Palette::field_active,   &Palette::button,
                                    &Palette::button_hovered, &Palette::button_active,
                                    &Palette::header,         &Palette::header_hovered,
                                    &Palette::header_active,  &Palette::bad_panel};
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const Palette& of = palette_of(theme);
    const auto expect = [&](ImU32 text, ImU32 under, const char* what, int place) {
      EXPECT_GE(contrast(text, under), kLeast) << kThemeNames[static_cast<std::size_t>(theme)]
                                               << ", " << what << " on surface " << place;
    };
    for (int place = 0; ImU32 Palette::*const under : plain) {
      for (std::size_t i = 0; i < std::size(texts); ++i) {
        expect(of.*texts[i], of.*under, names.begin()[i], place);
      }
      ++place;
    }
    for (int place = 100; ImU32 Palette::*const under : worked) {
      expect(of.ink, of.*under, "ink", place);
      expect(of.faint, of.*under, "faint", place++);
    }
    expect(of.bad, of.bad_panel, "bad", 200);
    expect(of.paper_ink, of.paper, "paper_ink", 201);
    expect(of.paper_faint, of.paper, "paper_faint", 202);
  }
}

TEST(Theme, CurvesAndTheirNumbersCanBeRead) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const Palette& of = palette_of(theme);
    const PlotColors colors = plot_colors(of);
    for (int curve = 0;
         const ImU32 color : {colors.curve, colors.second, colors.selected, colors.tp, colors.ta}) {
      for (const ImU32 under : {of.popup, of.panel}) {
        EXPECT_GE(contrast(color, under), 4.5)
            << kThemeNames[static_cast<std::size_t>(theme)] << ", curve " << curve;
      }
      ++curve;
    }
    EXPECT_GE(contrast(colors.reference, of.popup), 3);
  }
}

TEST(Theme, EveryColorIsSetAndOpaque) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    const auto* colors = reinterpret_cast<const ImU32*>(&palette_of(theme));
    for (std::size_t i = 0; i < kColors; ++i) {
      EXPECT_EQ(colors[i] >> IM_COL32_A_SHIFT, 255u) << "color " << i;
    }
  }
}

}  // namespace
}  // namespace pupflow::window
