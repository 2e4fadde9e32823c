# Fails unless ctest passes the options of the leak checker to every test program, and the host to draw
# with to the tests golden.egl.*.
# Run by ctest: cmake -DBUILD=… -P test_environment.cmake

# Sets `result` to the JSON description of the tests that the options of ctest select.
function(list_tests result)
    execute_process(COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${BUILD} --show-only=json-v1 ${ARGN}
                    OUTPUT_VARIABLE tests COMMAND_ERROR_IS_FATAL ANY)
    set(${result} "${tests}" PARENT_SCOPE)
endfunction()

# Fails unless every one of the tests has the text in its environment.
function(expect_in_each tests text)
    string(REGEX MATCHALL "\"command\" :" commands "${tests}")
    string(REGEX MATCHALL "\"${text}" found "${tests}")
    list(LENGTH commands count)
    list(LENGTH found found_count)
    if(NOT count EQUAL found_count)
        message(FATAL_ERROR "${found_count} of ${count} tests get ${text}")
    endif()
    message(STATUS "${count} tests get ${text}")
endfunction()

# The tests of a program that is not built have no names yet.
list_tests(all --exclude-regex "^build\\.|_NOT_BUILT")
expect_in_each("${all}" "LSAN_OPTIONS=suppressions=")
list_tests(egl --tests-regex "^golden\\.egl\\.")
expect_in_each("${egl}" "PECTIN_OFFSCREEN=egl\"")
expect_in_each("${egl}" "LIBGL_ALWAYS_SOFTWARE=1\"")
