# How tests are built, labelled and run; included by tests/CMakeLists.txt.

# platon_tests(LABELS label… SOURCES file_test.cpp… [LIBS target…] [TIMEOUT seconds] [RUNNER program] [ALONE])
# Adds a target and a GoogleTest program for each file, named after it, and a test with all of the labels. Tests run in the
# source tree, where they find levels/ and tests/determinism/golden/. RUNNER gets the command of the test as arguments.
# Unless they are ALONE, files of a folder with the same LIBS and the same lanes but `sanitized` are compiled together
# (platon_test_programs).
function(platon_tests)
  cmake_parse_arguments(PARSE_ARGV 0 arg "ALONE" "TIMEOUT;RUNNER" "LABELS;SOURCES;LIBS")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_LABELS OR NOT arg_SOURCES)
    message(FATAL_ERROR "platon_tests needs LABELS and SOURCES; unknown arguments: '${arg_UNPARSED_ARGUMENTS}'")
  endif()
  get_property(groups DIRECTORY PROPERTY platon_groups)
  if(NOT groups)
    cmake_language(DEFER CALL platon_test_programs)
  endif()
  foreach(source IN LISTS arg_SOURCES)
    cmake_path(GET source STEM name)
    add_custom_target(${name})
    add_test(NAME ${name} COMMAND ${arg_RUNNER} ${PROJECT_BINARY_DIR}/tests/bin/${name}
             WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    # A program without tests would pass.
    set_tests_properties(${name} PROPERTIES FAIL_REGULAR_EXPRESSION "Running 0 tests")
    platon_test_properties(NAME ${name} SOURCE ${source} LABELS ${arg_LABELS} TIMEOUT ${arg_TIMEOUT})
    platon_lanes(lanes NAME ${name} SOURCE ${source} LABELS ${arg_LABELS})
    foreach(lane IN LISTS lanes)
      add_dependencies(${lane}_tests ${name})
    endforeach()
    list(REMOVE_ITEM lanes sanitized)
    set(alone "")
    if(arg_ALONE)
      set(alone ${name})
    endif()
    string(MD5 group "${arg_LIBS} ${lanes} ${alone}")
    set_property(DIRECTORY APPEND PROPERTY platon_groups ${group})
    set_property(DIRECTORY APPEND PROPERTY platon_sources_${group} ${source})
    set_property(DIRECTORY PROPERTY platon_libs_${group} ${arg_LIBS})
  endforeach()
endfunction()

# platon_test_programs()
# Called at the end of a folder: builds a program for up to 32 files of a group, with a link for each of them, which runs
# its tests alone (tests/support/run/main_of_links.cpp).
function(platon_test_programs)
  get_property(groups DIRECTORY PROPERTY platon_groups)
  list(REMOVE_DUPLICATES groups)
  set(folder ${PROJECT_BINARY_DIR}/tests/bin)
  foreach(group IN LISTS groups)
    get_property(left DIRECTORY PROPERTY platon_sources_${group})
    get_property(libraries DIRECTORY PROPERTY platon_libs_${group})
    while(left)
      list(SUBLIST left 0 32 sources)
      list(REMOVE_ITEM left ${sources})
      list(GET sources 0 first)
      cmake_path(GET first STEM program)
      string(APPEND program _and_others)
      add_executable(${program} ${sources})
      target_link_libraries(${program} PRIVATE ${libraries} platon_test_support platon_main_of_links)
      platon_quick_to_build(${program})
      # lld is faster, but finds no library that only another library names.
      if(NOT "$CACHE{BUILD_SHARED_LIBS}")
        target_link_options(${program} PRIVATE -fuse-ld=lld)
      endif()
      target_precompile_headers(${program} REUSE_FROM platon_test_headers)
      set_target_properties(${program} PROPERTIES
        RUNTIME_OUTPUT_DIRECTORY ${folder} UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
      foreach(source IN LISTS sources)
        cmake_path(GET source STEM name)
        add_custom_command(TARGET ${program} POST_BUILD
          COMMAND ${CMAKE_COMMAND} -E create_symlink ${program} ${folder}/${name} VERBATIM)
        add_dependencies(${name} ${program})
      endforeach()
    endwhile()
  endforeach()
endfunction()

# platon_quick_to_build(target [option])
# Compiles what belongs to tests without optimisation, or with the option, for example -O1 for what calculates much, and
# with clang where the product is compiled by GCC without sanitizers: that takes half of the time. The libraries that are
# tested stay as they are.
function(platon_quick_to_build target)
  target_compile_options(${target} PRIVATE ${ARGN})
  if(NOT ARGN)
    target_compile_options(${target} PRIVATE -O0)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND NOT PLATON_SANITIZE)
    set(launcher ${PROJECT_SOURCE_DIR}/tests/compile_by_clang.sh ${CMAKE_CXX_COMPILER_LAUNCHER})
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "${launcher}")
  endif()
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU OR NOT PLATON_SANITIZE)
    target_compile_options(${target} PRIVATE -fpch-instantiate-templates)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # The first is needed by ccache to keep objects that use a precompiled header. The others warn of GCC's own
    # std::string (GCC bug 105651), also where it comes from a precompiled header.
    target_compile_options(${target} PRIVATE -fpch-preprocess -Wno-array-bounds -Wno-stringop-overflow)
  endif()
