# `cmake --install` and packages. The program finds its data relative to itself, so a tree with bin/ and share/unietp/
# may lie anywhere. `all` makes what an installation has beside the sources: the compiled knowledge, the manual page and
# the shell completions, each written by the program itself.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # packages need no tests
set(generated ${PROJECT_BINARY_DIR}/installed)
set(run_unietp $<TARGET_FILE:unietp> --data ${PROJECT_SOURCE_DIR})
file(GLOB_RECURSE knowledge_inputs CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/data/*.csv ${PROJECT_SOURCE_DIR}/templates/*.template)
add_custom_command(OUTPUT ${generated}/made
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${generated}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${generated}
  COMMAND ${run_unietp} knowledge build --out ${generated}/compiled
  COMMAND ${run_unietp} help --man > ${generated}/unietp.1
  COMMAND gzip -9n ${generated}/unietp.1
  COMMAND ${run_unietp} completion bash > ${generated}/unietp.bash
  COMMAND ${run_unietp} completion zsh > ${generated}/_unietp
  COMMAND ${run_unietp} completion fish > ${generated}/unietp.fish
  COMMAND ${CMAKE_COMMAND} -E touch ${generated}/made
  DEPENDS unietp ${knowledge_inputs} COMMENT "Generating knowledge database, manual page and completions" VERBATIM)
add_custom_target(generated_for_install ALL DEPENDS ${generated}/made)

# The program and what it reads, below a folder of the installation; further arguments go to each install().
function(install_program folder)
  install(TARGETS unietp RUNTIME DESTINATION ${folder}/bin ${ARGN})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/data DESTINATION ${folder}/share/unietp ${ARGN})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/templates/library ${PROJECT_SOURCE_DIR}/templates/extended
          DESTINATION ${folder}/share/unietp/templates ${ARGN})
  install(DIRECTORY ${PROJECT_BINARY_DIR}/installed/compiled DESTINATION ${folder}/share/unietp ${ARGN})
endfunction()
install_program(.)
install(DIRECTORY deploy/slurm DESTINATION share/unietp/deploy USE_SOURCE_PERMISSIONS)
install(FILES README.md DESTINATION share/doc/unietp)
install(FILES LICENSE DESTINATION share/doc/unietp RENAME copyright)
install(DIRECTORY docs DESTINATION share/doc/unietp)
install(FILES ${generated}/unietp.1.gz DESTINATION share/man/man1)
install(FILES ${generated}/unietp.bash DESTINATION share/bash-completion/completions RENAME unietp)
install(FILES ${generated}/_unietp DESTINATION share/zsh/vendor-completions)
install(FILES ${generated}/unietp.fish DESTINATION share/fish/vendor_completions.d)

# `cpack --config build/release/CPackConfig.cmake` makes the .deb of a finished build.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME unietp)
file(STRINGS ${PROJECT_SOURCE_DIR}/LICENSE copyright REGEX "^Copyright")
string(REGEX REPLACE "^Copyright \\(c\\) [0-9]+ " "" holder "${copyright}")
set(CPACK_PACKAGE_VENDOR "${holder}")
set(CPACK_PACKAGE_CONTACT "${holder}")  # the package's maintainer; LICENSE names no address
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "make and verify embodied-planning tasks")
set(CPACK_PACKAGE_DESCRIPTION "Data sets of tasks for AI2-THOR, VirtualHome, Habitat and BEHAVIOR: each with a furnished
 home at rest in a physics engine, a formal goal, an English instruction and a
 demonstration that reaches the goal. Works offline and needs no simulator.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # needs dpkg-dev
set(CPACK_DEBIAN_PACKAGE_DEPENDS "hunspell-en-us, hunspell-en-gb")  # the spelling check of instructions
set(CPACK_DEBIAN_PACKAGE_SUGGESTS wordnet-base)                     # `unietp knowledge complete`
include(CPack)
