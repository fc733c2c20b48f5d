# shellcheck shell=bash
# What packages_test.py runs as root in a machine without network, after the commands of docs/hosting.md. The variable
# `debs` names the folder of the packages, `debs/next` that of a newer version, whose configuration has `next_comment`.
# machine_booted.sh or machine_chroot.sh comes before, with the functions that differ: start_server, stop_server,
# reload_server, server_process, server_is_restarted, server_log, and own_steps, which only this way can take. all_steps is
# called after them.

: "${debs:?}" "${next_comment:?}"
configuration=/etc/platon/server.toml

# fails SENTENCE: ends the script.
fails() {
  server_log || true
  printf 'failed: %s\n' "$1"
  exit 1
}

# until_true COMMAND…: waits until a command succeeds, at most 40 seconds.
until_true() {
  local end=$((SECONDS + 40))
  until "$@"; do
    [[ $SECONDS -lt $end ]] || fails "still not: $*"
    sleep 0.1
  done
}

logged() { server_log | grep -q -- "$1"; }
console() { platon-server --console --config "$configuration"; }
bots_play() { platon-bot 127.0.0.1 --count 2 --seconds "$1" --json | grep -q '"connected": *2'; }

# set_key KEY VALUE: changes a text in the configuration.
set_key() { sed -i "s,^$1 = .*,$1 = \"$2\"," "$configuration"; }

step() { printf 'step: %s\n' "$1"; }

all_steps() {
  step 'no library of OpenGL or X11 came with the server'
  ! dpkg-query -W -f='${Package}\n' | grep -E '^(libgl|libegl|libglx|libopengl|libx11|mesa)' || fails 'a graphics library is installed'

  step 'its units are valid'
  systemd-analyze verify --man=no /lib/systemd/system/platon-server.service platon-server@second.service ||
    fails 'the units are not valid'

  step 'it runs as its own user'
  until_true test -S /run/platon/console.sock
  [[ $(stat -c %U /run/platon/console.sock) == platon ]] || fails 'the server runs as another user'

  step 'bots play on it'
  apt-get install "$debs"/platon-tools_*.deb
  bots_play 6 || fails 'the bots do not play'

  step 'console, metrics and reload work'
  console <<<'ban 203.0.113.7 1h' || fails 'the console does not answer'
  until_true grep -q 203.0.113.7 /var/lib/platon/bans
  wget -qO- http://127.0.0.1:9100/metrics | grep -q '^platon_bans 1$' || fails 'the metrics count no ban'
  set_key name Reloaded
  reload_server
  until_true logged 'configuration and levels reloaded'
  console <<<status | grep -q 'server: Reloaded' || fails 'the reload has no effect'

  step 'its files are its own'
  # The file of a round is made after 5 s of it.
  find /var/lib/platon/recordings -name '*.recording' | grep -q . || fails 'there is no recording'
  ! find /var/lib/platon ! -user platon | grep . || fails 'a file of the server belongs to another user'
  [[ $(stat -c %a /var/lib/platon/server.key) == 600 ]] || fails 'others may read the key'

  own_steps

  step 'an upgrade keeps the changed configuration, key and bans, and restarts the server'
  key=$(cat /var/lib/platon/server.key)
  process=$(server_process)
  apt-get install -o Dpkg::Options::=--force-confold \
    "$debs"/next/platon-data_*.deb "$debs"/next/platon-server_*.deb "$debs"/next/platon-tools_*.deb
  until_true server_is_restarted "$process"
  grep -q '^name = "Reloaded"$' "$configuration" || fails 'the configuration has changed'
  ! grep -q "$next_comment" "$configuration" || fails 'the configuration is that of the package'
  grep -q "$next_comment" "$configuration.dpkg-dist" || fails 'the configuration of the package is not beside'
  [[ $(cat /var/lib/platon/server.key) == "$key" ]] || fails 'the key has changed'
  grep -q 203.0.113.7 /var/lib/platon/bans || fails 'the bans are gone'
  bots_play 1 || fails 'the bots do not play after the upgrade'

  step 'a stop ends it with 0'
  stop_server || fails 'the stop was a failure'

  step 'a purge leaves nothing'
  apt-get purge platon-data platon-server platon-tools
  ! find /etc /run /usr /var/lib -xdev -iname '*platon*' | grep . || fails 'these files are left'
  ! systemctl list-unit-files --no-pager | grep platon || fails 'a unit is left'
  printf 'all steps done\n'
}
