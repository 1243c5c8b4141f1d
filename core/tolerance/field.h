// The field φ behind Ω = {φ <= δ}: all that the algorithm asks of an input, whatever it is (core/README.md,
// D9).
#pragma once

#include "base/geometry.h"
#include "base/ids.h"
#include "base/run_control.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace isoscope {

class ClosestPointIndex;

/// What a field says at some query: φ, and the site that gives it. `triangle` is the site's number (a
/// triangle of a surface, a point with its weight, a cell of a grid); invalid when nothing lay within the
/// search radius.
struct ClosestPoint {
  /// Where φ would be 0, went on along its gradient: p - φ ∇φ / |∇φ|. The closest point, where φ is a
  /// distance; p itself, where φ is flat.
  Vec3 point;
  double squared_distance = std::numeric_limits<double>::infinity(); ///< φ²; φ is never negative
  TriangleId triangle;

  double distance() const { return std::sqrt(squared_distance); }
};

/// All sites that may give φ within some radius of a centre: answers queries near it by looking at a few.
struct TriangleNeighborhood {
  struct Entry {
    double distance; ///< φ of the centre, as this site gives it
    Vec3 direction;  ///< to the centre, of length at most 1: φ grows by at least its product with a step
    std::uint32_t slot;
  };
  Vec3 center;
  double radius = 0;          ///< complete up to here; 0 when there are too many sites to list
  std::vector<Entry> entries; ///< ascending by distance
};

/// What a field is made of.
enum class FieldKind : std::uint8_t {
  triangles, ///< d, the distance to a triangle soup
  points,    ///< the witnessed k-distance of points: √(|x - b|² + w), least over weighted points
  surfaces, ///< Ω lies between given surfaces: δ less the distance to them inside of Ω, δ plus it outside
  grid      ///< Ω is where a function given on a grid lies between two levels
};

/// The components of {φ <= r} by site.
struct VolumeComponents {
  static constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> of_triangle; ///< by site; none for sites that give no point with φ <= r
  std::size_t count = 0;
};

/// φ with φ >= 0 and |φ(p) - φ(q)| <= |p - q|. Const and thread-safe; answers depend on the query and the
/// field only.
class ToleranceField {
 public:
  virtual ~ToleranceField() = default;
  virtual FieldKind kind() const = 0;
  /// The number of sites; site ids are below it.
  virtual std::size_t size() const = 0;
  bool empty() const { return size() == 0; }
  /// A box outside of which φ exceeds δ.
  virtual const Box3& bounds() const = 0;
  /// About the area of the surface that Ω surrounds: what the numbers of cells and samples go with.
  virtual double area() const = 0;
  virtual std::size_t memory_bytes() const = 0;

  /// φ at p.
  virtual ClosestPoint closest(Vec3 p) const = 0;
  double distance(Vec3 p) const { return closest(p).distance(); }
  /// The same where φ is at most some radius; elsewhere its site may be invalid and φ infinite.
  virtual ClosestPoint closest_within(Vec3 p, double radius) const {
    static_cast<void>(radius);
    return closest(p);
  }
  /// The same, starting from a guess that is likely the site, or from an invalid one: a faster query.
  virtual ClosestPoint closest_near(Vec3 p, TriangleId guess) const = 0;
  /// The same, starting from what some site gives at p. Once a φ below `enough` is found it may be returned.
  virtual ClosestPoint closest_near(Vec3 p, const ClosestPoint& found, double enough) const {
    static_cast<void>(enough);
    return closest_near(p, found.triangle);
  }
  /// Fills `near` with the sites that may give a φ of at most `radius` at `center`; leaves it unusable, which
  /// makes its queries slower but not wrong, where they are many.
  virtual void find_neighborhood(Vec3 center, double radius, TriangleNeighborhood& near) const {
    static_cast<void>(radius);
    near.center = center;
    near.radius = 0;
    near.entries.clear();
  }
  /// The same as closest_near for any p; fast where φ(p) + |p - near.center| <= near.radius. Where φ(p) is
  /// below `enough`, any site that gives less than that may be returned.
  virtual ClosestPoint closest_near(Vec3 p, TriangleId guess, const TriangleNeighborhood& near,
                                    double enough = 0) const {
    static_cast<void>(near);
    static_cast<void>(enough);
    return closest_near(p, guess);
  }

