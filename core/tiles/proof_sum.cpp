// Sums, and unions of parts by the vertices they have in common.
#include "tiles/proof_sum.h"

#include "base/point_order.h"
#include "tiles/facet_file.h"

#include <algorithm>
#include <iterator>

namespace isoscope {
namespace {

/// How many different ones there are.
std::size_t count_facets(std::vector<Triangle3>& facets) {
  std::sort(facets.begin(), facets.end(), comes_before);
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  return facets.size();
}

template <class T> void append_to(std::vector<T>& all, std::vector<T>&& more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

} // namespace

void ProofSum::add(TileProof&& proof) {
  TileSurface& surface = proof.surface;
  closed_manifold_ = closed_manifold_ && surface.closed_manifold;
  oriented_ = oriented_ && surface.oriented;
  if (failures_.empty()) failures_ = std::move(surface.failures);
  euler_characteristic_ += surface.euler_characteristic;
  vertices_ += surface.vertices;
  facets_ += surface.facets;
  parts_.add(surface);
  if (surface.intersections > 0 && (!intersection_ || lies_before(surface.intersection, *intersection_)))
    intersection_ = surface.intersection;
  intersections_ += surface.intersections;
  containment_.max_distance = std::max(containment_.max_distance, proof.containment.max_distance);
  if (proof.containment.worst > containment_.worst) {
    containment_.worst = proof.containment.worst;
    containment_.where = proof.containment.where;
  }
  append_to(outside_, std::move(proof.outside));
  append_to(undecided_, std::move(proof.undecided));
  if (proof.input_distance.lower > input_distance_.lower) {
    input_distance_.lower = proof.input_distance.lower;
    input_distance_.farthest = proof.input_distance.farthest;
  }
  input_distance_.upper = std::max(input_distance_.upper, proof.input_distance.upper);
  using Cover = Coverage::Verdict;
  if (proof.coverage.verdict == Cover::uncovered || coverage_.verdict == Cover::covered)
    coverage_.verdict = proof.coverage.verdict;
  coverage_.count += proof.coverage.count;
  append_to(coverage_.places, std::move(proof.coverage.places));
  std::stable_sort(coverage_.places.begin(), coverage_.places.end(),
                   [](const auto& a, const auto& b) { return a.distance > b.distance; });
  if (coverage_.places.size() > most_uncovered_places) coverage_.places.resize(most_uncovered_places);
  append_to(points_, std::move(proof.witnesses));
  append_to(normals_, std::move(proof.normals));
}

Status ProofSum::count_sides(const TileFolder& folder, const RunControl& control) {
  parts_.join();
  RayWinding around_z(points_), around_input(points_);
  SparsePoll poll(control);
  const auto count = [&](RayWinding& around) {
    return [&](const Triangle3& f) {
      if (!poll.cancelled()) around.add(f);
    };
  };
  if (Status read = folder.each_facet_before(plan_.round, count(around_z)); !read) return read;
  if (Status read = folder.each_input_triangle(count(around_input)); !read) return read;
  if (poll.cancelled()) return Error{ErrorCode::cancelled, "The proof was stopped.", "Join the tiles again."};
  const std::vector<int> of_z = around_z.windings(), of_input = around_input.windings();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    witnesses_.push_back({points_[i], of_input[i] == 1 ? -1 : +1, 0});
    winding_.push_back(of_z[i]);
  }
  return {};
}

Certificate ProofSum::certificate(const ExpectedTopology& expected, double delta) {
  Certificate c;
  c.failures = failures_;
  c.closed_manifold = c.manifold = closed_manifold_ && facets_ > 0;
  c.oriented = oriented_ && facets_ > 0;
  c.euler_characteristic = euler_characteristic_;
  c.components = parts_.components().size();
  if (facets_ == 0) {
    c.failures.emplace_back("The mesh is empty.");
    return c;
  }
  if (c.manifold && c.oriented)
    tell_intersections(intersections_, intersection_.value_or(Vec3()), c);
  else
    tell_intersections_untested(c);
  tell_separation(witnesses_, winding_, c);
  containment_.outside = count_facets(outside_);
  // What is outside in one tile and undecided in another is outside.
  std::erase_if(undecided_, [&](const Triangle3& f) {
    return std::binary_search(outside_.begin(), outside_.end(), f, comes_before);
  });
  containment_.undecided = count_facets(undecided_);
  c.within_tolerance = true;
  tell_containment(containment_, true, delta, c);
  c.cover_limit = plan_.cover.limit;
  c.covers = !plan_.cover.measure || !plan_.cover.limit;
  if (plan_.cover.measure) {
    c.input_distance = input_distance_;
    if (plan_.cover.limit) tell_coverage(coverage_, plan_.cover, delta, c);
  }
  tell_topology(expected, c);
  return c;
}

NormalDeviation ProofSum::normals() {
  return deviation_of(std::move(normals_), true, 1);
}

SmallParts ProofSum::small_parts(double size) const {
  SmallParts small;
  for (const SurfacePart& part : parts_.components()) {
    if (part.box.longest_edge() >= size) continue;
    ++small.components;
    small.vertices += part.vertices;
  }
  return small;
}

} // namespace isoscope
