// The words on crumbs.
#include "run/crumbs.h"

#include "base/grouped.h"

#include <cstdio>

namespace isoscope {

namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

} // namespace

Result<InputWithoutCrumbs> without_crumbs(std::shared_ptr<const TriangleSoup> soup, double limit,
                                          double delta, const RunControl& control) {
  if (limit == 0) return InputWithoutCrumbs{std::move(soup), {}};
  SoupWithoutCrumbs rest = drop_small_components(*soup, limit * delta, control);
  const std::string all = grouped(rest.components) + (rest.components == 1 ? " component" : " components");
  if (rest.soup.triangles.empty())
    return Error{ErrorCode::bad_input,
                 "--drop-small " + number(limit) + " leaves nothing of the input: it has " + all +
                     ", none with a box of " + number(limit) + " δ.",
                 "Give a smaller number or a smaller tolerance."};
  if (rest.dropped_components == 0) return InputWithoutCrumbs{std::move(soup), {}};
  return InputWithoutCrumbs{std::make_shared<const TriangleSoup>(std::move(rest.soup)),
                            grouped(rest.dropped_components) + " of " + all + " of the input, with " +
                                grouped(rest.dropped_triangles) +
                                (rest.dropped_triangles == 1 ? " triangle" : " triangles") + ", " +
                                (rest.dropped_components == 1 ? "is" : "are") + " smaller than " +
                                number(limit) + " δ and left out (--drop-small)."};
}

std::string crumbs_note(const SmallParts& crumbs, const TriangleMesh& mesh) {
  if (crumbs.vertices == 0 || crumbs.vertices == mesh.points.size()) return {};
  return grouped(crumbs.vertices) + " of " + grouped(mesh.points.size()) + " vertices went to " +
         grouped(crumbs.components) + (crumbs.components == 1 ? " component" : " components") +
         " smaller than " + number(crumb_size) + " δ; --drop-small " + number(crumb_size) +
         " leaves such small parts of the input out.";
}

} // namespace isoscope
