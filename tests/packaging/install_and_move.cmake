# Installs BUILD_DIR and then moves what was installed to PREFIX: it must work there too.
file(REMOVE_RECURSE ${PREFIX} ${PREFIX}-before)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${PREFIX}-before COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${PREFIX}-before ${PREFIX})

file(GLOB programs ${PREFIX}/bin/slamicp*)
foreach(program IN LISTS programs)
  execute_process(COMMAND ${program} help COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endforeach()
