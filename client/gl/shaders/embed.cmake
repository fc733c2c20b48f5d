# Writes the C++ source that holds the shaders of this folder and of those in it, by their file names:
# cmake -DOUT=FILE.cpp -P embed.cmake. A line #include "part.glsl" is replaced by that file, wherever it is. A part may
# include others.
function(read_shader result file)
  file(READ ${file} text)
  while(text MATCHES "#include \"([a-z_]+\\.glsl)\"\n")
    set(line "${CMAKE_MATCH_0}")
    file(GLOB_RECURSE found ${CMAKE_CURRENT_LIST_DIR}/${CMAKE_MATCH_1})
    file(READ ${found} part)
    string(REPLACE "${line}" "${part}" text "${text}")
  endwhile()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE files ${CMAKE_CURRENT_LIST_DIR}/*.vert ${CMAKE_CURRENT_LIST_DIR}/*.frag)
set(entries "")
foreach(file IN LISTS files)
  read_shader(text ${file})
  get_filename_component(name ${file} NAME)
  string(APPEND entries "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE ${OUT} "#include \"client/gl/shader_program.h\"

#include <map>
#include <stdexcept>

namespace platon {

const std::string& shaderText(std::string_view file) {
  static const std::map<std::string, std::string, std::less<>> texts{
${entries}  };
  const auto found = texts.find(file);
  if (found == texts.end()) throw std::logic_error(\"no shader is called \" + std::string(file));
  return found->second;
}

}  // namespace platon
")
