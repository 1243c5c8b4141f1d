# Makes imgui::imgui and stb::stb from the distribution's static libraries.
#
# Debian builds Dear ImGui into one archive that holds the core, every backend and the FreeType font builder;
# the linker takes the members that are used. Headers: "imgui.h", "imgui_freetype.h", "backends/imgui_impl_glfw.h".
# Its archive uses libstb, which also carries the bodies of "stb_image.h" and "stb_image_write.h":
# include them without defining STB_..._IMPLEMENTATION.
find_path(ISOSCOPE_STB_INCLUDE stb_image_write.h PATH_SUFFIXES stb)
find_library(ISOSCOPE_STB_LIBRARY stb)
mark_as_advanced(ISOSCOPE_STB_INCLUDE ISOSCOPE_STB_LIBRARY)
isoscope_need(stb "${ISOSCOPE_STB_LIBRARY}" "${ISOSCOPE_STB_LIBRARY}" libstb-dev)
add_library(stb::stb UNKNOWN IMPORTED)
set_target_properties(stb::stb PROPERTIES
  IMPORTED_LOCATION "${ISOSCOPE_STB_LIBRARY}"
  INTERFACE_INCLUDE_DIRECTORIES "${ISOSCOPE_STB_INCLUDE}"
  INTERFACE_LINK_LIBRARIES m)

find_package(Freetype QUIET)
isoscope_need("FreeType ${FREETYPE_VERSION_STRING}" "${FREETYPE_FOUND}" "${FREETYPE_LIBRARIES}" libfreetype-dev)

find_path(ISOSCOPE_IMGUI_INCLUDE imgui_freetype.h PATH_SUFFIXES imgui)
find_library(ISOSCOPE_IMGUI_LIBRARY imgui)
mark_as_advanced(ISOSCOPE_IMGUI_INCLUDE ISOSCOPE_IMGUI_LIBRARY)
isoscope_need("Dear ImGui" "${ISOSCOPE_IMGUI_LIBRARY}" "${ISOSCOPE_IMGUI_LIBRARY}" libimgui-dev)
add_library(imgui::imgui UNKNOWN IMPORTED)
set_target_properties(imgui::imgui PROPERTIES
  IMPORTED_LOCATION "${ISOSCOPE_IMGUI_LIBRARY}"
  INTERFACE_INCLUDE_DIRECTORIES "${ISOSCOPE_IMGUI_INCLUDE};${ISOSCOPE_IMGUI_INCLUDE}/backends"
  INTERFACE_LINK_LIBRARIES "glfw;Freetype::Freetype;stb::stb;${CMAKE_DL_LIBS}")
