# find_package(platon) gives the targets platon::exact, platon::physics and platon::game; each brings those before it.
include(${CMAKE_CURRENT_LIST_DIR}/platonTargets.cmake)

foreach(component IN LISTS platon_FIND_COMPONENTS)
  if(NOT TARGET platon::${component} AND platon_FIND_REQUIRED_${component})
    set(platon_FOUND FALSE)
    set(platon_NOT_FOUND_MESSAGE "platon has no component ${component}: it has exact, physics and game")
  endif()
endforeach()
