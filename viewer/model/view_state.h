// A view as text: camera, layers, filter, clip, mode and section, for the clipboard, view files and scripts.
#pragma once

#include "scene/camera.h"
#include "scene/renderer.h"
#include "scene/view_settings.h"

#include <optional>
#include <string>

namespace isoscope {

struct ViewState {
  CameraPose camera;
  ViewSettings view;
  Renderer::SectionView section;
};

/// One JSON object on one line.
std::string to_json(const ViewState& state);
/// Reads what is there over `base`: parts that are absent keep base's values. Nullopt when the text is no
/// view. A bare camera pose is a view too.
std::optional<ViewState> view_from_json(const std::string& text, const ViewState& base);

} // namespace isoscope
