#include "app/window/panels/afferent_map_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "app/io/celsius.h"
#include "app/io/text.h"
#include "app/window/panels/choice.h"
#include "app/window/pup_values.h"
#include "app/window/selection.h"
#include "app/window/text_line.h"

namespace pupflow::window {
namespace {

constexpr ImU32 kCellInk = IM_COL32(20, 22, 26, 255);  // lines on the cells, which are of any color
constexpr ImU32 kCellPaper = IM_COL32(255, 255, 255, 230);

std::string text_of(const Field& field, double value) {
  if (std::isnan(value)) return "not known";
  if (field.kind == FieldKind::categorical && value < 0) return "nobody";
  const auto category = static_cast<std::size_t>(std::max(value, 0.0));
  if (category < field.categories.size()) return std::string(field.categories[category]);
  std::string text = io::number_text(std::round(value * 1e4) / 1e4);
  if (!field.unit.empty()) text += ' ' + std::string(field.unit);
  return io::with_celsius(text, value, io::is_temperature(field));
}

/// Small text on a spot of paper, with its middle at `middle`.
void spot(ImDrawList& list, const Fonts& fonts, ImVec2 middle, std::string_view text) {
  const std::string words(text);
  const ImVec2 box = small_text_size(fonts, words);
  const ImVec2 corner{std::round(middle.x - box.x / 2), std::round(middle.y - box.y / 2)};
  list.AddRectFilled({corner.x - 2, corner.y}, {corner.x + box.x + 2, corner.y + box.y}, kCellPaper,
                     3);
  small_text(list, fonts, corner, kCellInk, words);
}

/// The sign of the direction of travel.
void draw_ahead(ImDrawList& list, ImVec2 place, float em) {
  list.AddCircleFilled(place, 0.28f * em, kCellPaper);
  list.AddCircleFilled(place, 0.16f * em, kCellInk);
}

/// The colors of `field` for these values. Temperatures go from T_a to T_p, or as far as there are
/// any: what touches and what does not stand apart.
view::ColorScale scale_of(const LitterField& field, const std::vector<double>& values,
                          const Params& params) {
  view::ColorScale scale(field);
  if (!scale.is_temperature()) return scale.fitted(values);
  double low = std::min(params.ambient_temperature, params.preferred_temperature);
  double high = std::max(params.ambient_temperature, params.preferred_temperature);
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low < high && std::isfinite(high - low)) scale.set_range(low, high);
  return scale.fitted(values);
}

Eigen::Vector3d towards(double heading) {
  return {std::cos(heading), std::sin(heading), 0};
}

}  // namespace

AfferentMapPanel::Look AfferentMapPanel::look_at(const PanelInput& in, int pup) const {
  const LitterView litter = in.state.view();
  const int k = litter.params.face_points;
  Look look{values_of(*field_, litter, pup), {}, {}, 0, {}};
  look.scale = scale_of(*field_, look.values, litter.params);
  for (std::size_t i = 0; i < look.values.size(); ++i) {
    look.colors.push_back(static_cast<int>(i) == hovered_ ? kCellInk
                                                          : packed(look.scale(look.values[i])));
  }
  const double heading = litter.heading[static_cast<std::size_t>(pup)];
  const Eigen::Vector3d ahead = towards(heading);
  const Eigen::Vector3d middle = middle_of(litter, pup).value_or(Eigen::Vector3d::Zero());
  for (int i = 0; i < litter.points; ++i) {
    const Eigen::Vector3d away = litter.positions(pup, i) - middle;
    look.left.push_back(ahead.x() * away.y() - ahead.y() * away.x() > 0);
  }
  const Eigen::Vector3d on_body = view::body_rotation(litter, pup).transpose() * ahead;
  look.ahead = on_body.allFinite() ? view::afferent_towards(on_body, k) : 0;
  return look;
}

void AfferentMapPanel::draw(const PanelInput& in, int pup) {
  draw_fields(in);
  const LitterView litter = in.state.view();
  if (!is_known(*field_, litter)) {
    ImGui::TextDisabled("Known from the next step on.");
    return;
  }
  const Look look = look_at(in, pup);
  hovered_ = -1;
  draw_disc(in, pup, look);
  draw_cross(in, pup, look);
  draw_legend(in, look);
}

void AfferentMapPanel::draw_fields(const PanelInput& in) {
  const std::string label = "skin: " + std::string(field_->label);
  const char* const doc = "The skin of the pup, a cell for each afferent: what its colors mean.";
  draw_choice("map", label, doc, in, [&](const auto& choice) {
    for (const LitterField& field : afferent_fields()) {
      if (choice(field.name, field.label, field.doc, &field == field_)) field_ = &field;
    }
  });
}

