// All shader programs of the scene.
#include "scene/programs.h"

namespace isoscope {

Result<Programs> Programs::build(const gl::ShaderSource& source) {
  struct Entry {
    gl::Program Programs::*member;
    const char *name, *vertex, *fragment;
  };
  const Entry entries[] = {
      {&Programs::background, "background", "fullscreen.vert", "background.frag"},
      {&Programs::mesh_opaque, "mesh_opaque", "mesh.vert", "mesh_opaque.frag"},
      {&Programs::mesh_translucent, "mesh_translucent", "mesh.vert", "mesh_translucent.frag"},
      {&Programs::mesh_flat, "mesh_flat", "mesh.vert", "mesh_flat.frag"},
      {&Programs::line, "line", "line.vert", "line.frag"},
      {&Programs::marker, "marker", "marker.vert", "marker.frag"},
      {&Programs::sample, "sample", "sample.vert", "sample.frag"},
      {&Programs::point, "point", "point.vert", "point.frag"},
      {&Programs::volume, "volume", "fullscreen.vert", "volume.frag"},
      {&Programs::volume_sided, "volume_sided", "fullscreen.vert", "volume_sided.frag"},
      {&Programs::composite, "composite", "fullscreen.vert", "composite.frag"},
      {&Programs::section, "section", "fullscreen.vert", "section.frag"},
      {&Programs::copy, "copy", "fullscreen.vert", "copy.frag"},
  };
  Programs programs;
  for (const Entry& entry : entries) {
    const auto vertex = source.load(entry.vertex);
    if (!vertex) return vertex.error();
    const auto fragment = source.load(entry.fragment);
    if (!fragment) return fragment.error();
    auto program = gl::Program::build(entry.name, *vertex, *fragment);
    if (!program) return program.error();
    programs.*entry.member = std::move(*program);
  }
  return programs;
}

} // namespace isoscope
