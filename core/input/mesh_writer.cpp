// Writes a mesh to a temporary file beside its target and renames it when every byte is on the disk.
#include "input/file_scanner.h"
#include "input/mesh_io.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

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

Error io_error(const fs::path& file, const std::string& what, int error) {
  const std::string remedy = error == ENOSPC || error == EDQUOT ? "Free some space or write elsewhere."
                             : error == ENOENT                  ? "Make the folder first."
                                                                : "Write to another place.";
  return {ErrorCode::io,
          printable(file.native(), 1000) + ": " + what + " (" +
              std::error_code(error, std::generic_category()).message() + ").",
          remedy};
}

/// A new file beside the target that takes its place on commit and vanishes otherwise.
class PendingFile {
 public:
  /// Fails when nothing can be created beside `target`; a link is followed, so that what it points to is
  /// replaced.
  Status open(const fs::path& target) {
    static std::atomic<unsigned> serial{0};
    std::error_code ignored;
    named_ = target;
    target_ = target;
    if (fs::is_symlink(target, ignored)) {
      const fs::path real = fs::canonical(target, ignored);
      if (!ignored) target_ = real;
    }
    if (fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored))
      return Error{ErrorCode::io, printable(target.native(), 1000) + ": exists and is not a file.",
                   "Choose another name."};
    for (int attempt = 0; attempt < 100 && descriptor_ < 0; ++attempt) {
      // Short, so that a target with the longest possible name can still be written.
      temporary_ = target_.parent_path() /
                   (".isoscope-" + std::to_string(::getpid()) + "-" + std::to_string(serial++) + ".tmp");
      descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST) break;
    }
    if (descriptor_ < 0) return io_error(named_, "cannot be written", errno);
    return {};
  }

  ~PendingFile() {
    if (descriptor_ < 0) return;
    ::close(descriptor_);
    ::unlink(temporary_.c_str());
  }
  PendingFile() = default;
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  void append(const void* data, std::size_t size) {
    buffer_.append(static_cast<const char*>(data), size);
    if (buffer_.size() >= (std::size_t{1} << 18)) flush();
  }
  void append(std::string_view text) { append(text.data(), text.size()); }

  Status commit() {
    flush();
    if (error_ == 0 && ::fsync(descriptor_) != 0) error_ = errno;
    if (error_ == 0) {
      const int result = ::close(descriptor_);
      descriptor_ = -1;
      if (result != 0) error_ = errno;
      if (error_ == 0 && ::rename(temporary_.c_str(), target_.c_str()) != 0) error_ = errno;
      if (error_ != 0) ::unlink(temporary_.c_str());
    }
    if (error_ != 0) return io_error(named_, "cannot be written to its end", error_);
    return {};
  }

 private:
  void flush() {
    std::size_t done = 0;
    while (error_ == 0 && done < buffer_.size()) {
      const ssize_t n = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
      if (n < 0 && errno != EINTR) error_ = errno;
      if (n > 0) done += static_cast<std::size_t>(n);
    }
    buffer_.clear();
  }

  fs::path named_, target_, temporary_;
  int descriptor_ = -1;
  int error_ = 0;
  std::string buffer_;
};

/// The shortest digits that read back as the same double.
std::string digits(double value) {
  std::array<char, 40> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), result.ptr};
}

std::string coordinates(Vec3 p) {
  return digits(p.x) + ' ' + digits(p.y) + ' ' + digits(p.z) + '\n';
}

template <class T> void append_little_endian(PendingFile& out, T value) {
  std::array<char, sizeof(T)> bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  out.append(bytes.data(), bytes.size());
}

void write_off(PendingFile& out, const TriangleMesh& mesh) {
  out.append("OFF\n" + std::to_string(mesh.points.size()) + ' ' + std::to_string(mesh.triangles.size()) +
             " 0\n");
  for (const Vec3 p : mesh.points) out.append(coordinates(p));
  for (const auto& [a, b, c] : mesh.triangles)
    out.append("3 " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n');
}

void write_obj(PendingFile& out, const TriangleMesh& mesh) {
  for (const Vec3 p : mesh.points) out.append("v " + coordinates(p));
  for (const auto& [a, b, c] : mesh.triangles)
    out.append("f " + std::to_string(std::uint64_t{a} + 1) + ' ' + std::to_string(std::uint64_t{b} + 1) +
               ' ' + std::to_string(std::uint64_t{c} + 1) + '\n');
}

void write_ply(PendingFile& out, const TriangleMesh& mesh) {
  out.append("ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.points.size()) +
             "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
             std::to_string(mesh.triangles.size()) +
             "\nproperty list uchar int vertex_indices\nend_header\n");
  for (const Vec3 p : mesh.points)
    for (int i = 0; i < 3; ++i) append_little_endian(out, p[i]);
  for (const auto& t : mesh.triangles) {
    append_little_endian(out, std::uint8_t{3});
    for (const std::uint32_t v : t) append_little_endian(out, v);
  }
}

void write_stl(PendingFile& out, const TriangleMesh& mesh) {
  std::array<char, 80> header{};
  const std::string_view title = "Isoscope binary STL";
  std::copy(title.begin(), title.end(), header.begin());
  out.append(header.data(), header.size());
  append_little_endian(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  const auto append_point = [&](Vec3 p) {
    for (int i = 0; i < 3; ++i) append_little_endian(out, static_cast<float>(p[i]));
  };
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
    append_point(normalized(cross(b - a, c - a)));
    for (const Vec3 p : {a, b, c}) append_point(p);
    append_little_endian(out, std::uint16_t{0});
  }
}

Status check_mesh(const fs::path& file, const TriangleMesh& mesh, Format format) {
  const std::string name = printable(file.native(), 1000);
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t)
      if (v >= mesh.points.size())
        return Error{
            ErrorCode::internal, name + ": a triangle to be written refers to a missing vertex.", {}};
  const double limit =
      format == Format::stl ? double{std::numeric_limits<float>::max()} : std::numeric_limits<double>::max();
  for (const Vec3 p : mesh.points)
    for (int i = 0; i < 3; ++i)
      if (!(std::abs(p[i]) <= limit))
        return Error{ErrorCode::io, name + ": a coordinate is beyond what this format can hold.",
                     "Write OFF instead."};
  return {};
}

} // namespace

Status write_mesh(const fs::path& file, const TriangleMesh& mesh) {
  const Result<Format> format = format_of(file);
  if (!format) return format.error();
  if (Status sound = check_mesh(file, mesh, *format); !sound) return sound;
  PendingFile out;
  if (Status opened = out.open(file); !opened) return opened;
  switch (*format) {
  case Format::off:
    write_off(out, mesh);
    break;
  case Format::obj:
    write_obj(out, mesh);
    break;
  case Format::ply:
    write_ply(out, mesh);
    break;
  case Format::stl:
    write_stl(out, mesh);
    break;
  }
  return out.commit();
}

Status check_writable_mesh(const fs::path& file) {
  const Result<Format> format = format_of(file);
  if (!format) return format.error();
  // Only trying tells: permissions, read-only disks and exhausted inodes all show themselves here.
  PendingFile trial;
  return trial.open(file);
}

} // namespace isoscope