endfunction()

# platon_lanes(result NAME name [SOURCE file] LABELS label…)
# Sets `result` to the lanes that run this test: parts of the test suite, each a label and a target NAME_tests that
# builds it.
#   quick      structure tests, and unit tests of the simulation, the protocol, the match and the prediction
#   all        all but slow tests
#   outside    tests of what gets bytes from outside, for the address and undefined-behaviour sanitizers
#   sanitized  unit, net and render tests, for the same sanitizers
#   threads    tests of programs with more than one thread, for the thread sanitizer
# `./platon test --all` runs all, outside and threads; `./platon test --release` every test, sanitized and threads.
function(platon_lanes result)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "NAME;SOURCE" "LABELS")
  cmake_path(APPEND CMAKE_CURRENT_SOURCE_DIR "${arg_SOURCE}" OUTPUT_VARIABLE path)
  cmake_path(RELATIVE_PATH path BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/tests)
  set(lanes)
  if(NOT slow IN_LIST arg_LABELS)
    list(APPEND lanes all)
    if(structure IN_LIST arg_LABELS OR (unit IN_LIST arg_LABELS AND arg_SOURCE AND path MATCHES "${PLATON_FOLDERS_OF_QUICK}"))
      list(APPEND lanes quick)
    endif()
    if(arg_SOURCE AND path MATCHES "${PLATON_FOLDERS_OF_OUTSIDE}")
      list(APPEND lanes outside)
    endif()
    if(unit IN_LIST arg_LABELS OR render IN_LIST arg_LABELS)
      list(APPEND lanes sanitized)
    endif()
  endif()
  if(net IN_LIST arg_LABELS)
    list(APPEND lanes sanitized)
  endif()
  if(arg_NAME IN_LIST PLATON_THREADED_TESTS)
    list(APPEND lanes threads)
  endif()
  list(REMOVE_DUPLICATES lanes)
  set(${result} ${lanes} PARENT_SCOPE)
endfunction()

# platon_test_properties(NAME name [SOURCE file] LABELS label… [TIMEOUT seconds] [COMPILES])
# Sets the properties that all tests share, also those added by add_test. PLATON_BIN names the folder of the programs.
# Each test has its own home folder, which configuring empties, and asks the web servers of this machine without a proxy.
# A test that COMPILES uses the user's folder, for ccache. A busy machine needs many times as long as a calm one: only a
# test that hangs reaches the limit of its time. A test that is `slow` runs only in `./platon test --release`.
function(platon_test_properties)
  cmake_parse_arguments(PARSE_ARGV 0 arg "COMPILES" "NAME;SOURCE;TIMEOUT" "LABELS")
  set(known unit hard lockstep net render levels slow structure fuzz package)
  foreach(label IN LISTS arg_LABELS)
    if(NOT label IN_LIST known)
      message(FATAL_ERROR "test ${arg_NAME}: no label '${label}'; the labels are ${known}")
    endif()
  endforeach()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 600)
  endif()
  if(PLATON_SANITIZE OR CMAKE_BUILD_TYPE STREQUAL Debug)
    math(EXPR arg_TIMEOUT "${arg_TIMEOUT} * 5")
  endif()
  # The libraries of the system are not instrumented; the thread sanitizer would misjudge their threads.
  set(environment "PLATON_BIN=${CMAKE_RUNTIME_OUTPUT_DIRECTORY}" "UBSAN_OPTIONS=print_stacktrace=1"
      "ASAN_OPTIONS=${PLATON_ASAN_OPTIONS}"
      "TSAN_OPTIONS=ignore_noninstrumented_modules=1")
  if(NOT arg_COMPILES)
    set(home ${PROJECT_BINARY_DIR}/tests/home/${arg_NAME})
    file(REMOVE_RECURSE ${home})
    file(MAKE_DIRECTORY ${home} ${home}/run)
    list(APPEND environment "HOME=${home}" "XDG_DATA_HOME=${home}/data" "XDG_CONFIG_HOME=${home}/config"
         "XDG_STATE_HOME=${home}/state" "XDG_CACHE_HOME=${home}/cache" "XDG_RUNTIME_DIR=${home}/run"
         "no_proxy=127.0.0.1")
  endif()
  set(long_labels ${arg_LABELS})
  list(FILTER long_labels INCLUDE REGEX "^(hard|lockstep|slow)$")
  if(PLATON_LONG AND long_labels)
    list(APPEND environment PLATON_LONG=1)
    math(EXPR arg_TIMEOUT "${arg_TIMEOUT} * 100")
  endif()
  if(arg_NAME IN_LIST PLATON_LONGEST_TESTS)
    set_tests_properties(${arg_NAME} PROPERTIES COST 30)
  endif()
  platon_lanes(lanes NAME ${arg_NAME} SOURCE ${arg_SOURCE} LABELS ${arg_LABELS})
  set_tests_properties(${arg_NAME} PROPERTIES
    LABELS "${arg_LABELS};${lanes}"
    TIMEOUT ${arg_TIMEOUT}
    ENVIRONMENT "${environment}")
endfunction()
