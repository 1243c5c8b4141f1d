// Points and faces go to scratch files; then the faces are gone through, which mostly name points near to
// those of the one before.
#include "input/mesh_stream.h"

#include "base/scratch_file.h"
#include "input/mesh_readers.h"

#include <array>
#include <optional>

namespace isoscope {
namespace {

class Spool : public PolygonSink {
 public:
  Spool(FileScanner& in, const StreamRoom& room, const std::function<void(const Triangle3&)>& take)
      : in_(in), room_(room), take_(take) {}

  void restart() override {
    points_.emplace(room_.folder);
    faces_.emplace(room_.folder);
  }
  void take_point(Vec3 p) override { points_->append(&p, sizeof p); }
  void take_face(std::span<const std::uint32_t> face) override {
    if (face.size() > 3)
      in_.fail("has faces of more than three corners, which are cut into triangles only where the whole file "
               "fits into memory",
               "Export it as triangles, or give more --tile-memory.", ErrorCode::unsupported);
    if (face.size() < 3) return;
    const Corners corners{face[0], face[1], face[2]};
    faces_->append(&corners, sizeof corners);
  }
  void take_triangle(const Triangle3& t) override {
    Triangle3 plain = t;
    for (Vec3& p : plain)
      for (int i = 0; i < 3; ++i) p[i] += 0.0; // -0 and 0 are one place, as where equal corners are joined
    give(plain);
  }

  StreamedFile finish() {
    StreamedFile file;
    file.points = points_->size() / sizeof(Vec3);
    BlockReader points(*points_, room_.most_bytes), faces(*faces_, 0);
    const std::uint64_t count = faces_->size() / sizeof(Corners);
    for (std::uint64_t i = 0; i < count; ++i) {
      if (i % faces_by_question == 0 && in_.control().cancelled())
        in_.fail("was left while it was read", {}, ErrorCode::cancelled);
      const auto c = faces.record<Corners>(i);
      give({points.record<Vec3>(c[0]), points.record<Vec3>(c[1]), points.record<Vec3>(c[2])});
    }
    for (const ScratchFile* scratch : {&*points_, &*faces_})
      if (const Status kept = scratch->status(); !kept) throw MeshFileFailure{kept.error()};
    file.triangles = triangles_;
    return file;
  }

 private:
  using Corners = std::array<std::uint32_t, 3>;
  static constexpr std::uint64_t faces_by_question = 4096;

  void give(const Triangle3& t) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return;
    ++triangles_;
    take_(t);
  }

  FileScanner& in_;
  const StreamRoom& room_;
  const std::function<void(const Triangle3&)>& take_;
  std::optional<ScratchFile> points_, faces_;
  std::uint64_t triangles_ = 0;
};

} // namespace

Result<StreamedFile> stream_triangles(const std::filesystem::path& file, const StreamRoom& room,
                                      const std::function<void(const Triangle3&)>& take,
                                      const RunControl& control) {
  return scan_file(file, control, "Give more memory.", [&](FileScanner& in) {
    Spool spool(in, room, take);
    read_polygons(in, &spool);
    return spool.finish();
  });
}

} // namespace isoscope
