// Developer's bench: improves a given Z of a model and prints stages, counts and seconds.
#include "base/parallel.h"
#include "improve/improver.h"
#include "input/gallery.h"
#include "input/mesh_io.h"
#include "tolerance/boundary_sampler.h"
#include "tolerance/closest_point.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <map>
#include <string>

using namespace isoscope;

namespace {

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Prints a line whenever the kind of change does.
class Printer : public ImproverObserver {
 public:
  explicit Printer(std::size_t vertices) : vertices_(vertices) {}
  bool accepted(const SurfaceChange& change, const ImproverVerdict& verdict) override {
    if (change.kind != last_) print();
    last_ = change.kind;
    vertices_ -= change.killed_vertices.size();
    ++accepted_;
    moved_ += verdict.moved;
    flipped_ += verdict.flipped;
    sweeps_ += verdict.sweeps.size();
    return true;
  }
  bool rejected(const ImproverVerdict& verdict) override {
    ++rejected_[verdict.reason];
    sweeps_ += verdict.sweeps.size();
    return true;
  }
  void print() {
    std::printf(
        "%8.2f s %8.2f cpu  %-10s vertices %6zu accepted %5zu moved %6zu flipped %5zu sweeps %5zu rejected",
        seconds() - start_, processor_seconds() - processor_start_, std::string(name(last_)).c_str(),
        vertices_, accepted_, moved_, flipped_, sweeps_);
    for (const auto& [reason, count] : rejected_)
      std::printf(" %s %zu", std::string(name(reason)).c_str(), count);
    std::printf("\n");
    std::fflush(stdout);
    accepted_ = moved_ = flipped_ = sweeps_ = 0;
    rejected_.clear();
  }

 private:
  double start_ = seconds(), processor_start_ = processor_seconds();
  EventKind last_ = EventKind::collapse;
  std::size_t vertices_, accepted_ = 0, moved_ = 0, flipped_ = 0, sweeps_ = 0;
  std::map<Reason, std::size_t> rejected_;
};

/// Failed tests of condition 3 and the share of the area whose normal is more than 60 and 90 degrees off.
void print_normals(const TriangleMesh& mesh, const ToleranceVolume& volume, const NearestSample& samples,
                   const ImproverOptions& options) {
  const InputSurface input(volume.index(), volume.thresholds().delta, mesh);
  const OrientationTester tester{&samples, options.shrink, 2.5 * input.delta(), &volume.field(),
                                 input.delta()};
  std::size_t failures = 0, bad_facets = 0;
  double area = 0, off_60 = 0, off_90 = 0;
  for (const auto& f : mesh.triangles) {
    const Triangle3 t{mesh.points[f[0]], mesh.points[f[1]], mesh.points[f[2]]};
    const std::size_t failed = tester.failures(t).size();
    failures += failed;
    bad_facets += failed > 0 ? 1u : 0u;
    const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
    constexpr int n = 12;
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        const Vec3 p = t[0] + ((i + 1. / 3) / n) * (t[1] - t[0]) + ((j + 1. / 3) / n) * (t[2] - t[0]);
        const double cosine = dot(normalized(normal), input.normal(input.sample(p, TriangleId()).triangle));
        const double weight = length(normal) / (n * (n + 1));
        area += weight;
        off_60 += cosine < 0.5 ? weight : 0;
        off_90 += cosine < 0 ? weight : 0;
      }
  }
  std::printf(
      "normals: %zu failed tests in %zu of %zu facets, area off by 60 degrees %.2f %%, by 90 %.2f %%\n",
      failures, bad_facets, mesh.triangles.size(), 100 * off_60 / area, 100 * off_90 / area);
}

int usage() {
  std::fprintf(stderr, "improve_bench MODEL PERCENT START.off OUT.off [effort=2] [normals=1] [threads=2] "
                       "[rounds=0] [seconds=0]\n");
  return 2;
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 5) return usage();
  std::map<std::string, double> given{
      {"effort", 2}, {"normals", 1}, {"threads", 2}, {"rounds", 0}, {"seconds", 0}};
  for (int i = 5; i < argc; ++i) {
    const std::string text = argv[i];
    const auto at = text.find('=');
    if (at == std::string::npos || !given.contains(text.substr(0, at))) return usage();
    given[text.substr(0, at)] = std::stod(text.substr(at + 1));
  }
  const ThreadLimit limit(static_cast<unsigned>(given["threads"]));
  const auto soup = read_mesh(argv[1]);
  const auto start = read_mesh(argv[3]);
  if (!soup || !start) return usage();
  const auto index = std::make_shared<const ClosestPointIndex>(*soup);
  const double delta = std::stod(argv[2]) / 100 * index->bounds().longest_edge();
  RunControl control;
  auto volume = ToleranceVolume::build(index, analyse_input(*soup), {delta, 0.95}, control);
  if (!volume) {
    std::fprintf(stderr, "%s\n", volume.error().line().c_str());
    return 3;
  }
  const auto samples = sample_boundary(*volume, delta / 2, control);
  if (!samples) return 3;
  const NearestSample nearest(samples->positions, samples->labels);
  TriangleMesh mesh{start->points, start->triangles};
  ImproverOptions options;
  options.effort = static_cast<int>(given["effort"]);
  options.rounds_alone = given["rounds"] > 0;
  if (given["seconds"] > 0) control.cancel_after(given["seconds"]);
  options.preserve_normals = given["normals"] > 0;
  Printer printer(mesh.points.size());
  print_normals(mesh, *volume, nearest, options);
  const double begin = seconds(), processor_begin = processor_seconds();
  improve(mesh, *volume, &nearest, options, control, printer);
  printer.print();
  std::printf("END vertices %zu in %.2f s, cpu %.2f s\n", mesh.points.size(), seconds() - begin,
              processor_seconds() - processor_begin);
  print_normals(mesh, *volume, nearest, options);
  const Status written = write_mesh(argv[4], mesh);
  return written ? 0 : 3;
}