  /// φ as one site gives it, where that is an upper bound of φ; else its distance is infinite.
  virtual ClosestPoint at_site(Vec3 p, TriangleId site) const {
    static_cast<void>(p);
    return {{}, std::numeric_limits<double>::infinity(), site};
  }
  /// An upper bound of φ on a triangle from one site, where what it gives is convex; else infinite.
  virtual double convex_bound(const Triangle3& facet, TriangleId site) const {
    static_cast<void>(facet);
    static_cast<void>(site);
    return std::numeric_limits<double>::infinity();
  }
  /// A point of a site, for those who ask what lies around it.
  virtual Vec3 place_of(TriangleId site) const = 0;
  /// ∇φ at p, whose answer is given: of length at most 1, zero where φ is flat or 0.
  virtual Vec3 gradient(Vec3 p, const ClosestPoint& at) const {
    const double d = at.distance();
    return d > 0 ? (p - at.point) / d : Vec3{};
  }

  /// Whether φ is the distance to its sites: then φ = r at the distance r from `point` of an answer on the
  /// ray through its p, as far as no other site is nearer.
  virtual bool is_distance() const { return false; }
  /// A point with φ = r up to 1e-11 r near p, whose answer is given; nothing where none is found, so that one
  /// has to begin nearer to it.
  virtual std::optional<Vec3> project(Vec3 p, const ClosestPoint& at, double r) const;
  /// The point with φ = r that the answer at p leads to: on the ray where φ is a distance, though another
  /// site may be nearer there, else what project() finds.
  std::optional<Vec3> at_level(Vec3 p, const ClosestPoint& at, double r) const;
  /// Whether φ is nowhere on the way from p to q, which leads along the gradient at p, below φ(p); false
  /// where that cannot be told from both answers.
  virtual bool rises(Vec3 p, const ClosestPoint& at_p, Vec3 q, const ClosestPoint& at_q) const;

  /// What φ is between in a cube; nothing where the field knows no more than that φ is 1-Lipschitz.
  struct Range {
    double least, most;
  };
  virtual std::optional<Range> range_in_cube(Vec3 center, double half_side) const {
    static_cast<void>(center);
    static_cast<void>(half_side);
    return std::nullopt;
  }

  /// Whether a triangle meets φ = δ: false where none of its points does, true where one does, nothing where
  /// the field has no better way to tell than φ itself.
  virtual std::optional<bool> meets_boundary(const Triangle3& facet) const {
    static_cast<void>(facet);
    return std::nullopt;
  }
  /// Whether a point lies in Ω, by exact arithmetic; nothing where the field has none.
  virtual std::optional<bool> holds_exactly(Vec3 p) const {
    static_cast<void>(p);
    return std::nullopt;
  }
  /// The side of a point with φ > 0.9 δ, where the field knows it: -1 inside, +1 outside, else 0.
  virtual int side(Vec3 p) const {
    static_cast<void>(p);
    return 0;
  }
  /// Points of regions outside of Ω that may be too thin to be found; empty where the field knows none.
  virtual std::vector<Vec3> region_seeds() const { return {}; }
  /// The components of {φ <= r}. Of no use once the control is cancelled.
  virtual VolumeComponents components(double r, const RunControl& control) const = 0;

  /// The triangles, where φ is the distance to them; else null: what asks for normals, crossings or parity
  /// needs them.
  virtual const ClosestPointIndex* surface() const { return nullptr; }
};

} // namespace isoscope
