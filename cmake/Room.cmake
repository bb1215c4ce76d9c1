# A room is one static library, one folder: its sources, the rooms it may include (DEPENDS, public), and the
# third-party libraries that stay inside its .cpp files (PRIVATE_LIBS). The declared arrows are written to
# room_graph.txt, which tests/house holds against every #include.
add_library(unietp_flags INTERFACE)
target_compile_features(unietp_flags INTERFACE cxx_std_20)
target_compile_options(unietp_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion
                       -Werror -ffp-contract=off
                       # In a batch the file before is no enclosing scope, and its classes are not a header's; g++ can
                       # be told so, clang++ cannot.
                       $<$<NOT:$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wshadow>
                       $<$<AND:$<BOOL:${CMAKE_UNITY_BUILD}>,$<CXX_COMPILER_ID:GNU>>:-Wshadow=local;-Wno-subobject-linkage>
                       $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)  # g++ 12 warns falsely of "literal" + std::string
# What users run does not name the folder that it was built in, as assert and debug information would.
target_compile_options(unietp_flags INTERFACE
                       $<$<CONFIG:Release>:-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=>)
target_include_directories(unietp_flags INTERFACE ${PROJECT_SOURCE_DIR})
# The rooms also go into the Python module, a shared library. Nobody replaces their functions there, so g++ may inline
# them as in a program.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
target_compile_options(unietp_flags INTERFACE -fno-semantic-interposition)
# g++ collects its own garbage less often: 8 % less time to compile.
target_compile_options(unietp_flags INTERFACE
                       "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=500000>")
file(WRITE ${PROJECT_BINARY_DIR}/room_graph.txt "")

# What core/math_functions.cpp defines, each in double and in single precision (sinf). Compilers must not compute them
# themselves where the argument is a constant, since their result can differ in the last bit.
set(UNIETP_MATH_FUNCTIONS sin cos sincos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh
    exp exp2 exp10 expm1 log log2 log10 log1p pow cbrt hypot erf erfc)
list(TRANSFORM UNIETP_MATH_FUNCTIONS PREPEND -fno-builtin- OUTPUT_VARIABLE UNIETP_NO_FOLDING)

# Where a run spends its time. With only logic, scene and simulation at -O3 and the others at -O1, making the benchmark
# takes a fifth more processor time, since homes are drawn by grounding.
set(UNIETP_HOT_ROOMS core akb sense symbolic logic scene simulation generator grounding expert environment)

# A room that UNIETP_ROOMS does not name is built all the same when another room or its tests need it.
function(need_rooms)
  foreach(room IN LISTS ARGN)
    if(NOT TARGET unietp::${room})
      add_subdirectory(${PROJECT_SOURCE_DIR}/${room} ${PROJECT_BINARY_DIR}/${room})
    endif()
  endforeach()
endfunction()

function(add_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;DEPENDS;PUBLIC_LIBS;PRIVATE_LIBS" ${ARGN})
  need_rooms(${ROOM_DEPENDS})
  add_library(unietp_${name} STATIC ${ROOM_SOURCES})
  add_library(unietp::${name} ALIAS unietp_${name})
  list(TRANSFORM ROOM_DEPENDS PREPEND unietp:: OUTPUT_VARIABLE rooms)
  target_link_libraries(unietp_${name} PUBLIC unietp_flags ${rooms} ${ROOM_PUBLIC_LIBS} PRIVATE ${ROOM_PRIVATE_LIBS})
  target_compile_options(unietp_${name} PRIVATE ${UNIETP_NO_FOLDING})
  if(name IN_LIST UNIETP_HOT_ROOMS)  # at -O3 g++ 12 warns falsely of std::variant
    target_compile_options(unietp_${name} PRIVATE
                           $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-O3;-Wno-maybe-uninitialized>)
  endif()
  file(APPEND ${PROJECT_BINARY_DIR}/room_graph.txt "${name}: ${ROOM_DEPENDS}\n")
  set_property(GLOBAL APPEND PROPERTY UNIETP_ROOMS_BUILT ${name})
endfunction()

set(UNIETP_UPSTREAM "${PROJECT_SOURCE_DIR}/../shared/upstream" CACHE PATH
    "The simulators' own files, listed in docs/knowledge.md; tests on them are skipped where this folder is missing")

# One test program a folder: add_room_tests(logic SOURCES a_test.cpp b_test.cpp LIBS extra SLOW Monitor.*). SLOW names the
# TESTs with the label `slow`, "*" all of them: each is a test of ctest. The others are `fast`, together take less than two
# minutes, and are one test of ctest a suite, since most of their time would go into starting processes. TOGETHER has
# filters of slow TESTs that share a fixture which takes seconds to make, such as a data set: each filter is one test of ctest.
# Tests find committed data through UNIETP_SOURCE_DIR and the optional real metadata through UNIETP_UPSTREAM_DIR.
function(add_room_tests name)
  cmake_parse_arguments(T "" "" "SOURCES;LIBS;SLOW;TOGETHER" ${ARGN})
  set(rooms ${T_LIBS})
  list(FILTER rooms INCLUDE REGEX "^unietp::")
  list(TRANSFORM rooms REPLACE "^unietp::" "")
  # A room is tested without those above it.
  list(FIND UNIETP_ALL_ROOMS ${name} own_place)
  foreach(room IN LISTS rooms)
    list(FIND UNIETP_ALL_ROOMS ${room} place)
    if(own_place GREATER -1 AND place GREATER own_place)
      message(FATAL_ERROR "The tests of ${name} use ${room}, a room above it; tests of both belong to tests/${room}")
    endif()
  endforeach()
  need_rooms(${rooms})
  add_executable(${name}_tests ${T_SOURCES})
  set_target_properties(${name}_tests PROPERTIES UNITY_BUILD_BATCH_SIZE 8)  # names of helpers recur between test files
  target_link_libraries(${name}_tests PRIVATE ${T_LIBS} test_support GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name}_tests PRIVATE UNIETP_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                             UNIETP_UPSTREAM_DIR="${UNIETP_UPSTREAM}")
  list(JOIN T_SLOW ":" slow)
  if(NOT slow STREQUAL "*")
    set(suites ${CMAKE_CURRENT_BINARY_DIR}/${name}_suites.cmake)
    add_custom_command(TARGET ${name}_tests POST_BUILD VERBATIM
                       COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${name}_tests> -DROOM=${name} "-DSLOW=${slow}"
                               -DOUT=${suites} -P ${PROJECT_SOURCE_DIR}/cmake/list_suites.cmake)
    # What is not built is a test that fails.
    file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${name}_fast.cmake
         "if(EXISTS [[${suites}]])\n  include([[${suites}]])\nelse()\n"
         "  add_test(${name}_NOT_BUILT ${name}_NOT_BUILT)\nendif()\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}_fast.cmake)
  endif()
  if(slow)
    foreach(filter IN LISTS T_TOGETHER)
      string(REGEX MATCH "[A-Za-z]+" label ".${filter}.All")
      add_test(NAME ${name}.${label} COMMAND ${name}_tests --gtest_filter=${filter})
      set_tests_properties(${name}.${label} PROPERTIES LABELS slow TIMEOUT 1200)
    endforeach()
    list(JOIN T_TOGETHER ":" together)
    # Exit codes decide. ctest would take a suite that fails before its TESTs are skipped for one that is skipped.
    gtest_discover_tests(${name}_tests TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60 TEST_FILTER "${slow}-${together}"
                         TEST_LIST ${name}_slow PROPERTIES LABELS slow TIMEOUT 600 SKIP_REGULAR_EXPRESSION "[.]^")
  endif()
endfunction()
