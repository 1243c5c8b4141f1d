# Makes glad::glad: the OpenGL 4.1 core loader, generated into the build tree by the distribution's `glad` tool.
#
# Include <glad/gl.h> and call gladLoadGL(glfwGetProcAddress). Versions 1 and 2 of the tool differ in options and
# header name; with version 1 a small <glad/gl.h> over its <glad/glad.h> offers the same call. Both are told to use
# the specification that they carry, so nothing is downloaded.
find_program(ISOSCOPE_GLAD glad)
mark_as_advanced(ISOSCOPE_GLAD)
isoscope_need(glad "${ISOSCOPE_GLAD}" "${ISOSCOPE_GLAD}" python3-glad)

set(glad_dir ${CMAKE_BINARY_DIR}/third_party/glad)
if(NOT EXISTS ${glad_dir}/done)
  execute_process(
    COMMAND ${ISOSCOPE_GLAD} --api gl:core=4.1 --extensions "" --reproducible --quiet --out-path ${glad_dir} c
    RESULT_VARIABLE glad_status OUTPUT_VARIABLE glad_output ERROR_VARIABLE glad_output)
  if(NOT glad_status EQUAL 0)
    execute_process(
      COMMAND ${ISOSCOPE_GLAD} --api gl=4.1 --profile core --generator c --spec gl --extensions "" --reproducible
              --out-path ${glad_dir}
      RESULT_VARIABLE glad_status OUTPUT_VARIABLE glad_output_1 ERROR_VARIABLE glad_output_1)
    string(APPEND glad_output "\n" "${glad_output_1}")
    if(glad_status EQUAL 0)
      file(WRITE ${glad_dir}/include/glad/gl.h
"// Offers version 2's way of loading over version 1's header.
#pragma once
#include <glad/glad.h>
using GLADloadfunc = void (*(*)(const char*))();
inline int gladLoadGL(GLADloadfunc load) { return gladLoadGLLoader(reinterpret_cast<GLADloadproc>(load)); }
")
    endif()
  endif()
  if(NOT glad_status EQUAL 0)
    message(FATAL_ERROR "${ISOSCOPE_GLAD} could not write the OpenGL loader:\n${glad_output}")
  endif()
  file(TOUCH ${glad_dir}/done)
endif()

if(EXISTS ${glad_dir}/src/gl.c)
  add_library(isoscope_glad STATIC ${glad_dir}/src/gl.c)
else()
  add_library(isoscope_glad STATIC ${glad_dir}/src/glad.c)
endif()
target_include_directories(isoscope_glad SYSTEM PUBLIC ${glad_dir}/include)
target_link_libraries(isoscope_glad PUBLIC ${CMAKE_DL_LIBS})
add_library(glad::glad ALIAS isoscope_glad)
