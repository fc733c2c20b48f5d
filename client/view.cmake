# The picture: what is drawn, without OpenGL, sockets or a clock …
add_library(platon_client_view STATIC
  camera.cpp
  face_view.cpp
  font.cpp
  hud.cpp
  menu.cpp
  net_graph.cpp
  palette.cpp
  pose_between.cpp
  scene.cpp
  settings.cpp
  solid_mesh.cpp
  stage.cpp
  steering.cpp)
target_link_libraries(platon_client_view PUBLIC platon_game glm::glm PRIVATE PkgConfig::STB)

find_file(PLATON_FONT_FILE DejaVuSans-Bold.ttf
  PATHS /usr/share/fonts/truetype/dejavu /usr/share/fonts/TTF /usr/share/fonts/dejavu-sans-fonts
  NO_DEFAULT_PATH REQUIRED DOC "The typeface that becomes part of the client (Debian: fonts-dejavu-core)")
set_source_files_properties(font.cpp PROPERTIES
  COMPILE_DEFINITIONS "PLATON_FONT_FILE=\"${PLATON_FONT_FILE}\""
  OBJECT_DEPENDS ${PLATON_FONT_FILE})

# … and how, with OpenGL.
add_library(platon_client_gl STATIC
  background_painter.cpp
  ball_painter.cpp
  game_view.cpp
  gl_loader.cpp
  glyph_atlas.cpp
  image.cpp
  offscreen.cpp
  overlay_painter.cpp
  render_target.cpp
  renderer.cpp
  shader_program.cpp
  shaders.cpp
  stage_painter.cpp
  text_painter.cpp
  window.cpp)
target_link_libraries(platon_client_gl
  PUBLIC platon_client_view GLEW::GLEW OpenGL::OpenGL
  PRIVATE OpenGL::EGL PkgConfig::STB glfw)
