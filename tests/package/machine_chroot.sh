# shellcheck shell=bash
# The functions of machine_script.sh in a machine that is not booted: they do what the unit says.

: "${debs:?}"
server=

trap '[[ -z $server ]] || kill -KILL "$server"' EXIT

# unit_value KEY: prints what the unit gives a key.
unit_value() { sed -n "s/^$1=//p" /lib/systemd/system/platon-server.service | sed 's,%S,/var/lib,'; }

server_process() { printf '%s\n' "$server"; }
server_log() { cat /opt/test/server_log; }
# None of this shell, which starts all, and none that serves metrics.
no_server_runs() { [[ -z $(jobs -rp) ]] && ! (: </dev/tcp/127.0.0.1/19777) 2>/dev/null; }
reload_server() { kill -HUP "$server"; }

# become COMMAND…: this shell becomes the command, with the user and the mask of the unit.
become() {
  local user
  user=$(unit_value User)
  umask "$(unit_value UMask)"
  exec setpriv --reuid "$user" --regid "$user" --init-groups "$@"
}

# make_folders: as systemd does before it starts the server.
make_folders() {
  local user before
  user=$(unit_value User)
  install -d -o "$user" -g "$user" -m "$(unit_value StateDirectoryMode)" "/var/lib/$(unit_value StateDirectory)"
  install -d -o "$user" -g "$user" -m "$(unit_value RuntimeDirectoryMode)" "/run/$(unit_value RuntimeDirectory)"
  read -ra before <<<"$(unit_value ExecStartPre)"
  (become "${before[@]}")
}

start_server() {
  local start
  make_folders
  read -ra start <<<"$(unit_value ExecStart)"
  (become "${start[@]}") >/opt/test/server_log 2>&1 &
  server=$!
  until_true logged 'listening on'
}

# It has ended with 0.
stop_server() {
  local process=$server
  server=
  kill -TERM "$process" && wait "$process"
}

# Nothing but systemd restarts it.
server_is_restarted() { stop_server && start_server && [[ $server != "$1" ]]; }

own_steps() {
  step 'it enters itself into a list'
  install -d -o platon -m 755 /var/www/platon
  set_key announce /var/www/platon/servers.json
  set_key announce-as play.example.org:7777
  stop_server || fails 'the stop was a failure'
  start_server
  until_true grep -qs play.example.org:7777 /var/www/platon/servers.json
}
