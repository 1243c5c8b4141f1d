// Files of other kinds are named by their first bytes, with what to do.
#include "input/mesh_io.h"
#include "input/temporary_folder.h"

#include <doctest/doctest.h>

#include <string>

using namespace isoscope;

namespace {

struct Foreign {
  std::string bytes, named, remedy;
};

std::string tar() {
  std::string bytes = "part.stl";
  bytes.resize(257, '\0');
  return bytes + std::string("ustar\0", 6) + std::string(800, '\0');
}

std::string zip(const std::string& entry) {
  return std::string("PK\x03\x04\x14\0\0\0\x08\0", 10) + std::string(16, '\x11') +
         std::string(1, static_cast<char>(entry.size())) + std::string(3, '\0') + entry + "\x03\xff\x11\x90";
}

} // namespace

TEST_CASE("other kinds of files are named, whatever their extension claims") {
  const TemporaryFolder folder;
  const std::vector<Foreign> files = {
      {"version https://git-lfs.github.com/spec/v1\noid sha256:0123456789abcdef\nsize 4711\n", "Git LFS",
       "git lfs pull"},
      {std::string("\x1f\x8b\x08\0\0\0\0\0\0\x03\x4b\xcb", 12), "gzip", "gunzip"},
      {"BZh91AY&SY\x01\x02\x03", "bzip2", "bunzip2"},
      {std::string("\xfd"
                   "7zXZ\0\0\x04",
                   8),
       "xz", "unxz"},
      {std::string("\x28\xb5\x2f\xfd\x24\x10", 6), "zstd", "unzstd"},
      {std::string("7z\xbc\xaf\x27\x1c\0\x04", 8), "7z archive", "Unpack"},
      {std::string("Rar!\x1a\x07\x01\0", 8), "RAR archive", "Unpack"},
      {tar(), "tar archive", "Unpack"},
      {zip("part.stl"), "zip archive", "Unpack"},
      {zip("3D/3dmodel.model"), "3MF", "export"},
      {zip("[Content_Types].xml"), "3MF", "export"},
      {"<!DOCTYPE html>\n<html><body>404</body></html>\n", "web page", "Download"},
      {"\n\n  <html lang=\"en\"><head>", "web page", "Download"},
      {"<HTML>", "web page", "Download"},
      {"<?xml version=\"1.0\"?>\n<COLLADA>", "XML", "export"},
      {"ISO-10303-21;\nHEADER;\n", "STEP", "CAD"},
      {"\xef\xbb\xbfISO-10303-21;\r\nHEADER;\r\n", "STEP", "CAD"},
      {"{\n  \"asset\": {\"version\": \"2.0\"}}", "glTF", "export"},
      {std::string("glTF\x02\0\0\0", 8), "GLB", "export"},
      {"%PDF-1.7\n", "PDF", "Give"},
      {std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), "PNG", "Give"},
      {std::string("Kaydara FBX Binary  \0", 21), "FBX", "export"},
      {"BLENDER-v300", "Blender", "export"},
      {"#VRML V2.0 utf8\n", "VRML", "export"},
      {"# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n", "PCD", "Convert"},
      {"LASF\x01\x02", "LAS", "Convert"},
      {std::string("ASTM-E57\x01\0\0\0", 12), "E57", "Convert"},
      {"# vtk DataFile Version 3.0\n", "VTK", "export"},
      {"$MeshFormat\n2.2 0 8\n", "Gmsh", "export"},
      {std::string(72, ' ') + "S      1\n", "IGES", "CAD"},
      {"AC1015\x01", "DWG", "CAD"},
      {"  0\r\nSECTION\r\n  2\r\nHEADER\r\n", "DXF", "export"},
      {"0\nSECTION\n2\nENTITIES\n", "DXF", "export"},
      {std::string("\x5c\x01\0\0", 4) + std::string(340, '\0') + std::string("n+1\0", 4), "NIfTI", "NRRD"},
      {std::string(128, '\0') + "DICM\x02", "DICOM", "NRRD"},
      {"ObjectType = Image\nNDims = 3\n", "MetaImage", "NRRD"},
      {std::string("\x40\0\0\0", 4) + std::string(204, '\0') + "MAP \x44\x44", "MRC", "NRRD"},
      {std::string("II*\0\x08\0\0\0", 8), "TIFF", "NRRD"},
      {"\x89HDF\r\n\x1a\n", "HDF5", "Give"},
  };
  for (const Foreign& foreign : files) {
    CAPTURE(foreign.named);
    for (const char* name : {"a.stl", "a.off", "a.obj", "a.ply", "a"}) {
      const auto file = folder.file(name, foreign.bytes);
      const auto mesh = read_mesh(file);
      REQUIRE_FALSE(mesh.ok());
      CHECK(mesh.error().code == ErrorCode::bad_input);
      CHECK(mesh.error().message.find(file.string()) != std::string::npos);
      CHECK(mesh.error().message.find(foreign.named) != std::string::npos);
      CHECK(mesh.error().remedy.find(foreign.remedy) != std::string::npos);
    }
  }
}

TEST_CASE("a sound binary STL may have any title") {
  const TemporaryFolder folder;
  for (const std::string title : {"PK\x03\x04", "\x1f\x8b", "<html>", "OFF", "ply\n", "BZh", "\xff\xfe"}) {
    std::string bytes = title;
    bytes.resize(80, ' ');
    bytes += std::string("\x01\0\0\0", 4) + std::string(12, '\0');
    const float triangle[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    bytes.append(reinterpret_cast<const char*>(triangle), sizeof triangle);
    bytes += std::string(2, '\0');
    const auto mesh = read_mesh(folder.file("a.stl", bytes));
    CAPTURE(title);
    REQUIRE(mesh.ok());
    CHECK(mesh->triangles.size() == 1);
  }
}
