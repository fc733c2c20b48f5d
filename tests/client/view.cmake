platon_test(NAME client_view LABELS unit LIBS platon_client_view SOURCES
  camera_test.cpp
  font_test.cpp
  hud_test.cpp
  menu_test.cpp
  net_graph_test.cpp
  pose_between_test.cpp
  scene_test.cpp
  settings_test.cpp
  solid_mesh_test.cpp
  stage_test.cpp
  steering_test.cpp)

platon_test(NAME client_render LABELS render LIBS platon_client_gl PkgConfig::STB SOURCES image_test.cpp render_test.cpp)

# Once as it is started, and once on a display of its own.
platon_test(NAME client_window LABELS render LIBS platon_client_gl SOURCES window_test.cpp)
find_program(PLATON_XVFB_RUN xvfb-run)
if(PLATON_XVFB_RUN)
  add_test(NAME client_window_on_xvfb COMMAND ${PLATON_XVFB_RUN} -a -s "-screen 0 1920x1080x24" $<TARGET_FILE:client_window>)
  platon_test_properties(NAME client_window_on_xvfb LABELS render)
endif()

# The graphics driver keeps some memory of its own to the end, which is no fault of the tests.
get_property(tests DIRECTORY PROPERTY TESTS)
foreach(test IN ITEMS client_render client_window client_window_on_xvfb)
  if(test IN_LIST tests)
    set_property(TEST ${test} APPEND PROPERTY ENVIRONMENT "ASAN_OPTIONS=detect_leaks=0")
  endif()
endforeach()
