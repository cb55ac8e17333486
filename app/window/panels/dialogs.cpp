#include "app/window/panels/dialogs.h"

#include <algorithm>
#include <filesystem>

#include "app/io/text.h"
#include "app/window/imgui_compat.h"
#include "app/window/panels/list_rows.h"

namespace pupflow::window {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPopup = "###dialog";
constexpr float kWidth = 36, kHeight = 30;  // of the file dialog, in lines of text

bool button(const char* label, const char* name, const PanelInput& in) {
  const bool pressed = ImGui::Button(label, {6.5f * ImGui::GetFontSize(), 0});
  in.events.widget(name);
  return pressed;
}

void same_row() {
  ImGui::SameLine();
}

bool is_folder(const std::string& path) {
  std::error_code unknown;
  return fs::is_directory(path, unknown);
}

bool exists(const std::string& path) {
  std::error_code unknown;
  return fs::exists(path, unknown);
}

}  // namespace

void Dialogs::ask_open(const std::string& folder) {
  begin_file(Shown::open, folder, "");
}

void Dialogs::ask_save(const std::string& folder, const std::string& name) {
  begin_file(Shown::save, folder, name);
}

void Dialogs::ask_keep(const std::string& scene, const std::string& next) {
  shown_ = Shown::keep;
  fresh_ = true;
  accepted_ = false;
  scene_ = scene;
  next_ = next;
}

void Dialogs::begin_file(Shown shown, const std::string& folder, const std::string& name) {
  shown_ = shown;
  fresh_ = true;
  accepted_ = false;
  problem_.clear();
  go_to(folder);
  set_name(name);
}

void Dialogs::go_to(const std::string& folder) {
  list_ = list_files(folder, shown_ == Shown::save);
  set_name("");
}

void Dialogs::set_name(const std::string& name) {
  const std::size_t size = std::min(name.size(), name_.size() - 1);
  std::copy_n(name.begin(), size, name_.begin());
  name_[size] = '\0';
}

void Dialogs::refuse(const std::string& reason) {
  problem_ = reason;
}

std::optional<Dialogs::Answer> Dialogs::draw(const PanelInput& in) {
  if (fresh_) ImGui::OpenPopup(kPopup);
  if (!shown() && !ImGui::IsPopupOpen(kPopup)) return {};
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  const bool keeps = shown_ == Shown::keep;
  if (!keeps) {
    ImGui::SetNextWindowSize(
        {std::min(kWidth * em, window.x - em), std::min(kHeight * em, window.y - em)});
  }
  const std::string title = (keeps                   ? "Unsaved changes"
                             : shown_ == Shown::open ? "Open"
                                                     : "Save as") +
                            std::string(kPopup);
  const ImGuiWindowFlags flags = ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                 (keeps ? ImGuiWindowFlags_AlwaysAutoResize : 0);
  if (!ImGui::BeginPopupModal(title.c_str(), nullptr, flags)) return {};
  std::optional<Answer> answer;
  if (shown()) answer = keeps ? draw_keep(in) : draw_file(in);
  fresh_ = accepted_ = false;
  if (!shown()) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return answer;
}

std::optional<Dialogs::Answer> Dialogs::draw_keep(const PanelInput& in) {
  const float em = ImGui::GetFontSize();
  ImGui::PushTextWrapPos(std::min(24 * em, ImGui::GetIO().DisplaySize.x - 3 * em));
  ImGui::TextUnformatted(
      ("Save the changes of " + io::quoted(scene_) + " before " + next_ + "?").c_str());
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  std::optional<Answer> answer;
  if (button("Save", "dialog-save", in) || accepted_) answer = Answer{Answer::Kind::save, {}};
  same_row();
  if (button("Discard", "dialog-discard", in)) answer = Answer{Answer::Kind::discard, {}};
  same_row();
  if (button("Cancel", "dialog-cancel", in) || answer) cancel();
  return answer;
}

std::optional<Dialogs::Answer> Dialogs::draw_file(const PanelInput& in) {
  if (ImGui::Button("Up")) go_to(fs::path(list_.folder).parent_path().string());
  in.events.widget("dialog-up");
  same_row();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", io::printable(list_.folder).c_str());
  const float row = ImGui::GetFrameHeightWithSpacing();
  const float below = 2 * row + ImGui::GetTextLineHeightWithSpacing();
  bool picked = draw_list(in, std::max(ImGui::GetContentRegionAvail().y - below, row));

  if (fresh_) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  picked |=
      ImGui::InputText("##name", name_.data(), name_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  in.events.widget("dialog-name");
  const std::string& problem = problem_.empty() ? list_.problem : problem_;
  problem_line(problem);
  if (!problem.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", problem.c_str());

  const std::string path = path_from(list_.folder, name_.data());
  const bool replaces = shown_ == Shown::save && name_[0] != '\0' && exists(path);
  const char* const label = shown_ == Shown::open ? "Open" : replaces ? "Replace" : "Save";
  picked |= button((std::string(label) + "###accept").c_str(), "dialog-accept", in);
  same_row();
  if (button("Cancel", "dialog-cancel", in)) {
    cancel();
    return {};
  }
  return picked ? take_name() : std::nullopt;
}

/// Whether a file was chosen by a double click.
bool Dialogs::draw_list(const PanelInput& in, float height) {
  bool chosen = false;
  std::string folder;
  ImGui::BeginChild("files", {0, height}, true);
  list_rows([&] {
    for (const FileList::Entry& entry : list_.entries) {
      const std::string label = entry.folder ? entry.name + "/" : entry.name;
      const bool is_it = entry.name == name_.data();
      if (ImGui::Selectable(label.c_str(), is_it,
                            ImGuiSelectableFlags_AllowDoubleClick | kKeepsPopups)) {
        problem_.clear();
        set_name(entry.name);
        const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
        if (twice && entry.folder) folder = (fs::path(list_.folder) / entry.name).string();
        chosen |= twice && !entry.folder;
      }
      in.events.widget("file-" + entry.name);
    }
  });
  if (list_.entries.empty()) ImGui::TextDisabled("nothing here that can be opened");
  ImGui::EndChild();
  if (!folder.empty()) go_to(folder);
  return chosen;
}

/// A folder is gone to; a file is the answer, and the dialog stays until `cancel`.
std::optional<Dialogs::Answer> Dialogs::take_name() {
  problem_.clear();
  if (name_[0] == '\0') {
    problem_ = "Pick a file, or type its name.";
    return {};
  }
  const std::string path = path_from(list_.folder, name_.data());
  if (is_folder(path)) {
    go_to(path);
    return {};
  }
  return Answer{shown_ == Shown::open ? Answer::Kind::open : Answer::Kind::save_as, path};
}

}  // namespace pupflow::window
