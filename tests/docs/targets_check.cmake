# Configures SOURCE without its tests and looks for the targets that documents are made by.
file(REMOVE_RECURSE ${BUILD})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} -G ${GENERATOR} -D BUILD_TESTING=OFF
    RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(failed)
    message(FATAL_ERROR "${said}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --target help OUTPUT_VARIABLE targets)
file(REMOVE_RECURSE ${BUILD})
foreach(target docs gallery)
    if(NOT targets MATCHES "(^|\n)(\\.\\.\\. )?${target}[:\n]")
        message(FATAL_ERROR "without the tests there is no target ${target}")
    endif()
endforeach()
