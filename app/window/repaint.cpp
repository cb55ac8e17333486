#include "app/window/repaint.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace pupflow::window {
namespace {

constexpr int kTile = Repaint::kTile;

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio
  return hash ^ (hash >> 29);
}

template <class Value>
std::uint64_t hash_of(const Value& value, std::uint64_t hash = 1) {
  static_assert(sizeof(Value) % 4 == 0);
  for (std::size_t at = 0; at < sizeof(Value); at += 4) {
    std::uint32_t word = 0;
    std::memcpy(&word, reinterpret_cast<const char*>(&value) + at, 4);
    hash = mixed(hash, word);
  }
  return hash;
}

/// From window coordinates to pixels.
struct Pixels {
  explicit Pixels(const ImDrawData& data) : origin(data.DisplayPos), scale(data.FramebufferScale) {}

  float x(float place) const { return (place - origin.x) * scale.x; }
  float y(float place) const { return (place - origin.y) * scale.y; }
  PixelBox box(float left, float top, float right, float bottom) const {
    return {static_cast<int>(std::floor(x(left))), static_cast<int>(std::floor(y(top))),
            static_cast<int>(std::ceil(x(right))), static_cast<int>(std::ceil(y(bottom)))};
  }
  PixelBox clip(const ImDrawCmd& command) const {
    const ImVec4& clip = command.ClipRect;
    return box(clip.x, clip.y, clip.z, clip.w);
  }
  PixelBox window(const ImDrawData& data) const {
    return box(origin.x, origin.y, origin.x + data.DisplaySize.x, origin.y + data.DisplaySize.y);
  }

  ImVec2 origin, scale;
};

/// The corners of a triangle of a command.
struct Corners {
  const ImDrawVert& a;
  const ImDrawVert& b;
  const ImDrawVert& c;

  Corners(const ImDrawList& list, const ImDrawCmd& command, unsigned first)
      : a(at(list, command, first)),
        b(at(list, command, first + 1)),
        c(at(list, command, first + 2)) {}

  static const ImDrawVert& at(const ImDrawList& list, const ImDrawCmd& command, unsigned index) {
    const ImDrawIdx place = list.IdxBuffer[static_cast<int>(command.IdxOffset + index)];
    return list.VtxBuffer[static_cast<int>(command.VtxOffset + place)];
  }

  PixelBox box(const Pixels& pixels) const {
    const auto [left, right] = std::minmax({a.pos.x, b.pos.x, c.pos.x});
    const auto [top, bottom] = std::minmax({a.pos.y, b.pos.y, c.pos.y});
    return pixels.box(left, top, right, bottom);
  }
};

/// Calls `visit` with every list of `data` and each of its commands.
template <class Data, class Visit>
void for_commands(Data& data, Visit visit) {
  for (int l = 0; l < data.CmdListsCount; ++l) {
    for (ImDrawCmd& command : data.CmdLists[l]->CmdBuffer) visit(*data.CmdLists[l], command);
  }
}

/// The image that holds `box`; -1 when none does.
std::ptrdiff_t holder(std::span<const PixelBox> images, const PixelBox& box) {
  const auto found =
      std::ranges::find_if(images, [&](const auto& image) { return image.holds(box); });
  return found == images.end() ? -1 : found - images.begin();
}

/// The tiles for which `fresh` holds as few boxes, each in one image or outside.
template <class Fresh>
std::vector<PixelBox> joined(int columns, int rows, const PixelBox& window,
                             std::span<const PixelBox> images, Fresh fresh) {
  std::vector<PixelBox> boxes;
  const auto joins = [&](const PixelBox& a, const PixelBox& b) {
    return !a.empty() && holder(images, a) == holder(images, b);
  };
  const auto add = [&](const PixelBox& run) {
    if (run.empty()) return;
    const auto above = std::ranges::find_if(boxes, [&](const PixelBox& box) {
      return box.bottom == run.top && box.left == run.left && box.right == run.right &&
             joins(box, run);
    });
    if (above == boxes.end()) {
      boxes.push_back(run);
    } else {
      above->bottom = run.bottom;
    }
  };
  for (int row = 0; row < rows; ++row) {
    PixelBox run;
    for (int column = 0; column < columns; ++column) {
      if (!fresh(column, row)) continue;
      const PixelBox tile =
          common({column * kTile, row * kTile, (column + 1) * kTile, (row + 1) * kTile}, window);
      if (run.right == tile.left && joins(run, tile)) {
        run.right = tile.right;
      } else {
        add(std::exchange(run, tile));
      }
    }
    add(run);
  }
  return boxes;
}

}  // namespace

PixelBox common(const PixelBox& a, const PixelBox& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
          std::min(a.bottom, b.bottom)};
}

