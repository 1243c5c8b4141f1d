# isoscope_embed(TARGET NAME symbol FILES file...): a static library that carries the files' bytes inside the program.
#
#   isoscope_embed(isoscope_shaders NAME shaders FILES ${PROJECT_SOURCE_DIR}/shaders/mesh.vert shaders/mesh.frag)
#   target_link_libraries(isoscope_scene PRIVATE isoscope_shaders)
#
#   #include "embedded/shaders.h"
#   const EmbeddedFile* file = find_embedded(embedded::shaders(), "mesh.vert");
#   std::string_view source = file->text();      // or file->bytes, a std::span<const std::byte>
#
# A file is known by its name without folder; `name=path` gives it another. Relative paths are the calling list's.
# The bytes are taken in by the assembler (.incbin), so megabytes cost no compile time, and a changed file is taken in
# anew by the next build. Each file's bytes are followed by a zero that is not counted.
set(ISOSCOPE_EMBED_DIR ${CMAKE_CURRENT_LIST_DIR}/embed)

function(isoscope_embed target)
  cmake_parse_arguments(ARG "" "NAME" "FILES" ${ARGN})
  set(dir ${CMAKE_BINARY_DIR}/embedded/${ARG_NAME})
  set(paths "")
  set(blobs "")
  set(symbols "")
  set(entries "")
  set(index 0)
  foreach(entry IN LISTS ARG_FILES)
    if(entry MATCHES "^([^=/]+)=(.+)$")
      set(name "${CMAKE_MATCH_1}")
      set(path "${CMAKE_MATCH_2}")
    else()
      get_filename_component(name "${entry}" NAME)
      set(path "${entry}")
    endif()
    get_filename_component(path "${path}" ABSOLUTE BASE_DIR ${CMAKE_CURRENT_SOURCE_DIR})
    if(NOT EXISTS "${path}")
      message(FATAL_ERROR "isoscope_embed(${target}): there is no file ${path}")
    endif()
    list(APPEND paths "${path}")
    set(symbol isoscope_embedded_${ARG_NAME}_${index})
    string(APPEND blobs "  .hidden ${symbol}\n  .global ${symbol}\n  .balign 16\n${symbol}:\n"
      "  .incbin \"${path}\"\n"
      "  .hidden ${symbol}_end\n  .global ${symbol}_end\n${symbol}_end:\n  .byte 0\n")
    string(APPEND symbols "extern const std::byte ${symbol}[];\nextern const std::byte ${symbol}_end[];\n")
    string(APPEND entries "      EmbeddedFile{\"${name}\", {${symbol}, ${symbol}_end}},\n")
    math(EXPR index "${index} + 1")
  endforeach()

  file(CONFIGURE OUTPUT ${dir}/embedded/${ARG_NAME}.h @ONLY CONTENT
"// The files embedded under the name @ARG_NAME@; written by isoscope_embed.
#pragma once
#include \"embedded_file.h\"
namespace isoscope::embedded {
std::span<const EmbeddedFile> @ARG_NAME@();
} // namespace isoscope::embedded
")
  file(CONFIGURE OUTPUT ${dir}/${ARG_NAME}.cpp @ONLY CONTENT
"// The bytes of the files embedded under the name @ARG_NAME@; written by isoscope_embed.
#include \"embedded/@ARG_NAME@.h\"
#include <array>
asm(R\"asm(
  .pushsection .rodata
@blobs@  .popsection
)asm\");
extern \"C\" {
@symbols@}
namespace isoscope::embedded {
std::span<const EmbeddedFile> @ARG_NAME@() {
  static const std::array<EmbeddedFile, @index@> files = {
@entries@  };
  return files;
}
} // namespace isoscope::embedded
")
  set_source_files_properties(${dir}/${ARG_NAME}.cpp PROPERTIES OBJECT_DEPENDS "${paths}")
  add_library(${target} STATIC ${dir}/${ARG_NAME}.cpp)
  # ccache does not see what the assembler takes in, and would give back the object of older files.
  # A unity file would not know what its parts depend on, and keep the bytes of older files.
  set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "" UNITY_BUILD OFF)
  target_include_directories(${target} PUBLIC ${dir} ${ISOSCOPE_EMBED_DIR})
  target_link_libraries(${target} PRIVATE isoscope_options)
endfunction()
