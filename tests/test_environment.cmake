# Fails unless ctest gives every test program the options of the leak checker, and the tests
# golden.egl.* the host that they are to draw with.
# Run by ctest: cmake -DBUILD=… -P test_environment.cmake

# Sets `result` to what ctest knows of the tests that its options choose, as JSON.
function(list_tests result)
    execute_process(COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${BUILD} --show-only=json-v1 ${ARGN}
                    OUTPUT_VARIABLE tests COMMAND_ERROR_IS_FATAL ANY)
    set(${result} "${tests}" PARENT_SCOPE)
endfunction()

# Fails unless each of the tests has the text in its environment.
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

# Those of a program that is not built have no names yet.
list_tests(all --exclude-regex "^build\\.|_NOT_BUILT")
expect_in_each("${all}" "LSAN_OPTIONS=suppressions=")
list_tests(egl --tests-regex "^golden\\.egl\\.")
expect_in_each("${egl}" "PECTIN_OFFSCREEN=egl\"")
expect_in_each("${egl}" "LIBGL_ALWAYS_SOFTWARE=1\"")
