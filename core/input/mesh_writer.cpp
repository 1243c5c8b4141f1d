// Writes a mesh in the format that the name of the file asks for.
#include "base/numbers.h"
#include "base/pending_file.h"
#include "input/file_scanner.h"
#include "input/mesh_io.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace isoscope {

namespace {

namespace fs = std::filesystem;

enum class Format { off, obj, ply, stl };

Result<Format> format_of(const fs::path& file) {
  std::string e = file.extension().string();
  for (char& c : e) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (e == ".off") return Format::off;
  if (e == ".obj") return Format::obj;
  if (e == ".ply") return Format::ply;
  if (e == ".stl") return Format::stl;
  return Error{ErrorCode::usage,
               printable(file.native(), 1000) + ": the name does not say in which format to write.",
               "End it in .off, .obj, .ply or .stl."};
}

std::string coordinates(Vec3 p) {
  return shortest(p.x) + ' ' + shortest(p.y) + ' ' + shortest(p.z) + '\n';
}

template <class T> void append_little_endian(PendingFile& out, T value) {
  std::array<char, sizeof(T)> bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  out.append(bytes.data(), bytes.size());
}

/// The file that is written, and whether all coordinates fit it.
struct MeshFile {
  PendingFile out;
  double limit = std::numeric_limits<double>::max();
  bool fits = true;

  void check(Vec3 p) {
    for (int i = 0; i < 3; ++i) fits = fits && std::abs(p[i]) <= limit;
  }
};

using Corners = std::array<std::uint32_t, 3>;

Status write_off(MeshFile& file, const MeshSource& mesh) {
  PendingFile& out = file.out;
  out.append("OFF\n" + std::to_string(mesh.vertices) + ' ' + std::to_string(mesh.facets) + " 0\n");
  const Status points = mesh.each_point([&](Vec3 p) {
    file.check(p);
    out.append(coordinates(p));
  });
  if (!points) return points;
  return mesh.each_facet([&](const Corners& t, const Triangle3&) {
    out.append("3 " + std::to_string(t[0]) + ' ' + std::to_string(t[1]) + ' ' + std::to_string(t[2]) + '\n');
  });
}

std::string face_line(const Corners& t) {
  return "f " + std::to_string(std::uint64_t{t[0]} + 1) + ' ' + std::to_string(std::uint64_t{t[1]} + 1) +
         ' ' + std::to_string(std::uint64_t{t[2]} + 1) + '\n';
}

/// A group for each two labels, the larger one, which facets are seen from, first.
void write_groups(PendingFile& out, const TriangleMesh& mesh) {
  std::vector<std::size_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto pair = [&](std::size_t i) { return std::pair(-mesh.labels[i].front, -mesh.labels[i].back); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return pair(i) < pair(j); });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t i = order[k];
    if (k == 0 || pair(i) != pair(order[k - 1]))
      out.append("g front_" + std::to_string(mesh.labels[i].front) + "_back_" +
                 std::to_string(mesh.labels[i].back) + '\n');
    out.append(face_line(mesh.triangles[i]));
  }
}

/// `labelled`: the same mesh where it has labels; else null.
Status write_obj(MeshFile& file, const MeshSource& mesh, const TriangleMesh* labelled) {
  const Status points = mesh.each_point([&](Vec3 p) {
    file.check(p);
    file.out.append("v " + coordinates(p));
  });
  if (!points) return points;
  if (labelled == nullptr)
    return mesh.each_facet([&](const Corners& t, const Triangle3&) { file.out.append(face_line(t)); });
  write_groups(file.out, *labelled);
  return {};
}

Status write_ply(MeshFile& file, const MeshSource& mesh, const TriangleMesh* labelled) {
  PendingFile& out = file.out;
  out.append("ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.vertices) +
             "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
             std::to_string(mesh.facets) + "\nproperty list uchar int vertex_indices\n" +
             (labelled == nullptr ? "" : "property char front\nproperty char back\n") + "end_header\n");
  const Status points = mesh.each_point([&](Vec3 p) {
    file.check(p);
    for (int i = 0; i < 3; ++i) append_little_endian(out, p[i]);
  });
  if (!points) return points;
  std::size_t facet = 0;
  return mesh.each_facet([&](const Corners& t, const Triangle3&) {
    append_little_endian(out, std::uint8_t{3});
    for (const std::uint32_t v : t) append_little_endian(out, v);
    if (labelled == nullptr) return;
    append_little_endian(out, labelled->labels[facet].front);
    append_little_endian(out, labelled->labels[facet].back);
    ++facet;
  });
}

Status write_stl(MeshFile& file, const MeshSource& mesh) {
  PendingFile& out = file.out;
  file.limit = double{std::numeric_limits<float>::max()};
  std::array<char, 80> header{};
  const std::string_view title = "Isoscope binary STL";
  std::copy(title.begin(), title.end(), header.begin());
  out.append(header.data(), header.size());
  append_little_endian(out, static_cast<std::uint32_t>(mesh.facets));
  const auto append_point = [&](Vec3 p) {
    for (int i = 0; i < 3; ++i) append_little_endian(out, static_cast<float>(p[i]));
  };
  return mesh.each_facet([&](const Corners&, const Triangle3& t) {
    append_point(normalized(cross(t[1] - t[0], t[2] - t[0])));
    for (const Vec3 p : t) {
      file.check(p);
      append_point(p);
    }
    append_little_endian(out, std::uint16_t{0});
  });
}

Status write_source(const fs::path& file, const MeshSource& source, const TriangleMesh* labelled) {
  const Result<Format> format = format_of(file);
  if (!format) return format.error();
  const std::string name = printable(file.native(), 1000);
  if (source.facets == 0) return Error{ErrorCode::io, name + " is not written: the mesh is empty.", ""};
  MeshFile to;
  if (Status opened = to.out.open(file); !opened) return opened;
  Status written;
  switch (*format) {
  case Format::off:
    written = write_off(to, source);
    break;
  case Format::obj:
    written = write_obj(to, source, labelled);
    break;
  case Format::ply:
    written = write_ply(to, source, labelled);
    break;
  case Format::stl:
    written = write_stl(to, source);
    break;
  }
  if (!written) return written;
  if (!to.fits)
    return Error{ErrorCode::io, name + ": a coordinate is beyond what this format can hold.",
                 "Write OFF instead."};
  return to.out.commit();
}

MeshSource source_of(const TriangleMesh& mesh) {
  MeshSource source;
  source.vertices = mesh.points.size();
  source.facets = mesh.triangles.size();
  source.each_point = [&mesh](const MeshSource::TakePoint& take) {
    for (const Vec3 p : mesh.points) take(p);
    return Status();
  };
  source.each_facet = [&mesh](const MeshSource::TakeFacet& take) {
    for (const auto& t : mesh.triangles) take(t, {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
    return Status();
  };
  return source;
}

} // namespace

Status write_mesh(const fs::path& file, const MeshSource& source) {
  return write_source(file, source, nullptr);
}

Status write_mesh(const fs::path& file, const TriangleMesh& mesh) {
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t)
      if (v >= mesh.points.size())
        return Error{ErrorCode::internal,
                     printable(file.native(), 1000) +
                         ": a triangle to be written refers to a missing vertex.",
                     {}};
  return write_source(file, source_of(mesh), mesh.labels.empty() ? nullptr : &mesh);
}

Status check_writable_mesh(const fs::path& file) {
  const Result<Format> format = format_of(file);
  if (!format) return format.error();
  // Only trying tells: permissions, read-only disks and exhausted inodes all show themselves here.
  PendingFile trial;
  return trial.open(file);
}

} // namespace isoscope
