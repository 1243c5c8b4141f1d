// The table of the kinds of files that are no meshes this program reads, by their first bytes.
#include "input/foreign_formats.h"

#include "input/file_scanner.h"

#include <algorithm>

namespace isoscope {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view unpack = "Unpack it and give the mesh file in it.";
constexpr std::string_view from_cad =
    "It holds curved surfaces: open it in a CAD program and export a mesh as STL, OBJ, PLY or OFF.";
constexpr std::string_view from_modeller =
    "Open it in a modelling program and export it as OFF, OBJ, PLY or STL.";
constexpr std::string_view from_scanner = "Convert it to PLY or XYZ, as CloudCompare does.";
constexpr std::string_view from_volume =
    "It holds a volume: convert it to NRRD, as 3D Slicer does, and give the levels with it.";
constexpr std::string_view no_mesh = "Give the mesh itself as OFF, OBJ, PLY or STL.";

constexpr ForeignFormat formats[] = {
    {"version https://git-lfs.github.com/spec/"sv, 0, "a pointer of Git LFS, not the model itself",
     "Fetch the model with: git lfs pull"},
    {"\x1f\x8b"sv, 0, "compressed with gzip", "Unpack it with gunzip and give the file in it."},
    {"BZh"sv, 0, "compressed with bzip2", "Unpack it with bunzip2 and give the file in it."},
    {"\xfd"
     "7zXZ\0"sv,
     0, "compressed with xz", "Unpack it with unxz and give the file in it."},
    {"\x28\xb5\x2f\xfd"sv, 0, "compressed with zstd", "Unpack it with unzstd and give the file in it."},
    {"7z\xbc\xaf\x27\x1c"sv, 0, "a 7z archive", unpack},
    {"Rar!\x1a\x07"sv, 0, "a RAR archive", unpack},
    {"ustar"sv, 257, "a tar archive", unpack},
    {"PK\x03\x04"sv, 0, "a zip archive", unpack},
    {"PK\x05\x06"sv, 0, "an empty zip archive", no_mesh},
    {"ISO-10303-21"sv, 0, "a STEP file", from_cad},
    {"**ABCDEFGHIJKLMNOPQRSTUVWXYZ"sv, 0, "a Parasolid file", from_cad},
    {"S      1"sv, 72, "an IGES file", from_cad},
    {"AC10"sv, 0, "a DWG drawing", from_cad},
    {"0\nSECTION"sv, 0, "a DXF drawing", from_modeller},
    {"0\r\nSECTION"sv, 0, "a DXF drawing", from_modeller},
    {"3D Geometry File Format"sv, 0, "a Rhino file", from_modeller},
    {"BLENDER"sv, 0, "a Blender file", from_modeller},
    {"Kaydara FBX"sv, 0, "an FBX file", from_modeller},
    {"; FBX"sv, 0, "an FBX file", from_modeller},
    {"glTF"sv, 0, "a binary glTF file (GLB)", from_modeller},
    {"#VRML"sv, 0, "a VRML file", from_modeller},
    {"# .PCD"sv, 0, "a PCD file of points", from_scanner},
    {"LASF"sv, 0, "a LAS file of points", from_scanner},
    {"ASTM-E57"sv, 0, "an E57 file of points", from_scanner},
    {"# vtk DataFile"sv, 0, "a VTK file", from_modeller},
    {"MeshVersionFormatted"sv, 0, "a Medit mesh", from_modeller},
    {"$MeshFormat"sv, 0, "a Gmsh mesh", from_modeller},
    {"n+1\0"sv, 344, "a NIfTI volume", from_volume},
    {"ni1\0"sv, 344, "a NIfTI header", from_volume},
    {"DICM"sv, 128, "a DICOM image", from_volume},
    {"ObjectType"sv, 0, "a MetaImage header", from_volume},
    {"NDims"sv, 0, "a MetaImage header", from_volume},
    {"MAP "sv, 208, "an MRC volume", from_volume},
    {"II*\0"sv, 0, "a TIFF image", from_volume},
    {"MM\0*"sv, 0, "a TIFF image", from_volume},
    {"\x89HDF\r\n"sv, 0, "an HDF5 file", no_mesh},
    {"<!doctype html"sv, 0, "a web page, not the model it may link to", "Download the file itself."},
    {"<html"sv, 0, "a web page, not the model it may link to", "Download the file itself."},
    {"<?xml"sv, 0, "an XML file (COLLADA, X3D, AMF, SVG or another)", from_modeller},
    {"{"sv, 0, "a JSON file (perhaps glTF)", from_modeller},
    {"%PDF-"sv, 0, "a PDF document", no_mesh},
    {"\x89PNG\r\n"sv, 0, "a PNG picture", no_mesh},
    {"\xff\xd8\xff"sv, 0, "a JPEG picture", no_mesh},
    {"\x7f"
     "ELF"sv,
     0, "a program", no_mesh},
};

constexpr ForeignFormat three_mf = {{}, 0, "a 3MF package", from_modeller};

bool holds(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

} // namespace

const ForeignFormat* foreign_format(std::string_view head) {
  std::string_view text = head; // markers of text may stand behind blank lines
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  for (const ForeignFormat& format : formats) {
    const std::string_view from = format.offset == 0 ? text : head;
    if (from.size() < format.offset + format.marker.size()) continue;
    const std::string_view found = from.substr(format.offset, format.marker.size());
    const bool any_case = format.marker.front() == '<';
    if (any_case ? !same_word(found, format.marker) : found != format.marker) continue;
    // A 3MF package is a zip archive; its first entries tell.
    const bool package = holds(head, "3dmodel.model") || holds(head, "[Content_Types].xml");
    return format.marker.starts_with("PK") && package ? &three_mf : &format;
  }
  return nullptr;
}

} // namespace isoscope