/// Rows of equal color are one rectangle each.
void AfferentMapPanel::draw_disc(const PanelInput& in, int pup, const Look& look) {
  const LitterView litter = in.state.view();
  const float em = ImGui::GetFontSize(), room = ImGui::GetContentRegionAvail().x;
  const float side = std::clamp(room - 7 * em, 4 * em, 12 * em);
  const int size = static_cast<int>(side);
  const int k = litter.params.face_points;
  if (!disc_ || disc_->size() != size || disc_->face_points() != k) disc_.emplace(k, size);
  const double heading = litter.heading[static_cast<std::size_t>(pup)];
  disc_->update(view::body_rotation(litter, pup), std::isfinite(heading) ? heading : 0);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 cursor = ImGui::GetCursorScreenPos();
  const ImVec2 corner{std::round(cursor.x + (room - side) / 2), std::round(cursor.y + 0.3f * em)};
  const auto& afferents = disc_->afferents();
  const auto width = static_cast<std::size_t>(size);
  const auto color = [&](int afferent) {
    return afferent < 0 ? ImU32{0} : look.colors[static_cast<std::size_t>(afferent)];
  };
  for (std::size_t row = 0; row < width; ++row) {
    const float y = corner.y + static_cast<float>(row);
    for (std::size_t begin = 0, end = 0; begin < width; begin = end) {
      const ImU32 same = color(afferents[row * width + begin]);
      while (end < width && color(afferents[row * width + end]) == same) ++end;
      if (same == 0) continue;
      list.AddRectFilled({corner.x + static_cast<float>(begin), y},
                         {corner.x + static_cast<float>(end), y + 1}, same);
    }
  }
  const auto radius = static_cast<float>(size) / 2;
  const ImVec2 middle{corner.x + radius, corner.y + radius};
  list.AddCircle(middle, radius, kFaint, 96, 1.5f);
  list.AddLine({middle.x, corner.y}, {middle.x, corner.y + static_cast<float>(size)}, kCellPaper,
               2.5f);
  list.AddLine({middle.x, corner.y}, {middle.x, corner.y + static_cast<float>(size)}, kCellInk, 1);
  draw_ahead(list, middle, em);
  const float text = 1.9f * em;
  const ImVec2 half = ImGui::CalcTextSize("left");
  list.AddText({middle.x - radius - text - half.x / 2, middle.y - half.y / 2}, kInk, "left");
  list.AddText({middle.x + radius + text - half.x / 2, middle.y - half.y / 2}, kInk, "right");

  ImGui::SetCursorScreenPos(corner);
  ImGui::InvisibleButton("disc", {static_cast<float>(size), static_cast<float>(size)});
  in.events.widget("disc");
  if (!ImGui::IsItemHovered()) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const int row = static_cast<int>(mouse.y - corner.y),
            column = static_cast<int>(mouse.x - corner.x);
  if (row < 0 || row >= size || column < 0 || column >= size) return;
  point_at(in, pup, look,
           afferents[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)]);
}

void AfferentMapPanel::draw_cross(const PanelInput& in, int pup, const Look& look) {
  const int k = in.state.view().params.face_points;
  const float em = ImGui::GetFontSize(), room = ImGui::GetContentRegionAvail().x;
  const float face = std::floor(std::min(room / view::kCrossWidth, 4 * em));
  const ImVec2 cursor = ImGui::GetCursorScreenPos();
  const ImVec2 corner{std::round(cursor.x + (room - view::kCrossWidth * face) / 2),
                      std::round(cursor.y + 0.6f * em)};
  const auto at = [&](const Eigen::Vector2d& place) {
    return ImVec2{corner.x + static_cast<float>(place.x()) * face,
                  corner.y + static_cast<float>(place.y()) * face};
  };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!cross_ || cross_->face_points() != k) cross_.emplace(k);
  const std::vector<Eigen::Vector2d>& cells = cross_->cells();
  const Eigen::Vector2d edge = Eigen::Vector2d::Constant(1.0 / k);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    list.AddRectFilled(at(cells[i]), at(cells[i] + edge), look.colors[i]);
  }
  // The line between left and right, along the edges of cells.
  const auto between = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    list.AddLine(at(from), at(to), kCellPaper, 3);
    list.AddLine(at(from), at(to), kCellInk, 1.2f);
  };
  const auto left_at = [&](const Eigen::Vector2d& place) {
    const int afferent = cross_->afferent(place);
    return afferent < 0 ? -1 : int{look.left[static_cast<std::size_t>(afferent)]};
  };
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Eigen::Vector2d middle = cells[i] + edge / 2, x(edge.x(), 0), y(0, edge.y());
    const int left = look.left[i] ? 1 : 0;
    if (left_at(middle + x) == 1 - left) between(cells[i] + x, cells[i] + edge);
    if (left_at(middle + y) == 1 - left) between(cells[i] + y, cells[i] + edge);
  }
  for (const view::CrossFace& one : view::kCross) {
    const Eigen::Vector2d low(one.x, one.y), high(one.x + 1, one.y + 1);
    list.AddRect(at(low), at(high), kFaint);
    spot(list, in.fonts, at(low + Eigen::Vector2d(0.16, 0.14)), one.name);
  }
  // The letters stand where most of the left and of the right is.
  for (const int side : {0, 1}) {
    std::array<Eigen::Vector2d, 6> sum;
    std::array<int, 6> count{};
    sum.fill(Eigen::Vector2d::Zero());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (int{look.left[i]} != side) continue;
      const std::size_t one = i / static_cast<std::size_t>(k * k);
      sum[one] += cells[i] + edge / 2;
      ++count[one];
    }
    const auto most =
        static_cast<std::size_t>(std::max_element(count.begin(), count.end()) - count.begin());
    if (count[most] > 0) {
      spot(list, in.fonts, at(sum[most] / count[most]), side == 1 ? "left" : "right");
    }
  }
  draw_ahead(list, at(cells[static_cast<std::size_t>(look.ahead)] + edge / 2), em);

  ImGui::SetCursorScreenPos(corner);
  ImGui::InvisibleButton("cross", {view::kCrossWidth * face, view::kCrossHeight * face});
  in.events.widget("cross");
  if (!ImGui::IsItemHovered()) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  point_at(in, pup, look,
           cross_->afferent({static_cast<double>((mouse.x - corner.x) / face),
                             static_cast<double>((mouse.y - corner.y) / face)}));
}

