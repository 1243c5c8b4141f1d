// The 2D section as a vector figure, drawn as the paper's figures are.
#pragma once

#include "questions/target_study.h"
#include "scene/input_points.h"
#include "scene/level_loops.h"
#include "scene/renderer.h"
#include "scene/section_geometry.h"
#include "scene/view_settings.h"
#include "tolerance/distance_grid.h"

#include <memory>
#include <string>

namespace isoscope {

struct SectionFigure {
  Renderer::SectionView section; ///< what is visible of the plane
  ViewSettings view;             ///< its layers, plane and size of samples
  double aspect = 4.0 / 3;       ///< width to height of the drawing, without the lines below it
  double width = 160;            ///< of the figure, millimetres
  double delta = 0;              ///< δ, scene units; 0: not known, the scale bar is in scene units then
  std::string model;             ///< named in the caption
  std::shared_ptr<const InputPoints> points = nullptr;  ///< that φ is made of
  std::shared_ptr<const Scene> scene = nullptr;         ///< whose rim is marked, where its input is open
  std::shared_ptr<const StateSnapshot> other = nullptr; ///< of another run: its Z, where that is shown
  std::shared_ptr<const EdgeXray> xray = nullptr;       ///< of the edge at hand
  std::shared_ptr<const TargetStudy> study = nullptr;   ///< of a target of it that is tried
};

/// An SVG 1.1 document: Ω filled, rooms hatched, T thin, Z thick and black, what was cut off it dashed, ∂Γ
/// blue, points of the input by weight, samples by class as disc, circle, cross or, over the rim, diamond,
/// where the rim and the curves of Z cross the plane, the next Steiner point ringed, kernel, Ψ, octree cells
/// and candidates of the edge at hand; a scale bar and a
/// caption with step and parameters below. Coordinates are millimetres; the document says how many scene
/// units one of them is. `grid` may be null.
std::string section_svg(const StateSnapshot& state, const DistanceGrid* grid, const SectionFigure& figure);

/// Signed distance over δ on a lattice over the section of the grid's box; every value on the rim is beyond
/// Ω.
Lattice section_lattice(const DistanceGrid& grid, const SectionPlane& plane);

} // namespace isoscope
