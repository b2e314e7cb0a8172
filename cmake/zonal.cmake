# One interface target carries the flags that every target of this project is built with.
add_library(zonal_flags INTERFACE)
target_compile_options(zonal_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-float-conversion -Wno-psabi
  -fno-math-errno)  # nothing here asks errno, and without it square roots vectorise
if(ZONAL_SANITIZE)
  target_compile_options(zonal_flags INTERFACE -fsanitize=${ZONAL_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(zonal_flags INTERFACE -fsanitize=${ZONAL_SANITIZE})
endif()

if(ZONAL_TESTS)
  enable_testing()
  find_package(GTest REQUIRED)
  include(GoogleTest)
endif()

# zonal_test(NAME sources... [LIBS libs...]): one test program; each TEST of it is a ctest entry.
# A test whose suite starts with "Slow" carries the label slow, and with SLOW all of them; ctest -LE slow is the daily run.
function(zonal_test name)
  cmake_parse_arguments(ARG "SLOW" "" "SOURCES;LIBS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LIBS} zonal_flags GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${name} PRIVATE ZONAL_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  set(label fast)
  if(ARG_SLOW)
    set(label slow)
  endif()
  gtest_discover_tests(${name} TEST_FILTER "-Slow*" DISCOVERY_TIMEOUT 60 PROPERTIES LABELS ${label})
  gtest_discover_tests(${name} TEST_FILTER "Slow*" TEST_SUFFIX "" DISCOVERY_TIMEOUT 60 PROPERTIES LABELS slow TEST_LIST ${name}_slow)
endfunction()

# Kernels: NAME_kernel.cpp is compiled once per instruction set, each copy in its own namespace (ZONAL_ISA), and chosen at
# run time through base/cpu.h. Contraction is left on: results may differ in the last bits between instruction sets.
set(ZONAL_ISA_FLAGS_baseline "")
set(ZONAL_ISA_FLAGS_avx2 -mavx2 -mfma -mf16c)
set(ZONAL_ISA_FLAGS_avx512 -mavx512f -mavx512dq -mavx512vl -mavx512bw -mfma -mf16c -mprefer-vector-width=512)
set(ZONAL_ISA_LANES_baseline 2)
set(ZONAL_ISA_LANES_avx2 4)
set(ZONAL_ISA_LANES_avx512 8)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(ZONAL_ISAS baseline avx2 avx512)
else()
  set(ZONAL_ISAS baseline)
endif()

# zonal_floor(NAME USES public-libs [PRIVATE libs]): zonal/NAME/*.cpp as a library, zonal/NAME/*_test.cpp as its test.
function(zonal_floor name)
  cmake_parse_arguments(ARG "" "" "USES;PRIVATE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/zonal/${name}/*.cpp)
  set(tests ${sources})
  set(kernels ${sources})
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  list(FILTER kernels INCLUDE REGEX "_kernel\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "_(test|kernel)\\.cpp$")

  set(target zonal_${name})
  if(sources)
    add_library(${target} STATIC ${sources})
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE zonal_flags)
    if(ARG_PRIVATE)
      target_link_libraries(${target} PRIVATE ${ARG_PRIVATE})
    endif()
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_link_libraries(${target} ${scope} ${ARG_USES})
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_compile_features(${target} ${scope} cxx_std_20)
  set_property(GLOBAL APPEND PROPERTY ZONAL_LIBRARIES ${target})

  foreach(isa IN LISTS ZONAL_ISAS)
    if(kernels)
      set(object ${target}_${isa})
      add_library(${object} OBJECT ${kernels})
      target_include_directories(${object} PRIVATE ${PROJECT_SOURCE_DIR})
      target_link_libraries(${object} PRIVATE zonal_flags ${ARG_USES})
      target_compile_options(${object} PRIVATE ${ZONAL_ISA_FLAGS_${isa}} $<$<NOT:$<CONFIG:Debug>>:-O3> -fno-math-errno -fno-trapping-math)
      target_compile_definitions(${object} PRIVATE ZONAL_ISA=${isa} ZONAL_LANES=${ZONAL_ISA_LANES_${isa}})
      target_sources(${target} PRIVATE $<TARGET_OBJECTS:${object}>)
      set_property(GLOBAL APPEND PROPERTY ZONAL_KERNEL_TARGETS ${object})
    endif()
  endforeach()

  if(ZONAL_TESTS AND tests)
    zonal_test(${name}_test SOURCES ${tests} LIBS ${target} ${ARG_PRIVATE})
  endif()
endfunction()

# The files of zonal/view/FOLDER with these EXTENSIONS as text inside the library: the function NAME of zonal/view/NAME.h.
function(zonal_embed target folder name type)
  set(from ${PROJECT_SOURCE_DIR}/zonal/view/${folder})
  set(output ${PROJECT_BINARY_DIR}/${name}.cpp)
  set(patterns ${ARGN})
  list(TRANSFORM patterns PREPEND ${from}/*.)
  file(GLOB texts CONFIGURE_DEPENDS ${patterns})
  string(REPLACE ";" " " extensions "${ARGN}")
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${from} -DEXTENSIONS=${extensions} -DNAME=${name} -DTYPE=${type} -DOUTPUT=${output}
            -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${texts} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()

# The shader bodies of zonal/view/shaders and the parts of the page.
function(zonal_embed_shaders target)
  zonal_embed(${target} shaders shader_bodies ShaderBody glsl)
  zonal_embed(${target} page page_parts PagePart html css js)
endfunction()
