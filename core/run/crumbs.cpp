// The words on crumbs.
#include "run/crumbs.h"

#include "base/numbers.h"

namespace isoscope {

Result<InputWithoutCrumbs> without_crumbs(std::shared_ptr<const TriangleSoup> soup, double limit,
                                          double delta, const RunControl& control) {
  if (limit == 0) return InputWithoutCrumbs{std::move(soup), {}};
  SoupWithoutCrumbs rest = drop_small_components(*soup, limit * delta, control);
  const std::string all = counted(rest.components, "component");
  if (rest.soup.triangles.empty())
    return Error{ErrorCode::bad_input,
                 "--drop-small " + general(limit, 6) + " leaves nothing of the input: it has " + all +
                     ", none with a box of " + general(limit, 6) + " δ.",
                 "Give a smaller number or a smaller tolerance."};
  if (rest.dropped_components == 0) return InputWithoutCrumbs{std::move(soup), {}};
  return InputWithoutCrumbs{std::make_shared<const TriangleSoup>(std::move(rest.soup)),
                            grouped(rest.dropped_components) + " of " + all + " of the input, with " +
                                counted(rest.dropped_triangles, "triangle") + ", " +
                                (rest.dropped_components == 1 ? "is" : "are") + " smaller than " +
                                general(limit, 6) + " δ and left out (--drop-small)."};
}

std::string crumbs_note(const SmallParts& crumbs, std::size_t vertices) {
  if (crumbs.vertices == 0 || crumbs.vertices == vertices) return {};
  return grouped(crumbs.vertices) + " of " + grouped(vertices) + " vertices went to " +
         counted(crumbs.components, "component") + " smaller than " + general(crumb_size, 6) +
         " δ; --drop-small " + general(crumb_size, 6) + " leaves such small parts of the input out.";
}

} // namespace isoscope
