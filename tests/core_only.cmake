# Configures a build of only the core library. Fails if it looks for a package that only the program or
# the tests need, or has any other target.
# Run by ctest: cmake -DSOURCE=… -DBUILD=… -DCOMPILER=… -P core_only.cmake
file(REMOVE_RECURSE ${BUILD})
execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} -G Ninja -DPECTIN_PROGRAM=OFF
            -DCMAKE_CXX_COMPILER=${COMPILER}
    COMMAND_ERROR_IS_FATAL ANY)
file(STRINGS ${BUILD}/CMakeCache.txt looked_for
     REGEX "^[^#/]*([Gg][Ll][Ff][Ww]|IMGUI|imgui|GLAD|glad|STB|EGL|egl|cli11|GTest|benchmark_DIR)")
if(looked_for)
    message(FATAL_ERROR "the core library alone needs none of these: ${looked_for}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --target help
                OUTPUT_VARIABLE targets COMMAND_ERROR_IS_FATAL ANY)
if(NOT targets MATCHES "pectin_core")
    message(FATAL_ERROR "there is no target pectin_core")
endif()
if(targets MATCHES "pectin_(app|render|glad|[a-z]*_tests)|[\n ]pectin:")
    message(FATAL_ERROR "more than the core library would be built: ${CMAKE_MATCH_0}")
endif()
