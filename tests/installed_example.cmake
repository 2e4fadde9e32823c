# Installs the library of a build to a new folder, builds examples/ against it and drags a vertex of
# a small model. Fails unless the saved model has that vertex at its target, is refined and has its
# other vertices where they were, and unless the example reports errors as it says.
# Run by ctest: cmake -DSOURCE=… -DBUILD=… -DSCRATCH=… -DCOMPILER=… -P installed_example.cmake
file(REMOVE_RECURSE ${SCRATCH})
set(prefix ${SCRATCH}/prefix)
set(model ${SCRATCH}/tent.obj)
set(saved ${SCRATCH}/dragged.obj)

execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --component library --prefix ${prefix}
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
# A package with paths of the build would only work on this system.
file(GLOB_RECURSE package_files ${prefix}/*.cmake)
if(NOT package_files)
    message(FATAL_ERROR "no package file is installed")
endif()
foreach(file IN LISTS package_files)
    file(READ ${file} text)
    foreach(folder ${SOURCE} ${BUILD})
        string(FIND "${text}" "${folder}" at)
        if(NOT at EQUAL -1)
            message(FATAL_ERROR "${file} names ${folder}")
        endif()
    endforeach()
endforeach()

execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE}/examples -B ${SCRATCH}/build -G Ninja
                        -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${COMPILER}
                        -DCMAKE_COMPILE_WARNING_AS_ERROR=ON
                        "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Wpedantic -Wshadow -Wconversion"
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${SCRATCH}/build COMMAND_ERROR_IS_FATAL ANY)

# Four triangles around a vertex, which is dragged up. The other vertices are out of the brush's reach.
file(WRITE ${model} "v 0 0 0\nv 2 0 0\nv 0 2 0\nv -2 0 0\nv 0 -2 0\n"
                    "f 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 2\n")
execute_process(COMMAND ${SCRATCH}/build/drag ${model} ${saved} 1 0 0 0 0.25 0 0.5
                COMMAND_ERROR_IS_FATAL ANY)
file(STRINGS ${saved} vertices REGEX "^v ")
file(STRINGS ${saved} faces REGEX "^f ")
list(SUBLIST vertices 0 5 base_vertices)
set(expected "v 0.25 0 0.5" "v 2 0 0" "v 0 2 0" "v -2 0 0" "v 0 -2 0")
if(NOT base_vertices STREQUAL expected)
    message(FATAL_ERROR "the first vertices are ${base_vertices} instead of ${expected}")
endif()
list(LENGTH faces face_count)
if(face_count LESS 100)
    message(FATAL_ERROR "the drag has refined the model to ${face_count} triangles only")
endif()

function(expect_failure status message)
    execute_process(COMMAND ${SCRATCH}/build/drag ${ARGN} RESULT_VARIABLE result
                    OUTPUT_VARIABLE output ERROR_VARIABLE error)
    if(NOT result STREQUAL status OR NOT error MATCHES "${message}" OR NOT output STREQUAL "")
        message(FATAL_ERROR "drag ${ARGN}: status ${result}, error output: ${error}")
    endif()
endfunction()
expect_failure(2 "^usage: drag " ${model})
expect_failure(2 "one is not a number" ${model} ${saved} one 0 0 0 0 0 1)
expect_failure(1 "^drag: .*absent.obj" ${SCRATCH}/absent.obj ${saved} 1 0 0 0 0 0 1)
expect_failure(1 "^drag: .*radius" ${model} ${saved} -1 0 0 0 0 0 1)
