# The words of the window in other languages: Qt Linguist files, compiled into the program. packaging/words.sh
# brings the files up to date with the code.
find_program(PASTOSO_LRELEASE lrelease HINTS "${QT6_INSTALL_PREFIX}/${QT6_INSTALL_BINS}" REQUIRED)

set(compiled)
foreach(language en ja sv zh_TW)
    set(words "${PROJECT_SOURCE_DIR}/resources/translations/pastoso_${language}.ts")
    set(result "${CMAKE_CURRENT_BINARY_DIR}/pastoso_${language}.qm")
    add_custom_command(OUTPUT "${result}" DEPENDS "${words}"
                       COMMAND "${PASTOSO_LRELEASE}" -silent "${words}" -qm "${result}" VERBATIM)
    list(APPEND compiled "${result}")
endforeach()
qt_add_resources(pastoso_app_window translations PREFIX /translations BASE "${CMAKE_CURRENT_BINARY_DIR}"
                 FILES ${compiled})
