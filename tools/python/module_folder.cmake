# SPDX-License-Identifier: BSD-3-Clause

# surfmesh_module_folder(<variable>): the folder that the Python package is installed to, relative
# to the prefix: that of the Python (Python_SITEARCH) if it lies in the prefix, such as
# lib/python3/dist-packages with /usr on Debian; else the like of it for PYTHONPATH, such as
# lib/python3.11/dist-packages, which Debian's Python also searches in /usr/local.
# SURFMESH_PYTHON_FOLDER, relative or absolute, goes before both.
function(surfmesh_module_folder result)
  if(SURFMESH_PYTHON_FOLDER)
    set(${result} ${SURFMESH_PYTHON_FOLDER} PARENT_SCOPE)
    return()
  endif()
  cmake_path(IS_PREFIX CMAKE_INSTALL_PREFIX "${Python_SITEARCH}" NORMALIZE is_inside)
  if(is_inside)
    file(RELATIVE_PATH folder "${CMAKE_INSTALL_PREFIX}" "${Python_SITEARCH}")
  else()
    get_filename_component(packages "${Python_SITEARCH}" NAME)  # "dist-packages" for Debian's
    set(folder lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/${packages})
  endif()
  set(${result} ${folder} PARENT_SCOPE)
endfunction()

# surfmesh_module_rpath(<variable> <folder>): where a shared libsurfmesh is found from the package
# in a folder of surfmesh_module_folder.
function(surfmesh_module_rpath result folder)
  if(IS_ABSOLUTE "${folder}")
    set(${result} ${CMAKE_INSTALL_FULL_LIBDIR} PARENT_SCOPE)
    return()
  endif()
  file(RELATIVE_PATH up "/prefix/${folder}/surfmesh" "/prefix/${CMAKE_INSTALL_LIBDIR}")
  set(${result} "$ORIGIN/${up}" PARENT_SCOPE)
endfunction()
