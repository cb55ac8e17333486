#include "app/window/gui.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "app/window/imgui_compat.h"

namespace pupflow::window {

Gui::Gui(const context::GlfwWindow& window, double ui_scale, Theme theme)
    : window_(window), ui_scale_(ui_scale), theme_(theme) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // no files beside those that were asked for
  ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
  glfwSetKeyCallback(window.handle(), nullptr);
  ImGui_ImplOpenGL3_Init("#version 330 core");
  follow_scale();
}

Gui::~Gui() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

/// What the panels need at scale 1; in a window too narrow for its scale they are smaller.
constexpr float kLeastWidth = 360;

/// Where window coordinates are pixels, text must grow with the display's scale; where the system
/// scales windows itself, only the typeface's resolution must.
void Gui::follow_scale() {
  int width = 0, pixels = 0, unused = 0;
  glfwGetWindowSize(window_.handle(), &width, &unused);
  glfwGetFramebufferSize(window_.handle(), &pixels, &unused);
  const float density =
      width > 0 && pixels > 0 ? static_cast<float>(pixels) / static_cast<float>(width) : 1.0f;
  const float wanted = ui_scale_ > 0 ? static_cast<float>(ui_scale_)
                                     : static_cast<float>(window_.content_scale()) / density;
  const float scale = std::min(wanted, std::max(1.0f, static_cast<float>(width) / kLeastWidth));
  const bool same_size = scale == scale_ && density == density_;
  if (same_size && theme_ == applied_) return;
  apply_theme(theme_, scale);
  applied_ = theme_;
  if (same_size) return;
  const bool first = scale_ == 0;  // the first frame makes the texture
  scale_ = scale;
  density_ = density;
  fonts_ = load_fonts(scale, density);
  if (!first) remake_font_texture();
}

void Gui::begin_frame() {
  follow_scale();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  if (!kQueuesClicks) buttons_.apply(ImGui::GetIO());
  ImGui::NewFrame();
}

void Gui::end_frame() {
  ImGui::Render();
  pressed_.clear();
  for (const Release& release : std::exchange(released_, {})) {
    ImGui_ImplGlfw_KeyCallback(window_.handle(), release.code, release.scancode, GLFW_RELEASE,
                               release.mods);
  }
}

void Gui::key(int code, int scancode, int action, int mods) {
  const bool unseen = std::find(pressed_.begin(), pressed_.end(), code) != pressed_.end();
  if (action == GLFW_RELEASE && unseen) {
    released_.push_back({code, scancode, mods});
    return;
  }
  if (action == GLFW_PRESS) pressed_.push_back(code);
  ImGui_ImplGlfw_KeyCallback(window_.handle(), code, scancode, action, mods);
}

void Gui::mouse_button(int button, int action) {
  if (!kQueuesClicks) buttons_.changed(button, action == GLFW_PRESS, glfwGetTime());
}

void Gui::mouse_moved(double x, double y) {
  buttons_.moved({static_cast<float>(x), static_cast<float>(y)});
}

void Gui::draw() {
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace pupflow::window
