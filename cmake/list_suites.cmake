# Lists a test program for ctest, one test a suite: cmake -DPROGRAM=... -DROOM=... -DSLOW=filter -DOUT=file -P list_suites.cmake
# TESTs of one suite share a process, and with it the fixtures that they make once, such as compiled knowledge. Those
# that SLOW names are left out.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests "--gtest_filter=*-${SLOW}" OUTPUT_VARIABLE listed
                COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}")  # values of parameters
string(REGEX MATCHALL "[^\n]+" lines "${listed}")
set(text "")
foreach(line IN LISTS lines)
  if(NOT line MATCHES "^([^ ]+)\\.$")
    continue()
  endif()
  set(suite ${CMAKE_MATCH_1})
  string(APPEND text "add_test([[${ROOM}.${suite}]] [[${PROGRAM}]] [[--gtest_filter=${suite}.*-${SLOW}]])\n"
                     "set_tests_properties([[${ROOM}.${suite}]] PROPERTIES LABELS fast TIMEOUT 300)\n")
endforeach()
file(WRITE ${OUT} "${text}")
