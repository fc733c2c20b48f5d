# shellcheck shell=bash
# The functions of machine_script.sh in a booted machine, where systemd runs the server.

: "${debs:?}"

property() { systemctl show --value --property "$1" platon-server; }
server_process() { property MainPID; }
start_server() { systemctl enable --now platon-server && until_true systemctl is-active -q platon-server; }
no_server_runs() { ! pidof platon-server; }
stop_server() { systemctl stop platon-server && [[ $(property Result) == success ]]; }
reload_server() { systemctl reload platon-server; }
server_is_restarted() { [[ $(server_process) != "$1" ]] && systemctl is-active -q platon-server; }

server_log() {
  systemctl status --no-pager platon-server
  journalctl --no-pager -u 'platon-server*'
}

# killed SIGNAL: sends it to the server, and waits until systemd has started another.
killed() {
  local process
  process=$(server_process)
  kill "-$1" "$process"
  until_true server_is_restarted "$process"
}

own_steps() {
  step 'systemd knows that it is ready, and waits before it starts it again'
  [[ $(property Type) == notify ]] || fails 'the unit has another type'
  [[ $(property RestartUSec) == 2s ]] || fails 'the unit waits for another time'

  step 'a reload of an invalid configuration fails and changes nothing'
  set_key chat maybe
  ! systemctl reload platon-server || fails 'the reload of an invalid configuration succeeds'
  set_key chat on
  console <<<status | grep -q 'server: Reloaded' || fails 'the refused reload has an effect'

  step 'a change of the unit lets it enter itself into a list'
  install -d -o platon -m 755 /var/www/platon
  # The test waits less than who runs a server.
  printf '%s\n' '[Service]' ReadWritePaths=/var/www/platon WatchdogSec=2 RestartSec=0 >/opt/test/drop_in
  # systemctl edit wants a terminal.
  EDITOR=/opt/test/unit_editor script -qec 'systemctl edit platon-server' /dev/null || fails 'the unit cannot be edited'
  set_key announce /var/www/platon/servers.json
  set_key announce-as play.example.org:7777
  systemctl restart platon-server
  until_true grep -qs play.example.org:7777 /var/www/platon/servers.json

  step 'a server that stands still is restarted'
  killed STOP
  logged 'Watchdog timeout' || fails 'the watchdog did not restart it'

  step 'a server that crashes is restarted, however often'
  for _ in 1 2 3 4 5 6; do killed SEGV; done

  step 'another server runs beside it'
  sed -e 's,\(run\|lib\)/platon/,&second/,' -e 's/^port = .*/port = 7778/' -e 's/:19777"/:19778"/' -e '/^announce/d' \
    /etc/platon/server.toml >/etc/platon/second.toml
  systemctl enable --now platon-server@second || fails 'the second server does not start'
  console <<<status >/dev/null || fails 'the first server is gone'
  systemctl revert platon-server
}
