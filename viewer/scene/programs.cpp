// All shader programs of the scene.
#include "scene/programs.h"

namespace isoscope {

Status build_programs(const gl::ShaderSource& source, std::span<const ProgramEntry> entries) {
  for (const ProgramEntry& entry : entries) {
    const auto vertex = source.load(entry.vertex);
    if (!vertex) return vertex.error();
    const auto fragment = source.load(entry.fragment);
    if (!fragment) return fragment.error();
    auto program = gl::Program::build(entry.name, *vertex, *fragment);
    if (!program) return program.error();
    entry.program = std::move(*program);
  }
  return {};
}

Result<Programs> Programs::build(const gl::ShaderSource& source) {
  Programs programs;
  const ProgramEntry entries[] = {
      {programs.background, "background", "fullscreen.vert", "background.frag"},
      {programs.mesh_opaque, "mesh_opaque", "mesh.vert", "mesh_opaque.frag"},
      {programs.mesh_translucent, "mesh_translucent", "mesh.vert", "mesh_translucent.frag"},
      {programs.mesh_flat, "mesh_flat", "mesh.vert", "mesh_flat.frag"},
      {programs.line, "line", "line.vert", "line.frag"},
      {programs.marker, "marker", "marker.vert", "marker.frag"},
      {programs.sample, "sample", "sample.vert", "sample.frag"},
      {programs.point, "point", "point.vert", "point.frag"},
      {programs.volume[0], "volume", "fullscreen.vert", "volume.frag"},
      {programs.volume[1], "volume_sided", "fullscreen.vert", "volume_sided.frag"},
      {programs.volume_haze[0], "volume_haze", "fullscreen.vert", "volume_haze.frag"},
      {programs.volume_haze[1], "volume_haze_sided", "fullscreen.vert", "volume_haze_sided.frag"},
      {programs.volume_detail[0], "volume_detail", "fullscreen.vert", "volume_detail.frag"},
      {programs.volume_detail[1], "volume_detail_sided", "fullscreen.vert", "volume_detail_sided.frag"},
      {programs.volume_haze_detail[0], "volume_haze_detail", "fullscreen.vert", "volume_haze_detail.frag"},
      {programs.volume_haze_detail[1], "volume_haze_detail_sided", "fullscreen.vert",
       "volume_haze_detail_sided.frag"},
      {programs.volume_moving[0], "volume_moving", "fullscreen.vert", "volume_moving.frag"},
      {programs.volume_moving[1], "volume_moving_sided", "fullscreen.vert", "volume_moving_sided.frag"},
      {programs.composite, "composite", "fullscreen.vert", "composite.frag"},
      {programs.section, "section", "fullscreen.vert", "section.frag"},
      {programs.section_detail, "section_detail", "fullscreen.vert", "section_detail.frag"},
      {programs.copy, "copy", "fullscreen.vert", "copy.frag"},
  };
  if (const Status built = build_programs(source, entries); !built) return built.error();
  return programs;
}

} // namespace isoscope
