// Reading folders, and what is chosen in them.
#include "steering/file_browser.h"

#include "input/mesh_format.h"
#include "model/words.h"
#include "tiles/tile_folder.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <system_error>

namespace isoscope {
namespace {

std::string title(const WindowState& m) {
  switch (m.files_for) {
  case FilesFor::beside:
    return "Open beside";
  case FilesFor::between:
    return m.first_wall.empty()
               ? "Ω between two surfaces: the first"
               : "Ω between " + std::filesystem::path(m.first_wall).filename().string() + " and";
  case FilesFor::open:
    break;
  }
  return "Open";
}

namespace fs = std::filesystem;
constexpr std::size_t entry_limit = 20000;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// By its name, as one looks through a folder; what it is, its content tells.
bool is_model(const std::string& name, FilesFor wanted) {
  const std::string end = lower(fs::path(name).extension().string());
  if (end == ".off" || end == ".obj" || end == ".ply" || end == ".stl") return true;
  if (wanted == FilesFor::between) return false;
  return is_points_extension(end) || end == ".nrrd" || end == ".nhdr" || end == ".grid" || end == ".json" ||
         end == ".isorun";
}

void store(std::array<char, 1024>& out, const std::string& text) {
  out.fill(0);
  std::memcpy(out.data(), text.data(), std::min(text.size(), out.size() - 1));
}

} // namespace

void FileBrowser::go(const fs::path& folder) {
  std::error_code error;
  std::vector<Entry> found;
  for (fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && it != end && found.size() < entry_limit; it.increment(error)) {
    Entry entry;
    std::error_code ignored;
    entry.name = it->path().filename().string();
    entry.folder = it->is_directory(ignored);
    // A folder of tiles is opened as a whole.
    entry.tiles = entry.folder && wanted_ == FilesFor::open && TileFolder::exists(it->path());
    entry.folder = entry.folder && !entry.tiles;
    if (entry.name.starts_with('.') || (!entry.folder && !entry.tiles && !is_model(entry.name, wanted_)))
      continue;
    if (!entry.folder && !entry.tiles) entry.bytes = it->file_size(ignored);
    found.push_back(std::move(entry));
  }
  trouble_ = error ? folder.string() + " cannot be read: " + error.message() + "." : "";
  if (error) return;
  std::sort(found.begin(), found.end(), [](const Entry& a, const Entry& b) {
    return a.folder != b.folder ? a.folder : lower(a.name) < lower(b.name);
  });
  entries_ = std::move(found);
  folder_ = folder;
  store(path_, folder.string());
  filter_.fill(0);
}

void FileBrowser::sidebar(Ui& ui, float width) {
  ImGui::BeginChild("places", {width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, {0, 0.5f});
  const auto row = [&](const char* glyph, const std::string& name, bool here) {
    return ImGui::Selectable((" " + std::string(glyph) + "   " + name).c_str(), here, 0, {0, ui.px(26)});
  };
  const auto place = [&](const char* glyph, const std::string& name, const fs::path& target) {
    if (row(glyph, name, folder_ == target)) go(target);
  };
  widgets::quiet_text(ui, "Places");
  const char* const home = std::getenv("HOME");
  if (home) place(icon::home, "Home", home);
  std::error_code ignored;
  const fs::path working = fs::current_path(ignored);
  if (!home || working != fs::path(home)) place(icon::folder, "Working folder", working);
  place(icon::disk, "Computer", "/");
  if (wanted_ == FilesFor::open && row(icon::gallery, "Bundled models", false)) ui.commands.post("gallery");
  const auto& recent = ui.window.settings.recent;
  ImGui::Dummy({0, ui.px(8)});
  if (!recent.empty()) widgets::quiet_text(ui, "Recent");
  for (const std::string& file : recent) {
    ImGui::PushID(file.c_str());
    if (row(icon::history, fs::path(file).filename().string(), false)) chosen(ui, file);
    widgets::tip(ui, {}, file);
    ImGui::PopID();
  }
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

void FileBrowser::listing(Ui& ui) {
  ImGui::BeginChild("entries", {0, 0});
  fs::path next;
  const std::string part = lower(filter_.data());
  std::vector<const Entry*> shown;
  for (const Entry& entry : entries_)
    if (lower(entry.name).find(part) != std::string::npos) shown.push_back(&entry);
  constexpr float high = 26;
  widgets::rows_in_sight(shown.size(), ui.px(high), [&](std::size_t i) {
    const Entry& entry = *shown[i];
    widgets::Row row(ui, high);
    const bool pressed = row.button(i);
    const bool first = !entry.folder && wanted_ == FilesFor::between &&
                       (folder_ / entry.name).string() == ui.window.first_wall;
    if (first || row.hovered()) row.ground(first ? ui.colors.accent : ui.colors.hover, first ? 0.18f : 1.0f);
    row.text(ui.fonts.ui, 10, entry.folder ? ui.colors.accent_text : ui.colors.quiet,
             entry.folder  ? icon::folder
             : entry.tiles ? icon::cubes
                           : icon::cube);
    row.fitted(ui.fonts.ui, 36, ui.colors.text, entry.name, row.width - ui.px(140));
    if (!entry.folder) {
      row.width -= ui.px(10);
      row.value(ui.colors.quiet, entry.tiles ? "tiles" : bytes_text(entry.bytes));
    }
    if (pressed && entry.folder) next = folder_ / entry.name;
    if (pressed && !entry.folder) chosen(ui, (folder_ / entry.name).string());
  });
  if (shown.empty())
    widgets::quiet_text(ui,
                        wanted_ == FilesFor::between ? "No surfaces in this folder: OFF, OBJ, PLY or STL."
                                                     : "No models in this folder: surfaces (OFF, OBJ, PLY, "
                                                       "STL), points (XYZ), grids (NRRD), a view as "
                                                       "JSON, or a folder of tiles. A path can be typed "
                                                       "above, and files can be dropped on the window.",
                        true);
  ImGui::EndChild();
  if (!next.empty()) go(next);
}

void FileBrowser::chosen(Ui& ui, const std::string& file) {
  WindowState& m = ui.window;
  const bool first_of_two = m.files_for == FilesFor::open && ImGui::GetIO().KeyCtrl &&
                            is_model(fs::path(file).filename().string(), FilesFor::between);
  if (first_of_two) {
    m.files_for = FilesFor::between;
    m.first_wall = file;
  } else if (m.files_for != FilesFor::between) {
    ui.commands.post(m.files_for == FilesFor::beside ? "open-beside" : "open", {file});
  } else if (m.first_wall.empty() || m.first_wall == file) {
    m.first_wall = m.first_wall.empty() ? file : "";
  } else {
    ui.commands.post("open-between", {m.first_wall, file});
  }
}

void FileBrowser::draw(Ui& ui) {
  WindowState& m = ui.window;
  if (std::exchange(wanted_, m.files_for) != m.files_for && !fresh_) go(folder_);
  if (std::exchange(fresh_, false)) {
    std::error_code ignored;
    go(m.settings.last_folder.empty() ? fs::current_path(ignored) : fs::path(m.settings.last_folder));
    if (folder_.empty()) go("/");
  }
  m.settings.last_folder = folder_.string();
  ImGui::PushFont(ui.fonts.title);
  ImGui::TextUnformatted(title(m).c_str());
  ImGui::PopFont();
  ImGui::SameLine();
  if (wanted_ == FilesFor::open) {
    // On the title's own line of writing.
    ImGui::SetCursorPos(
        {ImGui::GetCursorPosX() + ui.px(10),
         ImGui::GetCursorPosY() + 0.8f * (ui.fonts.title->FontSize - ui.fonts.small->FontSize)});
    widgets::quiet_text(ui, "A click on two surfaces with Ctrl: Ω is what lies between them");
    ImGui::SameLine();
  }
  ImGui::SetCursorPos({ImGui::GetWindowContentRegionMax().x - ui.px(28), ui.px(14)});
  if (widgets::icon_button(ui, "close", icon::close)) ui.commands.post("clear");
  if (widgets::icon_button(ui, "up", icon::level_up, false, folder_.has_parent_path()))
    go(folder_.parent_path());
  widgets::tip(ui, "To the folder above");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ui.px(210));
  if (ImGui::InputTextWithHint("##path", "a path", path_.data(), path_.size(),
                               ImGuiInputTextFlags_EnterReturnsTrue)) {
    std::error_code ignored;
    if (fs::is_directory(path_.data(), ignored) && !TileFolder::exists(path_.data()))
      go(path_.data());
    else
      chosen(ui, path_.data());
  }
  widgets::tip(ui, "Path", "Type a folder or a model and press Enter.");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##filter", (std::string(icon::search) + "  filter").c_str(), filter_.data(),
                           filter_.size());
  if (!trouble_.empty()) ImGui::TextColored(to_vec(ui.colors.warning_text), "%s", trouble_.c_str());
  ImGui::Dummy({0, ui.px(4)});
  sidebar(ui, ui.px(210));
  ImGui::SameLine(0, ui.px(14));
  listing(ui);
}

} // namespace isoscope
