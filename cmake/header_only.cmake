# Libraries that are headers only serve any target. Where they lie in /usr/include, beside the C library of the machine
# that builds, a compiler for another machine must not search all of it: it gets a folder that holds them alone.

# slamicp_headers_for_target(VARIABLE FOLDER...): the include path of what lies in /usr/include/FOLDER.
function(slamicp_headers_for_target variable)
  set(path /usr/include)
  if(CMAKE_CROSSCOMPILING)
    set(path ${PROJECT_BINARY_DIR}/header-only)
    file(MAKE_DIRECTORY ${path})
    foreach(folder IN LISTS ARGN)
      file(CREATE_LINK /usr/include/${folder} ${path}/${folder} SYMBOLIC)
    endforeach()
  endif()
  set(${variable} ${path} PARENT_SCOPE)
endfunction()

# slamicp_headers_only(TARGET FOLDER...): an imported target that lies there.
function(slamicp_headers_only target)
  if(CMAKE_CROSSCOMPILING)
    slamicp_headers_for_target(path ${ARGN})
    set_target_properties(${target} PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${path})
  endif()
endfunction()
