// The user interface's library between window and panels.
#include "app/imgui_layer.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <glad/gl.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <optional>

namespace isoscope {
namespace {

/// Those that go through a pane.
constexpr std::array pane_keys{GLFW_KEY_UP,        GLFW_KEY_DOWN,  GLFW_KEY_LEFT, GLFW_KEY_RIGHT,
                               GLFW_KEY_ENTER,     GLFW_KEY_SPACE, GLFW_KEY_TAB,  GLFW_KEY_PAGE_UP,
                               GLFW_KEY_PAGE_DOWN, GLFW_KEY_HOME,  GLFW_KEY_END};

} // namespace

Result<std::unique_ptr<ImguiLayer>> ImguiLayer::create(Window& window) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  std::unique_ptr<ImguiLayer> layer(new ImguiLayer());
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr; // panes are ours to remember
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NavNoCaptureKeyboard;
  if (!ImGui_ImplGlfw_InitForOpenGL(window.handle(), true) || !ImGui_ImplOpenGL3_Init("#version 410 core"))
    return Error{ErrorCode::device, "The user interface cannot use this OpenGL context.",
                 "Update the graphics driver."};
  return layer;
}

ImguiLayer::~ImguiLayer() {
  if (ImGui::GetIO().BackendRendererUserData) ImGui_ImplOpenGL3_Shutdown();
  if (ImGui::GetIO().BackendPlatformUserData) ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

Status ImguiLayer::prepare(float scale, ThemeKind theme) {
  if (scale == scale_ && theme == theme_) return {};
  if (scale != scale_) {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    const auto fonts = load_fonts(*ImGui::GetIO().Fonts, scale);
    if (!fonts) return fonts.error();
    fonts_ = *fonts;
    ImGui::GetIO().FontDefault = fonts_.ui;
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }
  scale_ = scale;
  theme_ = theme;
  apply_style(ImGui::GetStyle(), theme, scale);
  return {};
}

void ImguiLayer::press(int key) {
  if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) key = GLFW_KEY_SPACE; // which presses buttons too
  if (std::find(pane_keys.begin(), pane_keys.end(), key) != pane_keys.end()) presses_.push_back(key);
}

void ImguiLayer::hold_keys() {
  ImGuiIO& io = ImGui::GetIO();
  std::optional<int> held;
  if (!pressed_ && !presses_.empty()) {
    held = presses_.front();
    presses_.pop_front();
  }
  pressed_ = held.has_value();
  for (const int key : pane_keys) io.KeysDown[key] = held == key;
}

void ImguiLayer::begin_frame(const MouseStep* mouse, double step, bool keys_in_pane) {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGuiIO& io = ImGui::GetIO();
  // Arrows and Enter go through open menus and the pane that has the keys; else they are the window's own.
  if (keys_in_pane || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  else
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
  if (keys_in_pane && !io.WantTextInput)
    hold_keys();
  else
    presses_.clear(), pressed_ = false;
  if (step >= 0) io.DeltaTime = static_cast<float>(std::max(step, 1e-4));
  if (mouse != nullptr) {
    io.MousePos = {mouse->x, mouse->y};
    for (bool& down : io.MouseDown) down = false;
    if (mouse->button >= 0 && mouse->button < 3) io.MouseDown[mouse->button] = mouse->down;
    io.MouseWheel = mouse->wheel;
    io.KeyShift = mouse->shift;
    io.KeyCtrl = mouse->control;
    io.KeyMods = (mouse->shift ? ImGuiKeyModFlags_Shift : 0) | (mouse->control ? ImGuiKeyModFlags_Ctrl : 0);
  }
  ImGui::NewFrame();
}

void ImguiLayer::end_frame() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

std::uint32_t make_texture(int width, int height, const std::uint8_t* rgba) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  return name;
}

} // namespace isoscope