/// The colors and what they stand for: a bar, or the categories that there are.
void AfferentMapPanel::draw_legend(const PanelInput& in, const Look& look) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float em = ImGui::GetFontSize(), room = ImGui::GetContentRegionAvail().x;
  const ImVec2 cursor = ImGui::GetCursorScreenPos();
  const ImVec2 corner{cursor.x, cursor.y + 0.4f * em};
  if (look.scale.categorical()) {
    std::set<double> present;
    for (const double value : look.values) {
      if (!std::isnan(value)) present.insert(value);
    }
    ImVec2 at = corner;
    for (const double value : present) {
      const std::string text = text_of(*field_, value);
      const float width = 1.4f * em + ImGui::CalcTextSize(text.c_str()).x;
      if (at.x > corner.x && at.x + width > corner.x + room) at = {corner.x, at.y + 1.3f * em};
      list.AddRectFilled({at.x, at.y + 0.15f * em}, {at.x + 0.9f * em, at.y + 0.95f * em},
                         packed(look.scale(value)), 2);
      list.AddText({at.x + 1.2f * em, at.y}, kInk, text.c_str());
      at.x += width + em;
    }
    ImGui::Dummy({room, at.y - cursor.y + 1.6f * em});
    return;
  }
  constexpr int kPieces = 64;
  const auto value_at = [&](int piece) {
    return look.scale.min + (look.scale.max - look.scale.min) * (piece + 0.5) / kPieces;
  };
  const std::string low = text_of(*field_, look.scale.min), high = text_of(*field_, look.scale.max);
  const ImVec2 low_size = ImGui::CalcTextSize(low.c_str()),
               high_size = ImGui::CalcTextSize(high.c_str());
  const float left = corner.x + low_size.x + 0.6f * em;
  const float width = std::max(room - low_size.x - high_size.x - 1.2f * em, em);
  list.AddText(corner, kInk, low.c_str());
  for (int piece = 0; piece < kPieces; ++piece) {
    const auto x = [&](int end) { return left + width * static_cast<float>(end) / kPieces; };
    list.AddRectFilled({x(piece), corner.y + 0.15f * em}, {x(piece + 1), corner.y + 0.95f * em},
                       packed(look.scale(value_at(piece))));
  }
  list.AddText({left + width + 0.6f * em, corner.y}, kInk, high.c_str());
  ImGui::Dummy({room, 1.9f * em});
  in.tips.show(field_->doc);
}

/// The mouse is on the cell of an afferent, or on none.
void AfferentMapPanel::point_at(const PanelInput& in, int pup, const Look& look, int afferent) {
  hovered_ = afferent;
  if (afferent < 0) return;
  const LitterView litter = in.state.view();
  const auto at = static_cast<std::size_t>(pup) * static_cast<std::size_t>(litter.points) +
                  static_cast<std::size_t>(afferent);
  const int other = litter.touched.empty() ? -1 : litter.touched[at];
  if (other >= 0 && ImGui::IsItemClicked()) in.controls.select(other);
  if (!in.tips.begin()) return;
  const auto i = static_cast<std::size_t>(afferent);
  ImGui::Text("afferent %d, on the %s", afferent, look.left[i] ? "left" : "right");
  ImGui::Text("%s: %s", std::string(field_->label).c_str(),
              text_of(*field_, look.values[i]).c_str());
  if (other >= 0) ImGui::Text("touches pup %d; click to select it", other);
  in.tips.end();
}

}  // namespace pupflow::window