std::vector<PixelBox> Repaint::changed(const ImDrawData& data, std::span<const PixelBox> images,
                                       bool new_images) {
  const Pixels pixels(data);
  const PixelBox window = pixels.window(data);
  const int columns = (window.right + kTile - 1) / kTile,
            rows = (window.bottom + kTile - 1) / kTile;
  std::vector<std::uint64_t> tiles(
      static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 1);
  const auto for_tiles = [&](const PixelBox& box, auto visit) {
    const PixelBox seen = common(box, window);
    if (seen.empty()) return;
    for (int row = seen.top / kTile; row <= (seen.bottom - 1) / kTile; ++row) {
      for (int column = seen.left / kTile; column <= (seen.right - 1) / kTile; ++column) {
        visit(tiles[static_cast<std::size_t>(row * columns + column)]);
      }
    }
  };

  std::vector<std::uint64_t> vertices;
  const ImDrawList* hashed = nullptr;  // the list whose vertices these are
  for_commands(data, [&](const ImDrawList& list, const ImDrawCmd& command) {
    if (hashed != &list) {
      vertices.clear();
      for (const ImDrawVert& vertex : list.VtxBuffer) vertices.push_back(hash_of(vertex));
      hashed = &list;
    }
    const PixelBox clip = pixels.clip(command);
    const std::uint64_t own = hash_of(command.GetTexID(), hash_of(clip));
    for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
      const Corners corners(list, command, i);
      std::uint64_t hash = own;
      for (const ImDrawVert* corner : {&corners.a, &corners.b, &corners.c}) {
        hash = mixed(hash, vertices[static_cast<std::size_t>(corner - list.VtxBuffer.Data)]);
      }
      for_tiles(common(corners.box(pixels), clip),
                [&](std::uint64_t& tile) { tile = mixed(tile, hash); });
    }
  });

  const bool all =
      window != window_ || tiles_.size() != tiles.size() || !std::ranges::equal(images, images_);
  std::vector<bool> fresh(tiles.size(), all);
  if (!all) {
    for (std::size_t i = 0; i < tiles.size(); ++i) fresh[i] = tiles[i] != tiles_[i];
    if (new_images) {
      for (const PixelBox& image : images) {
        for_tiles(image, [&](std::uint64_t& tile) {
          fresh[static_cast<std::size_t>(&tile - tiles.data())] = true;
        });
      }
    }
  }
  tiles_ = std::move(tiles);
  window_ = window;
  images_.assign(images.begin(), images.end());
  return joined(columns, rows, window, images, [&](int column, int row) {
    return fresh[static_cast<std::size_t>(row * columns + column)];
  });
}

std::vector<PixelBox> gathered(std::span<const PixelBox> boxes, std::size_t most) {
  std::vector<PixelBox> few(boxes.begin(), boxes.end());
  const auto both = [](const PixelBox& a, const PixelBox& b) {
    return PixelBox{std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
                    std::max(a.bottom, b.bottom)};
  };
  const auto area = [](const PixelBox& box) { return std::int64_t{box.width()} * box.height(); };
  while (few.size() > std::max<std::size_t>(most, 1)) {
    std::size_t first = 0, second = 1;  // the two whose common box adds least
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (std::size_t a = 0; a < few.size(); ++a) {
      for (std::size_t b = a + 1; b < few.size(); ++b) {
        const std::int64_t added = area(both(few[a], few[b])) - area(few[a]) - area(few[b]);
        if (added < least) least = added, first = a, second = b;
      }
    }
    few[first] = both(few[first], few[second]);
    few.erase(few.begin() + static_cast<std::ptrdiff_t>(second));
  }
  return few;
}

void cut_to(ImDrawData& data, std::span<const PixelBox> boxes) {
  const Pixels pixels(data);
  const auto edge = [](int pixel, float origin, float scale) {
    return origin + static_cast<float>(pixel) / scale;
  };
  for (int l = 0; l < data.CmdListsCount; ++l) {
    ImDrawList& list = *data.CmdLists[l];
    ImVector<ImDrawCmd> commands;
    ImVector<ImDrawIdx> indices;
    for (const ImDrawCmd& command : list.CmdBuffer) {
      for (const PixelBox& box : boxes) {
        const PixelBox clip = common(pixels.clip(command), box);
        if (clip.empty()) continue;
        ImDrawCmd part = command;
        part.IdxOffset = static_cast<unsigned>(indices.Size);
        for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
          if (common(Corners(list, command, i).box(pixels), clip).empty()) continue;
          for (unsigned c = i; c < i + 3; ++c) {
            indices.push_back(list.IdxBuffer[static_cast<int>(command.IdxOffset + c)]);
          }
        }
        part.ElemCount = static_cast<unsigned>(indices.Size) - part.IdxOffset;
        if (part.ElemCount == 0) continue;
        part.ClipRect = {edge(clip.left, pixels.origin.x, pixels.scale.x),
                         edge(clip.top, pixels.origin.y, pixels.scale.y),
                         edge(clip.right, pixels.origin.x, pixels.scale.x),
                         edge(clip.bottom, pixels.origin.y, pixels.scale.y)};
        commands.push_back(part);
      }
    }
    if (commands.empty()) list.VtxBuffer.resize(0);
    list.CmdBuffer.swap(commands);
    list.IdxBuffer.swap(indices);
  }
}

}  // namespace pupflow::window
