# Finds everything we link against, from the system alone; the reasons are in third_party/README.md.
#
# Targets for the rest of the build: CGAL::CGAL, TBB::tbb, nlohmann_json::nlohmann_json, CLI11::CLI11,
# nanoflann::nanoflann, SQLite::SQLite3, ZLIB::ZLIB, and MPI::MPI_C where it is there;
# with ISOSCOPE_VIEWER: glfw, X11::X11, imgui::imgui (with its GLFW, OpenGL 3 and FreeType parts), glm::glm, glad::glad, stb::stb;
# with ISOSCOPE_TESTS: doctest::doctest, and meshoptimizer::meshoptimizer where it is there.

# isoscope_need(LABEL FOUND WHERE PACKAGE): logs where a dependency came from, or names the package that brings it.
function(isoscope_need label found where package)
  if(NOT found)
    message(FATAL_ERROR "${label} was not found. On Debian and Ubuntu: apt install ${package} (scripts/run does it).")
  endif()
  message(STATUS "Dependency ${label}: ${where}")
endfunction()

set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)

set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
find_package(CGAL 5.4 QUIET)
isoscope_need("CGAL ${CGAL_VERSION}" "${CGAL_FOUND}" "${CGAL_DIR}" libcgal-dev)
find_package(TBB 2021 QUIET)
isoscope_need("oneTBB ${TBB_VERSION}" "${TBB_FOUND}" "${TBB_DIR}" libtbb-dev)
find_package(nlohmann_json QUIET)
isoscope_need("nlohmann-json ${nlohmann_json_VERSION}" "${nlohmann_json_FOUND}" "${nlohmann_json_DIR}" nlohmann-json3-dev)
find_package(CLI11 QUIET)
isoscope_need("CLI11 ${CLI11_VERSION}" "${CLI11_FOUND}" "${CLI11_DIR}" libcli11-dev)
find_package(nanoflann QUIET)
isoscope_need("nanoflann ${nanoflann_VERSION}" "${nanoflann_FOUND}" "${nanoflann_DIR}" libnanoflann-dev)
find_package(SQLite3 3.37 QUIET)
isoscope_need("SQLite ${SQLite3_VERSION}" "${SQLite3_FOUND}" "${SQLite3_LIBRARIES}" libsqlite3-dev)
find_package(ZLIB QUIET)
isoscope_need("zlib ${ZLIB_VERSION_STRING}" "${ZLIB_FOUND}" "${ZLIB_LIBRARIES}" zlib1g-dev)

if(ISOSCOPE_OPENVDB) # whose own module asks for more than its reader needs
  find_path(OPENVDB_HEADERS openvdb/openvdb.h)
  find_library(OPENVDB_LIBRARY openvdb)
  isoscope_need("OpenVDB" "${OPENVDB_LIBRARY}" "${OPENVDB_LIBRARY}" libopenvdb-dev)
  find_library(OPENVDB_HALF NAMES Imath Imath-3_1 Half) # halves, which its headers read by a table of this library
  set(OPENVDB_LIBRARIES ${OPENVDB_LIBRARY} TBB::tbb)
  if(OPENVDB_HALF)
    list(APPEND OPENVDB_LIBRARIES ${OPENVDB_HALF})
  endif()
  isoscope_need("OpenVDB's headers" "${OPENVDB_HEADERS}" "${OPENVDB_HEADERS}" libopenvdb-dev)
endif()

# isoscope-mpi is built where there is one.
find_package(MPI QUIET COMPONENTS C)
if(MPI_C_FOUND)
  message(STATUS "Dependency MPI ${MPI_C_VERSION}: ${MPI_C_HEADER_DIR}")
  # Of the C++ bindings, which were taken out of the standard, older headers have some.
  set_property(TARGET MPI::MPI_C APPEND PROPERTY INTERFACE_COMPILE_DEFINITIONS OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
else()
  message(STATUS "Dependency MPI: none; isoscope-mpi is not built")
endif()

if(ISOSCOPE_TESTS)
  find_package(doctest QUIET)
  isoscope_need("doctest ${doctest_VERSION}" "${doctest_FOUND}" "${doctest_DIR}" doctest-dev)
  # A peer of the experiments, which not every distribution has.
  find_package(meshoptimizer QUIET)
endif()

if(ISOSCOPE_VIEWER)
  find_package(glfw3 3.3 QUIET)
  isoscope_need("GLFW ${glfw3_VERSION}" "${glfw3_FOUND}" "${glfw3_DIR}" libglfw3-dev)
  # OpenGL is declared by glad alone, whatever the order of includes.
  set_property(TARGET glfw APPEND PROPERTY INTERFACE_COMPILE_DEFINITIONS GLFW_INCLUDE_NONE)

  find_package(X11 QUIET)
  isoscope_need("Xlib" "${X11_FOUND}" "${X11_X11_LIB}" libx11-dev)

  find_package(glm QUIET)
  isoscope_need("GLM ${glm_VERSION}" "${glm_FOUND}" "${glm_DIR}" libglm-dev)
  if(NOT TARGET glm::glm)
    add_library(glm::glm ALIAS glm)
  endif()

  include(${CMAKE_CURRENT_LIST_DIR}/imgui.cmake)
  include(${CMAKE_CURRENT_LIST_DIR}/glad.cmake)
endif()

include(${CMAKE_CURRENT_LIST_DIR}/embed.cmake)
if(ISOSCOPE_VIEWER)
  include(${CMAKE_CURRENT_LIST_DIR}/fonts.cmake)
endif()
