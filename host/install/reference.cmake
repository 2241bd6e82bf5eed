# Manual pages, and completions for bash, zsh and fish, made from the options of the programs that are built.
# The file ${reference_stamp} says that they are written.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(reference_sources ${PROJECT_SOURCE_DIR}/host/command_line/reference)
set(reference_folder ${CMAKE_CURRENT_BINARY_DIR}/reference)
file(GLOB reference_scripts CONFIGURE_DEPENDS ${reference_sources}/*.py)
set(program_files "")
foreach(program IN LISTS programs)
  list(APPEND program_files $<TARGET_FILE:${program}>)
endforeach()
# Leaks have a test preset of their own; here a report of one would fail the build.
set(in_environment "")
if(OFFING_SANITIZE MATCHES address)
  set(in_environment ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0)
endif()
add_custom_command(OUTPUT ${reference_stamp}
  COMMAND ${in_environment} ${Python3_EXECUTABLE} -B ${reference_sources}/write_reference.py ${reference_folder} ${program_files}
  COMMAND ${CMAKE_COMMAND} -E touch ${reference_stamp}
  DEPENDS ${reference_scripts} ${programs}
  COMMENT "Writing manual pages and completions" VERBATIM)
add_custom_target(offing_reference ALL DEPENDS ${reference_stamp})
add_dependencies(offing_installed offing_reference)

install(DIRECTORY ${reference_folder}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
install(DIRECTORY ${reference_folder}/bash/ DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(DIRECTORY ${reference_folder}/fish/ DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
# Where zsh looks: Debian's packages have a folder of their own. The prefix is known when the files are installed.
install(CODE "
  set(zsh_folder site-functions)
  if(CMAKE_INSTALL_PREFIX STREQUAL /usr)
    set(zsh_folder vendor-completions)
  endif()")
install(DIRECTORY ${reference_folder}/zsh/ DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/\${zsh_folder}")
