# Writes OUT: the configuration that SERVER prints, with the files of the service in the folders of its unit.
execute_process(COMMAND ${SERVER} --print-config OUTPUT_VARIABLE config COMMAND_ERROR_IS_FATAL ANY)

# place(key before after): gives a key of the configuration another default.
function(place key before after)
  string(REPLACE "\n${key} = \"${before}\"\n" "\n${key} = \"${after}\"\n" placed "${config}")
  if(placed STREQUAL config)
    message(FATAL_ERROR "platon-server --print-config prints no line: ${key} = \"${before}\"")
  endif()
  set(config "${placed}" PARENT_SCOPE)
endfunction()

place(record "" /var/lib/platon/recordings)
place(record-limit 10G 1G)
place(key-file "" /var/lib/platon/server.key)
place(ban-file "" /var/lib/platon/bans)
place(best-times "" /var/lib/platon/best_times)
place(socket "" /run/platon/console.sock)
place(metrics "" 127.0.0.1:19777)
file(WRITE ${OUT} "${config}")
