#include "app/window/panels/scene_menu.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/gl/object.h"
#include "app/io/png_memory.h"
#include "app/io/scene_file.h"
#include "app/window/imgui_compat.h"

extern const char scene_pictures_begin[], scene_pictures_end[];

namespace pupflow::window {
namespace {

constexpr float kPictureWidth = 5.6f, kPictureHeight = 4.2f;  // em
constexpr float kWords = 23;                                  // em

struct Described {
  std::string_view name;
  std::string title, description;
};

/// With the subscripts of the typeface.
std::string with_subscripts(std::string text) {
  for (const auto& [written, set] : {std::pair{"T_a", "T\u2090"}, std::pair{"T_p", "T\u209a"}}) {
    for (std::size_t at = text.find(written); at != text.npos; at = text.find(written)) {
      text.replace(at, std::string_view(written).size(), set);
    }
  }
  return text;
}

const std::vector<Described>& shipped() {
  static const std::vector<Described> all = [] {
    std::vector<Described> scenes;
    for (const io::ShippedScene& scene : io::shipped_scenes()) {
      std::vector<std::string> none;
      const io::Scene read = io::parse_scene(scene.text, std::string(scene.name), none);
      scenes.push_back({scene.name, read.title, with_subscripts(read.description)});
    }
    return scenes;
  }();
  return all;
}

}  // namespace

/// One below the other in one texture, in the order of the scenes.
struct SceneMenu::Pictures {
  gl::Texture texture;

  Pictures() {
    const std::string_view file(
        scene_pictures_begin, static_cast<std::size_t>(scene_pictures_end - scene_pictures_begin));
    const io::Image image = io::read_png(file, "the pictures of the scenes");
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 image.rgba.data());
    glBindTexture(GL_TEXTURE_2D, 0);
  }

  void draw(ImDrawList& list, std::size_t scene, ImVec2 corner, ImVec2 size) const {
    const float share = 1 / static_cast<float>(shipped().size());
    const float top = static_cast<float>(scene) * share;
    list.AddImageRounded(texture_id(texture.name()), corner, {corner.x + size.x, corner.y + size.y},
                         {0, top}, {1, top + share}, IM_COL32_WHITE,
                         ImGui::GetStyle().FrameRounding);
  }
};

SceneMenu::SceneMenu() = default;
SceneMenu::~SceneMenu() = default;

void SceneMenu::draw(const PanelInput& in) {
  const bool open = ImGui::BeginMenu("Shipped scenes");
  in.events.widget("menu-shipped");
  if (!open) return;
  if (!pictures_) pictures_ = std::make_unique<Pictures>();
  const float em = ImGui::GetFontSize(), gap = 0.7f * em;
  const ImVec2 picture{kPictureWidth * em, kPictureHeight * em};
  const float words = std::min(kWords * em, 0.8f * ImGui::GetIO().DisplaySize.x - picture.x);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < shipped().size(); ++i) {
    const Described& scene = shipped()[i];
    const std::string name(scene.name);
    const float described = ImGui::CalcTextSize(scene.description.c_str(), nullptr, false, words).y;
    const float height = std::max(picture.y, 1.3f * em + described);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{picture.x + gap + words, height};
    if (ImGui::Selectable(("##" + name).c_str(), false, 0, size)) in.controls.open = scene.name;
    in.events.widget("menu-scene-" + name);
    if (!ImGui::IsItemVisible()) continue;
    pictures_->draw(list, i, corner, picture);
    const float x = corner.x + picture.x + gap;
    list.AddText({x, corner.y}, kInk, scene.title.c_str());
    list.AddText(ImGui::GetFont(), em, {x, corner.y + 1.3f * em}, kFaint, scene.description.c_str(),
                 nullptr, words);
  }
  ImGui::EndMenu();
}

}  // namespace pupflow::window
