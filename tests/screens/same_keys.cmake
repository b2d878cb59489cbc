# Fails unless the program PROGRAM prints the table of keys that stands in the file TABLE, in LANGUAGE.
execute_process(COMMAND "${PROGRAM}" --keys "${LANGUAGE}" OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ "${TABLE}" written)
if(NOT printed STREQUAL written)
    message(FATAL_ERROR "${TABLE} is not the table that the program prints; packaging/screens.sh --manual writes it anew.")
endif()
