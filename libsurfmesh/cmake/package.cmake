# What cpack makes: an archive of all that is installed, and Debian packages, each of which needs
# only what its own programs need. tools/release.sh runs it in a build with the prefix /usr.
#
# surfmesh          program, manual pages, completions, models, documents
# surfmesh-cad      what reads CAD files, for the program and for Python; needs OpenCASCADE
# surfmesh-mpi      surfmesh-mpi with its manual pages and completions; needs MPI
# python3-surfmesh  Python module
# libsurfmesh-dev   static libraries, headers, what CMake and pkg-config need
#
# The programs hold the library: there are no packages of a shared one.
if(BUILD_SHARED_LIBS)
  return()
endif()

set(SURFMESH_MAINTAINER "The surfmesh authors <maintainers@surfmesh.invalid>" CACHE STRING
    "Name and address in the packages")

set(CPACK_GENERATOR TGZ)
find_program(SURFMESH_SHLIBDEPS dpkg-shlibdeps)
mark_as_advanced(SURFMESH_SHLIBDEPS)
if(SURFMESH_SHLIBDEPS)
  list(APPEND CPACK_GENERATOR DEB)
endif()
set(CPACK_PACKAGE_NAME surfmesh)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_PACKAGE_VENDOR surfmesh)
set(CPACK_PACKAGE_CONTACT ${SURFMESH_MAINTAINER})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_SYSTEM_NAME ${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

find_program(SURFMESH_GZIP gzip)
mark_as_advanced(SURFMESH_GZIP)
if(SURFMESH_GZIP)
  execute_process(COMMAND ${SURFMESH_GZIP} -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md
    OUTPUT_FILE ${PROJECT_BINARY_DIR}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
endif()

file(READ ${PROJECT_SOURCE_DIR}/LICENSE licence)
file(WRITE ${PROJECT_BINARY_DIR}/copyright "${licence}\n\
share/surfmesh/viewer.js, and so each page that `surfmesh view` writes, holds three.js\n\
(https://threejs.org), which is under the MIT licence; its text stands in it.\n")

# surfmesh_add_package(<component> <name> <section> <one line> <text> [<field> <packages>]...): the
# fields are those of Debian: DEPENDS, RECOMMENDS, SUGGESTS. Licence and changelog lie where Debian
# expects them, in the packages only.
macro(surfmesh_add_package component name section line text)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} id)
  set(CPACK_DEBIAN_${id}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${id}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${id}_DESCRIPTION "${line}\n${text}")
  set(fields ${ARGN})
  while(fields)
    list(POP_FRONT fields field packages)
    set(CPACK_DEBIAN_${id}_PACKAGE_${field} "${packages}")
  endwhile()
  set(folder ${CMAKE_INSTALL_DATAROOTDIR}/doc/${name})
  install(FILES ${PROJECT_BINARY_DIR}/copyright DESTINATION ${folder}
          COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_BINARY_DIR}/changelog.gz DESTINATION ${folder}
          COMPONENT ${component} EXCLUDE_FROM_ALL OPTIONAL)
endmacro()

set(this_version "(= ${PROJECT_VERSION})")
set(what "surfmesh meshes smooth surfaces with triangles or quads whose sizes and directions follow\n\
a metric: control cages, NURBS, formulas and CAD parts.")
if(TARGET surfmesh_program)
  surfmesh_add_package(surfmesh_programs surfmesh science "${PROJECT_DESCRIPTION}" "${what}"
    SUGGESTS "surfmesh-cad, surfmesh-mpi, python3-surfmesh")
endif()
if(TARGET surfmesh_cad_program)
  surfmesh_add_package(surfmesh_cad surfmesh-cad science "STEP, IGES and BREP files for surfmesh"
    "${what}\nThis package lets it read CAD files, by OpenCASCADE."
    DEPENDS "surfmesh ${this_version}")
endif()
if(TARGET surfmesh_mpi_program)
  surfmesh_add_package(surfmesh_mpi surfmesh-mpi science "surfmesh for clusters"
    "${what}\nThis package has a program that meshes in pieces, by the processes that mpirun starts."
    DEPENDS "surfmesh ${this_version}" RECOMMENDS mpi-default-bin)
endif()
if(TARGET _surfmesh)
  get_property(python GLOBAL PROPERTY surfmesh_python_version)
  string(REGEX REPLACE "\\..*" "" python_major ${python})
  string(REGEX REPLACE ".*\\." "" python_minor ${python})
  math(EXPR python_next "${python_minor} + 1")
  surfmesh_add_package(surfmesh_python python3-surfmesh python "Python module of surfmesh"
    "${what}\nThis package has the module, whose meshes are NumPy arrays."
    DEPENDS "python3 (>= ${python}), python3 (<< ${python_major}.${python_next}), python3-numpy"
    SUGGESTS "surfmesh-cad, python3-matplotlib, python3-scipy")
endif()
string(CONCAT needed_headers "libopenmesh-dev, libeigen3-dev (>= 3.4), libosd-dev, libfmt-dev, "
       "libtbb-dev, libexpat1-dev, zlib1g-dev")
string(CONCAT more_headers "libocct-data-exchange-dev, libocct-modeling-algorithms-dev, "
       "libopenmpi-dev, libmetis-dev, pkgconf")
surfmesh_add_package(surfmesh_development libsurfmesh-dev libdevel "C++ library of surfmesh"
  "${what}\nThis package has the static library with its headers. Its documents are in surfmesh."
  DEPENDS "${needed_headers}" SUGGESTS "surfmesh, ${more_headers}")
include(CPack)
