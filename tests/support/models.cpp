// Unpacks libcgal-demo's archive under a lock.
#include "support/models.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace isoscope {

namespace {

namespace fs = std::filesystem;

/// Holds an exclusive lock on a file while it lives.
class FileLock {
 public:
  explicit FileLock(const fs::path& file)
      : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX);
  }
  ~FileLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int descriptor_;
};

std::string quoted(const fs::path& path) {
  std::string text = "'";
  for (const char c : path.native()) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// The folder with the unpacked meshes, or an empty path.
fs::path meshes_folder() {
  const fs::path parent = fs::path(ISOSCOPE_TEST_DATA_DIR);
  const fs::path ready = parent / "cgal", meshes = ready / "data" / "meshes";
  std::error_code error;
  if (fs::is_directory(meshes, error)) return meshes;
  fs::create_directories(parent, error);
  const FileLock lock(parent / "lock");
  if (fs::is_directory(meshes, error)) return meshes; // another program was faster
  for (const char* package : {"libcgal-dev", "libcgal-demo"}) {
    const fs::path archive = fs::path("/usr/share/doc") / package / "data.tar.gz";
    if (!fs::exists(archive, error)) continue;
    const fs::path partial = parent / "partial";
    fs::remove_all(partial, error);
    fs::create_directories(partial, error);
    const std::string command = "tar -xzf " + quoted(archive) + " -C " + quoted(partial) + " data/meshes";
    if (std::system(command.c_str()) != 0) continue;
    fs::rename(partial, ready, error);
    if (!error) return meshes;
  }
  return {};
}

} // namespace

std::optional<fs::path> demo_model(std::string_view name) {
  const fs::path folder = meshes_folder();
  std::error_code error;
  if (!folder.empty() && fs::exists(folder / name, error)) return folder / name;
  std::printf("skipped: the model %.*s of the package libcgal-demo is not installed\n",
              static_cast<int>(name.size()), name.data());
  return std::nullopt;
}

std::vector<fs::path> demo_models() {
  std::vector<fs::path> files;
  const fs::path folder = meshes_folder();
  if (folder.empty()) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".off" || extension == ".ply" || extension == ".stl") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace isoscope
