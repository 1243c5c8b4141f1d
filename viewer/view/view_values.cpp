// Each bound to its place.
#include "view/view.h"

#include "model/words.h"
#include "scene/view_fields.h"
#include "scene/volume_look.h"

#include <array>
#include <sstream>

namespace isoscope {
namespace {

Status set_normal(WindowState& m, const std::string& text) {
  Vec3 normal;
  if (text.size() == 1 && text[0] >= 'x' && text[0] <= 'z') {
    normal[text[0] - 'x'] = 1;
  } else {
    std::istringstream parts(text);
    std::string part;
    int count = 0;
    for (; std::getline(parts, part, ','); ++count) {
      const auto number = read_number(part);
      if (!number || count > 2) return wrong_value(text, "x, y, z or three numbers");
      normal[count] = *number;
    }
    if (count != 3 || squared_length(normal) == 0) return wrong_value(text, "x, y, z or three numbers");
  }
  m.view.clip.normal = normalized(normal);
  return {};
}

Status set_look(WindowState& m, const std::string& name) {
  for (const VolumeLook& look : volume_looks)
    if (look.name == name) {
      apply(look, m.view);
      return {};
    }
  return wrong_value(name, "shell, fog, inner or thickness");
}

Status set_memory(WindowState& m, const std::string& text) {
  const auto megabytes = read_number(text);
  if (!megabytes || *megabytes < 1 || *megabytes > 16384) return wrong_value(text, "1 to 16384");
  m.grid.allow(static_cast<std::size_t>(*megabytes * (1 << 20)));
  return {};
}

} // namespace

void add_view_values(NamedValues& t, WindowState& m) {
  for (const LayerName& layer : layer_names()) {
    const std::string name = "layer." + std::string(layer.name);
    LayerSettings& settings = m.view.*layer.member;
    t.bind(name, std::string(layer.title) + " shown", {}, settings.visible);
    t.bind(name + ".opacity", std::string(layer.title) + ", opacity", field_of(&LayerSettings::opacity),
           settings.opacity);
  }
  t.bind_fields(m.view);
  t.bind_fields(m.view.tets);
  t.bind_fields(m.view.clip);
  t.add(
      "omega.look", "how Ω is drawn: shell, fog, inner, thickness, or own where set otherwise",
      [&m] {
        const VolumeLook* look = look_of(m.view);
        return look ? std::string(look->name) : std::string("own");
      },
      [&m](const std::string& text) { return set_look(m, text); });
  const auto grid = t.readings("omega.", [&m] { return m.grid.grid(); });
  grid("voxels", "voxels across Ω", [](const DistanceGrid& g) { return 2 * g.delta / g.voxel; });
  grid("bricks", "bricks of the grid of Ω", [](const DistanceGrid& g) { return g.bricks(); });
  grid("megabytes", "texture memory that Ω takes, MiB",
       [](const DistanceGrid& g) { return static_cast<double>(g.texture_bytes()) / (1 << 20); });
  grid("coarse", "Ω is drawn coarser than wanted", [](const DistanceGrid& g) { return g.coarsened; });
  const auto detail = t.readings("omega.near.", [&m] { return m.grid.detail(); });
  detail("voxels", "voxels across Ω near the camera, where they are finer there",
         [](const DistanceGrid& g) { return 2 * g.delta / g.voxel; });
  detail("megabytes", "texture memory that they take, MiB",
         [](const DistanceGrid& g) { return static_cast<double>(g.texture_bytes()) / (1 << 20); });
  grid("bits", "of a sample in the texture of Ω", [](const DistanceGrid& g) { return 8 * g.sample_bytes; });
  t.add(
      "omega.memory", "texture memory that Ω may take, MiB, 1 to 16384",
      [&m] { return static_cast<double>(m.grid.allowed()) / (1 << 20); },
      [&m](const std::string& text) { return set_memory(m, text); });
  t.add("omega.seconds", "how long the grid of Ω took", [&m] { return m.grid.seconds(); });
  t.bind(
      "stills",
      "frames that are averaged in a picture; where a view rests four times as many if they are quick, fewer "
      "if they would take longer than two seconds",
      {.range = {.low = 1, .high = 256}}, m.stills);
  static constexpr std::array<Choice, 4> targets{{{"automatic"}, {"halfedge"}, {"general"}, {"octree"}}};
  static constexpr std::array<Choice, 2> plotted{{{"steps"}, {"seconds"}}};
  t.bind("xray.target", "which targets the X-ray looks for", {.choices = targets}, m.selection.target);
  t.bind("plots.over", "what plots are drawn over", {.choices = plotted}, m.plot_time);
  const std::array<const char*, 3> axis{"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    const std::string name = axis[static_cast<std::size_t>(i)];
    t.bind("clip." + name, "a point of the clip", {.range = {.low = -1e12, .high = 1e12}},
           m.view.clip.point[i]);
  }
  t.add(
      "clip.normal", "the clip's normal: x, y, z, or three numbers as 1,0.5,0",
      [&m] {
        const Vec3 n = m.view.clip.normal;
        return text_of(n.x) + "," + text_of(n.y) + "," + text_of(n.z);
      },
      [&m](const std::string& text) { return set_normal(m, text); });
  t.add("warnings", "what the user should know of the run, counted", [&m] { return m.warnings().size(); });
  t.add("warnings.shown", "these are shown in full", [&m] { return m.warnings_open; });
  t.add("thickening", "whether Ω is a thickening, so that the topology is guaranteed",
        [&m] { return m.run.scene && !m.no_thickening(); });
  t.bind("ui-scale", "size of the interface", {.range = {.low = 0.5, .high = 4}}, m.settings.ui_scale);
}

} // namespace isoscope
