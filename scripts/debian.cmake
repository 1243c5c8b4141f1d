# The Debian package of the programs: cpack in the build folder makes it; scripts/deb builds and does that.
set(ISOSCOPE_MAINTAINER "Isoscope <isoscope@localhost>" CACHE STRING "Who stands for the Debian package: Name <mail>")

# Notices of what is compiled into the programs, as the packages have them that it comes from.
set(taken libcgal-dev libcli11-dev nlohmann-json3-dev libnanoflann-dev)
if(ISOSCOPE_VIEWER)
  list(APPEND taken libimgui-dev libglm-dev python3-glad fonts-inter fonts-jetbrains-mono fonts-font-awesome)
  if("${ISOSCOPE_FONT_UI}${ISOSCOPE_FONT_UI_BOLD}${ISOSCOPE_FONT_MONO}" MATCHES DejaVu)
    list(APPEND taken fonts-dejavu-core)
  endif()
endif()
file(READ assets/desktop/copyright copyright)
foreach(package IN LISTS taken)
  set(notice /usr/share/doc/${package}/copyright)
  if(EXISTS ${notice})
    file(READ ${notice} text)
    string(APPEND copyright "\n\n==== ${package} ====\n\n${text}")
  endif()
endforeach()
set(folder ${CMAKE_BINARY_DIR}/debian)
file(WRITE ${folder}/copyright "${copyright}")

execute_process(COMMAND date --rfc-email --utc --date ${ISOSCOPE_RELEASED} OUTPUT_VARIABLE released
                OUTPUT_STRIP_TRAILING_WHITESPACE)
file(WRITE ${folder}/changelog
"isoscope (${PROJECT_VERSION}) stable; urgency=medium

  * Version ${PROJECT_VERSION}.

 -- ${ISOSCOPE_MAINTAINER}  ${released}
")
execute_process(COMMAND gzip -9nf ${folder}/changelog)
install(FILES ${folder}/copyright ${folder}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/isoscope
        COMPONENT debian EXCLUDE_FROM_ALL)

set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_NAME isoscope)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "visualizer and debugger for mesh approximation within a tolerance")
set(CPACK_PACKAGE_DESCRIPTION
"Isoscope finds a coarse mesh with the right topology inside a tolerance volume,
and shows how: isotopic approximation after Mandad, Cohen-Steiner and Alliez.
Every decision is recorded with its reason; a run is played, paused, taken back
and asked. isoscope is the window, isoscope-run does the same work without one,
isoscope-sweep on many models.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_CMAKE_PROJECTS "${CMAKE_BINARY_DIR};isoscope;programs;/;${CMAKE_BINARY_DIR};isoscope;debian;/")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${ISOSCOPE_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, sqlite3")
include(CPack)
