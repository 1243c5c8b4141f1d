// A pending file takes its target's place on commit, whole, and leaves nothing behind otherwise.
#include "base/pending_file.h"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>

#include <unistd.h>

using namespace isoscope;
namespace fs = std::filesystem;

namespace {

/// A folder of its own that vanishes with it.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path(fs::temp_directory_path() / ("isoscope-pending-" + std::to_string(::getpid()) + "-" + name)) {
    fs::create_directories(path);
  }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::ptrdiff_t entries() const {
    return std::distance(fs::directory_iterator(path), fs::directory_iterator());
  }

  fs::path path;
};

void write(const fs::path& file, std::string_view text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

} // namespace

TEST_CASE("a committed file replaces its target and leaves no other behind") {
  const Folder folder("commit");
  const fs::path target = folder.path / "mesh.off";
  write(target, "old");
  const std::string long_text(1u << 20, 'x');
  {
    PendingFile file;
    REQUIRE(file.open(target).ok());
    file.append("new ");
    file.append(long_text);
    CHECK(content(target) == "old");
    CHECK(folder.entries() == 2);
    CHECK(file.commit().ok());
  }
  CHECK(content(target) == "new " + long_text);
  CHECK(folder.entries() == 1);
}

TEST_CASE("what replaces a file can be read and written by those who could before") {
  const Folder folder("mode");
  const fs::path target = folder.path / "mesh.off";
  for (const auto mode : {fs::perms(0640), fs::perms(0600), fs::perms(0664)}) {
    write(target, "old");
    fs::permissions(target, mode);
    PendingFile file;
    REQUIRE(file.open(target).ok());
    file.append("new");
    CHECK(file.commit().ok());
    CHECK(content(target) == "new");
    CHECK(fs::status(target).permissions() == mode);
  }
}

TEST_CASE("a file that is not committed leaves the target alone") {
  const Folder folder("dropped");
  const fs::path target = folder.path / "mesh.off";
  write(target, "old");
  {
    PendingFile file;
    REQUIRE(file.open(target).ok());
    file.append("new");
  }
  CHECK(content(target) == "old");
  CHECK(folder.entries() == 1);
}

TEST_CASE("a link stays a link, and what it points to is replaced") {
  const Folder folder("link");
  const fs::path real = folder.path / "real.off", link = folder.path / "link.off";
  write(real, "old");
  fs::create_symlink(real, link);
  PendingFile file;
  REQUIRE(file.open(link).ok());
  file.append("new");
  CHECK(file.commit().ok());
  CHECK(fs::is_symlink(link));
  CHECK(content(real) == "new");
}

TEST_CASE("a link to what is not there yet makes it") {
  const Folder folder("dangling");
  const fs::path link = folder.path / "link.off", next = folder.path / "next.off";
  fs::create_symlink("next.off", link);
  fs::create_symlink(folder.path / "real.off", next);
  CHECK(behind_links(link) == folder.path / "real.off");
  PendingFile file;
  REQUIRE(file.open(link).ok());
  file.append("new");
  CHECK(file.commit().ok());
  CHECK(fs::is_symlink(link));
  CHECK(fs::is_symlink(next));
  CHECK(content(folder.path / "real.off") == "new");
  // Links in a circle lead nowhere; they are refused, not replaced.
  fs::create_symlink("b.off", folder.path / "a.off");
  fs::create_symlink("a.off", folder.path / "b.off");
  PendingFile circle;
  CHECK(!circle.open(folder.path / "a.off").ok());
  CHECK(fs::is_symlink(folder.path / "a.off"));
}

TEST_CASE("targets that cannot be written are refused with a remedy") {
  const Folder folder("refused");
  PendingFile missing, occupied, device;
  const Status no_folder = missing.open(folder.path / "none" / "mesh.off");
  REQUIRE(!no_folder.ok());
  CHECK(no_folder.error().code == ErrorCode::io);
  CHECK(no_folder.error().line().find("Make the folder first.") != std::string::npos);
  CHECK(!occupied.open(folder.path).ok());
  CHECK(!occupied.open(folder.path, WriteTarget::file_or_device).ok());
  CHECK(!device.open("/dev/null").ok());
  CHECK(folder.entries() == 0);
}

TEST_CASE("a device is written itself where that is allowed") {
  PendingFile file;
  REQUIRE(file.open("/dev/null", WriteTarget::file_or_device).ok());
  file.append("anything");
  CHECK(file.commit().ok());
}

TEST_CASE("bytes that a line cannot show are replaced, and long text is cut") {
  CHECK(printable("plain text") == "plain text");
  CHECK(printable("a\nb\x7f\xc3") == "a?b??");
  CHECK(printable("abcdef", 3) == "abc...");
}
