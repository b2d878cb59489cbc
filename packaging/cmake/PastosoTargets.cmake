# How every target of the project is compiled: standard, warnings, floating-point rules, output folders.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")

if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_package(Threads REQUIRED)
find_program(PASTOSO_CCACHE ccache)
if(PASTOSO_CCACHE)
    # Paths relative to the checkout: what one checkout compiled, another takes from the cache.
    set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" "${PASTOSO_CCACHE}")
endif()
find_program(PASTOSO_MOLD mold)
if(PASTOSO_MOLD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_link_options(-fuse-ld=mold)
endif()

add_library(pastoso_options INTERFACE)
# How the project itself is compiled; programs of others that use the engine decide for themselves.
set(options
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
    # GCC 12 reports std::string's operator+ (GCC bug 105329) and moved variants (105562) by mistake.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
    # The same bits on every machine: no fused multiply-add, no reordering (never -ffast-math).
    -ffp-contract=off -fno-math-errno -fno-trapping-math)
if(PASTOSO_WARNINGS_AS_ERRORS)
    list(APPEND options -Werror)
endif()
target_compile_options(pastoso_options INTERFACE "$<BUILD_INTERFACE:${options}>")
target_compile_features(pastoso_options INTERFACE $<INSTALL_INTERFACE:cxx_std_20>)
set_target_properties(pastoso_options PROPERTIES EXPORT_NAME options)
install(TARGETS pastoso_options EXPORT PastosoEngine)
if(PASTOSO_SANITIZERS)
    target_compile_options(pastoso_options INTERFACE
        -fsanitize=${PASTOSO_SANITIZERS} -fno-omit-frame-pointer
        # GCC's flow analysis is misled by the sanitizers' checks (std::regex is an example).
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_link_options(pastoso_options INTERFACE -fsanitize=${PASTOSO_SANITIZERS})
endif()

# pastoso_keep_libraries(PROGRAM): under the address sanitizer, no library is unloaded before the leak report, so
# that the report can name its functions.
function(pastoso_keep_libraries program)
    if(PASTOSO_SANITIZERS MATCHES "address")
        target_sources(${program} PRIVATE "${PROJECT_SOURCE_DIR}/tests/sanitizers/keep_libraries.cpp")
    endif()
endfunction()

# pastoso_add_library(NAME SOURCES a.cpp ... DEPENDS core ...)
# One engine folder: static library pastoso_NAME, alias pastoso::NAME, headers as "NAME/header.hpp". Installed, it is
# Pastoso::NAME to whoever calls find_package(Pastoso).
function(pastoso_add_library name)
    cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
    add_library(pastoso_${name} STATIC ${arg_SOURCES})
    add_library(pastoso::${name} ALIAS pastoso_${name})
    target_include_directories(pastoso_${name} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/engine>"
                                                      "$<INSTALL_INTERFACE:include/pastoso>")
    target_link_libraries(pastoso_${name} PUBLIC pastoso_options ${arg_DEPENDS}
                                          PRIVATE ${arg_PRIVATE_DEPENDS})
    set_target_properties(pastoso_${name} PROPERTIES EXPORT_NAME ${name})
    install(TARGETS pastoso_${name} EXPORT PastosoEngine ARCHIVE DESTINATION lib/pastoso COMPONENT development)
endfunction()

# pastoso_add_kernels(TARGET SOURCE...)
# Compiles each SOURCE once per instruction set and links all of them into TARGET; the source puts its code
# into namespace PASTOSO_ISA, and callers choose at run time (core/kernels.hpp). Sanitised and unoptimised
# builds hold the baseline alone: there an inline function of the standard library may be emitted out of
# line, and the linker could keep the copy that needs the newest processor. May be called again for more sources.
function(pastoso_add_kernels target)
    set(variants baseline)
    if(NOT PASTOSO_SANITIZERS AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug"
       AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
        list(APPEND variants avx2 avx512)
    endif()
    # Sanitised loops that are unrolled at -O3 take minutes to compile.
    set(optimisation -O3)
    if(PASTOSO_SANITIZERS)
        set(optimisation "")
    endif()
    set(flags_baseline "")
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
        set(flags_baseline -march=x86-64-v2)
    endif()
    set(flags_avx2 -march=x86-64-v3)
    # GCC 12's own AVX-512 headers are reported as reading uninitialised registers (GCC bug 105593).
    set(flags_avx512 -march=x86-64-v4 -mprefer-vector-width=512 -Wno-uninitialized -Wno-maybe-uninitialized)
    foreach(variant IN LISTS variants)
        set(object ${target}_${variant})
        if(TARGET ${object})
            target_sources(${object} PRIVATE ${ARGN})
            continue()
        endif()
        add_library(${object} OBJECT ${ARGN})
        target_compile_definitions(${object} PRIVATE PASTOSO_ISA=${variant})
        if(variants STREQUAL "baseline")
            target_compile_definitions(${object} PRIVATE PASTOSO_ONE_ISA)
        endif()
        target_compile_options(${object} PRIVATE ${flags_${variant}} ${optimisation})
        target_include_directories(${object} PRIVATE "${PROJECT_SOURCE_DIR}/engine")
        target_link_libraries(${object} PRIVATE pastoso_options)
        target_sources(${target} PRIVATE $<TARGET_OBJECTS:${object}>)
    endforeach()
endfunction()

# pastoso_link_closure(RESULT TARGET): the names of all that a program with TARGET is linked to, public or private.
# Targets that another folder imported have no entries of their own here and count by their names.
function(pastoso_link_closure result target)
    set(open ${target})
    set(closure "")
    while(open)
        list(POP_FRONT open name)
        string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" name "${name}")
        string(REGEX REPLACE "^pastoso::" "pastoso_" name "${name}")
        if(name IN_LIST closure)
            continue()
        endif()
        list(APPEND closure "${name}")
        if(NOT TARGET ${name})
            continue()
        endif()
        foreach(property LINK_LIBRARIES INTERFACE_LINK_LIBRARIES)
            get_target_property(linked ${name} ${property})
            if(linked)
                list(APPEND open ${linked})
            endif()
        endforeach()
    endwhile()
    list(SORT closure)
    set(${result} "${closure}" PARENT_SCOPE)
endfunction()
