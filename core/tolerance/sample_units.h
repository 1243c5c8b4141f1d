// Neighbouring candidates among which samples are chosen together.
#pragma once

#include "tolerance/sample_candidates.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace isoscope {

/// The candidates of one cube and which of them the points of some reach. Small: a few times σ wide.
class SampleUnit {
 public:
  std::vector<SampleCandidate> cells;

  SampleUnit() = default;
  SampleUnit(std::vector<SampleCandidate> candidates, double sigma);
  const Box3& box() const { return box_; }
  double sigma() const { return sigma_; }      ///< what its cells are covered within
  std::size_t words() const { return words_; } ///< of 64 bits a row

  /// Cells whose points are offered: bit k of the row of offer i says that all of cell k is within σ of it.
  const std::vector<std::uint32_t>& offers() const { return offers_; }
  std::span<const std::uint64_t> row(std::size_t offer) const {
    return {rows_.data() + offer * words_, words_};
  }
  /// The row of any point.
  void find_row(Vec3 p, std::span<std::uint64_t> row) const;

 private:
  double sigma_ = 0;
  Box3 box_;
  Vec3 center_;
  float squared_reach_ = 0;
  std::size_t words_ = 0;
  std::array<std::vector<float>, 4> shapes_; ///< centres relative to center_, and half sides; whole words
  std::vector<std::uint32_t> offers_;
  std::vector<std::uint64_t> rows_;
};

/// Units of consecutive ambiguous main cells of one level, each unit within a cube of at most
/// `widest_unit` times its density. Thread-safe.
class SampleUnitFinder {
 public:
  static constexpr double widest_unit = 4;
  static constexpr double units_by_part = 4; ///< along an axis

  /// `flat_sigma`: of units of flat cells; 0 where all cells have σ.
  SampleUnitFinder(const ToleranceVolume& volume, double sigma, double flat_sigma,
                   const CandidateOptions& options);
  /// Whether two main cells lie in the same cube, so that they belong in one call of find().
  bool together(Regions::CellIndex a, Regions::CellIndex b) const;
  std::vector<SampleUnit> find(std::span<const Regions::CellIndex> main_cells) const;
  /// The same of a part of a main cell.
  std::vector<SampleUnit> find(const CandidateCube& part) const;
  /// The side of the parts that a main cell should be halved into, when it holds so many units that they are
  /// better found part by part; nothing where it does not.
  std::optional<double> part_side() const;

 private:
  /// The cubes that units lie in.
  struct Cubes {
    double sigma;
    double side;
    unsigned shift = 0; ///< main cells by cube and axis, as a power of two, where cubes are the larger ones
  };
  static Cubes cubes(const Regions& octree, double sigma);
  /// Appends the units of candidates in the octree's order.
  void group(const std::vector<SampleCandidate>& list, const Cubes& cubes,
             std::vector<SampleUnit>& units) const;

  const ToleranceVolume& volume_;
  CandidateOptions options_, flat_options_;
  Cubes cubes_;
  std::optional<Cubes> flat_cubes_;
};

} // namespace isoscope
