# Words that docs/glossary.md replaces by the field's terms stay out of the code's names. Run by CTest as
#     cmake -D SOURCE=FOLDER -P words.cmake
# A word counts wherever a name begins, ends or holds it as a part: stubborn, kStubbornShare, is_stubborn.
cmake_minimum_required(VERSION 3.25)

# word | the glossary's word
set(replaced
    "[Ss]tubborn|slow (tile)"
    "take_stock|apply_changes, or what is computed"
    "room_quanta|capacity_left_quanta"
    "cut_to_room|cut_to_capacity"
    "SolverMemory|SolverState"
    "give_up|cancel, drop or fail"
    "TeaMoment|TeaSnapshot"
    "[Aa]sleepFilm|inactive"
    "find_(residual|source|velocities|fluxes|growth|shares|tufts)|compute_*")

file(GLOB_RECURSE sources RELATIVE ${SOURCE} ${SOURCE}/engine/*.[ch]pp ${SOURCE}/app/*.[ch]pp)
list(LENGTH sources count)
if(count LESS 100)
    message(FATAL_ERROR "${SOURCE} holds only ${count} sources: this is not the source tree.")
endif()

set(found "")
foreach(pair IN LISTS replaced)
    string(REGEX MATCH "^(.*)\\|([^|]*)$" whole "${pair}")
    set(word "${CMAKE_MATCH_1}")
    set(instead "${CMAKE_MATCH_2}")
    foreach(source IN LISTS sources)
        file(STRINGS ${SOURCE}/${source} lines REGEX "${word}")
        if(lines)
            string(APPEND found "${source}: \"${word}\"; the glossary says ${instead}\n")
        endif()
    endforeach()
endforeach()
if(found)
    message(FATAL_ERROR "${found}")
endif()
message(STATUS "${count} sources use none of the replaced words.")
