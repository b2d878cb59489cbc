# Read by ctest, with a `program` of windows, its `name` and `labels` set: one test for each suite of the program. So
# the tests of a suite share a process, and what takes long to start in it: fonts, shaders, pictures of brushes.
execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE status ERROR_QUIET)
if(NOT status EQUAL 0)
    add_test("${name}_NOT_BUILT" "${name}_NOT_BUILT")
endif()
string(REPLACE "\n" ";" lines "${listed}")
foreach(line IN LISTS lines)
    if(line MATCHES "^([^ ]+)\\.( |$)")
        add_test("${name}.${CMAKE_MATCH_1}" "${program}" "--gtest_filter=${CMAKE_MATCH_1}.*")
        set_tests_properties("${name}.${CMAKE_MATCH_1}" PROPERTIES
            TIMEOUT 1200 LABELS "${labels}" RESOURCE_LOCK active_window COST 1)
    endif()
endforeach()
