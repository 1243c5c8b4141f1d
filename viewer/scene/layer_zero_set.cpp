// Z: shaded polygons with their edges.
#include "scene/layers.h"

#include "scene/map_colors.h"
#include "scene/zero_facets.h"

#include <algorithm>
#include <utility>

namespace isoscope {

WallStyle wall_style(LabelPair labels) {
  // What is seen from one side is the wall of what lies behind it; the hatch tells what lies before it.
  const auto side = [](int before, int behind) {
    constexpr float darker = 0.45f;
    const RoomStyle own = room_style(behind), other = room_style(before);
    return WallStyle::Side{own.color, before > 0 ? darker * own.color : other.color, own.hatch};
  };
  return {side(labels.front, labels.back), side(labels.back, labels.front)};
}

void ZeroSetLayer::update(const StateSnapshot& state, Moment moment, const ZeroMap* map, const Clip& clip,
                          const SceneColors& colors, const SceneSpace& space) {
  const ZeroSet& zero = state.zero_set;
  const Color8 tint = color8(colors.zero_set);
  const bool rooms = zero.has_rooms();
  std::vector<std::pair<std::optional<LabelPair>, MeshBuilder>> sheets;
  const auto sheet = [&](std::optional<LabelPair> labels) -> MeshBuilder& {
    const auto found =
        std::find_if(sheets.begin(), sheets.end(), [&](const auto& one) { return one.first == labels; });
    if (found != sheets.end()) return found->second;
    return sheets.emplace_back(labels, MeshBuilder()).second;
  };
  const std::vector<std::uint8_t> is_new =
      moment == Moment::before ? new_polygons(state) : std::vector<std::uint8_t>(zero.polygons.size(), 0);
  for (std::size_t index = 0; index < zero.polygons.size(); ++index) {
    const ZeroSet::Polygon& polygon = zero.polygons[index];
    if (is_new[index] || !shows_polygon(state, polygon, clip)) continue;
    if (map != nullptr && index + 1 < map->begin.size()) {
      MeshBuilder& builder = sheet(std::nullopt);
      for (std::uint32_t i = map->begin[index]; i < map->begin[index + 1]; ++i) {
        const ZeroMap::Piece& piece = map->pieces[i];
        const Triangle3& t = piece.corners;
        builder.triangle(space.local(t[0]), space.local(t[1]), space.local(t[2]),
                         color8(map_color(map_part(*map, piece.value))), piece.edges);
      }
      continue;
    }
    MeshBuilder& builder = sheet(rooms ? std::optional(polygon.labels) : std::nullopt);
    std::array<glm::vec3, 4> p{};
    for (std::size_t i = 0; i < polygon.count; ++i) p[i] = space.local(zero.vertices[polygon.v[i]].position);
    if (polygon.count == 3)
      builder.triangle(p[0], p[1], p[2], tint);
    else
      builder.quad(p, tint);
  }
  if (moment == Moment::before)
    for (const Triangle3& t : state.removed_facets)
      sheet(std::nullopt).triangle(space.local(t[0]), space.local(t[1]), space.local(t[2]), tint);
  sheets_.resize(sheets.size());
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    sheets_[i].walls.reset();
    if (const auto& labels = sheets[i].first) sheets_[i].walls = wall_style(*labels);
    sheets_[i].batch.upload(sheets[i].second);
  }
}

void ZeroSetLayer::draw(gl::Program& program, const ViewFrame& frame) {
  MeshStyle style;
  style.opacity = frame.view.zero_set.opacity;
  if (frame.view.zero_set_edges) {
    style.edge_color = glm::vec4(frame.colors.zero_set_edge, 0.85f);
    style.edge_width = 1.1f * frame.pixel_scale;
  }
  for (Sheet& sheet : sheets_) {
    style.walls = sheet.walls;
    // Of rooms no side is the back.
    style.back_shade = sheet.walls ? 1.0f : 0.5f;
    sheet.batch.draw(program, style);
  }
}

} // namespace isoscope
