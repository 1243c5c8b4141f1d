// The key of a picture: the colour bar of what Z is coloured by, and what colours and marks mean.
#pragma once

#include "scene/scene_legend.h"
#include "ui/canvas.h"
#include "ui/ui.h"
#include "view/zero_maps.h"

#include <memory>
#include <string>
#include <vector>

namespace isoscope {

struct SceneKey {
  std::shared_ptr<const ZeroMap> map;
  std::string title, note; ///< of the map; a note where there is none to be drawn
  std::vector<LegendEntry> entries;
  bool empty() const { return !map && note.empty() && entries.empty(); }
};

/// The legend of the state and the settings asked for last: making one looks at every tetrahedron.
class KeptLegend {
 public:
  const std::vector<LegendEntry>& of(const std::shared_ptr<const StateSnapshot>& state,
                                     const ViewSettings& view, const LegendScene& scene);

 private:
  std::weak_ptr<const StateSnapshot> state_;
  ViewSettings view_;
  LegendScene scene_;
  std::vector<LegendEntry> entries_;
};

/// Of a view of the run shown, and of the edge at hand in it, which may be null. The legend only where the
/// view has it switched on.
SceneKey scene_key(const WindowState& window, const ZeroMaps& maps, const ViewSettings& view,
                   const std::shared_ptr<const EdgeXray>& xray, KeptLegend& legend);

/// `unit`: pixels of a unit of the interface. Entries that do not fit into `most_high` are counted instead.
ImVec2 key_size(const Canvas& canvas, const SceneKey& key, float unit, float most_high);
void draw_key(Canvas& canvas, const SceneKey& key, ImVec2 low, float unit, float most_high,
              const Palette& colors);

namespace overlay {

/// In the view's bottom right corner, above the scale bar.
void key(const Ui& ui, const SceneKey& key, ImVec2 low, ImVec2 size);

} // namespace overlay

} // namespace isoscope
