# shellcheck shell=bash
# What packages_test.py runs as root in a machine without network, after the commands of docs/hosting.md. The variable
# `debs` names the folder of the packages, `debs/next` that of a newer version, whose configuration has `next_comment`, and
# `debs/$old_version` that of 0.1.0. machine_booted.sh or machine_chroot.sh comes before, with the functions that differ:
# start_server, stop_server, reload_server, server_process, server_is_restarted, server_log, no_server_runs, and own_steps,
# which only this way can take. all_steps is called after them.

: "${debs:?}" "${next_comment:?}" "${old_version:?}"
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

# install_from FOLDER: installs the packages of a version, and keeps a configuration that was changed.
install_from() {
  apt-get install -o Dpkg::Options::=--force-confold \
    "$1"/platon-data_*.deb "$1"/platon-server_*.deb "$1"/platon-tools_*.deb
}

# files_of_the_server: what must survive an upgrade, with its hash.
files_of_the_server() {
  find "$configuration" /var/lib/platon -type f -print0 | sort -z | xargs -0 sha256sum
}

recorded() { find /var/lib/platon/recordings -name '*.recording' | grep -q .; }
# There are some, the server writes none, and all agree.
recordings_are_whole() {
  platon-sim verify /var/lib/platon/recordings --json | grep -q '"agree":[1-9][0-9]*,"differ":0,"invalid":0,"skipped":0'
}

purged() {
  apt-get purge platon-data platon-server platon-tools
  no_server_runs || fails 'a server runs without its program'
  ! find /etc /run /usr /var/lib -xdev -iname '*platon*' | grep . || fails 'these files are left'
  ! systemctl list-unit-files --no-pager | grep platon || fails 'a unit is left'
}

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
  wget -qO- http://127.0.0.1:19777/metrics | grep -q '^platon_bans 1$' || fails 'the metrics count no ban'
  set_key name Reloaded
  reload_server
  until_true logged 'configuration and levels reloaded'
  console <<<status | grep -q 'server: Reloaded' || fails 'the reload has no effect'

  step 'its files are its own'
  # The file of a round is made after 5 s of it.
  recorded || fails 'there is no recording'
  ! find /var/lib/platon ! -user platon | grep . || fails 'a file of the server belongs to another user'
  [[ $(stat -c %a /var/lib/platon/server.key) == 600 ]] || fails 'others may read the key'

  own_steps

  step 'an upgrade keeps the changed configuration, key and bans, and restarts the server'
  key=$(cat /var/lib/platon/server.key)
  process=$(server_process)
  install_from "$debs/next"
  until_true server_is_restarted "$process"
  grep -q '^name = "Reloaded"$' "$configuration" || fails 'the configuration has changed'
  ! grep -q "$next_comment" "$configuration" || fails 'the configuration is that of the package'
  grep -q "$next_comment" "$configuration.dpkg-dist" || fails 'the configuration of the package is not beside'
  [[ $(cat /var/lib/platon/server.key) == "$key" ]] || fails 'the key has changed'
  grep -q 203.0.113.7 /var/lib/platon/bans || fails 'the bans are gone'
  bots_play 1 || fails 'the bots do not play after the upgrade'

  step 'a stop ends it with 0'
  stop_server || fails 'the stop was a failure'

  step 'a purge leaves nothing, and no second server that runs'
  systemctl enable platon-server@second || fails 'a second server cannot be enabled'
  purged

  upgrade_from_the_old_release
  printf 'all steps done\n'
}

upgrade_from_the_old_release() {
  local before process
  step "an upgrade from $old_version keeps settings, key, bans, recordings and best times, and restarts the server"
  install_from "$debs/$old_version"
  [[ $(dpkg-query -W -f='${Version}' platon-server) == "$old_version" ]] || fails 'another version is installed'
  set_key name Kept
  printf '%s\n' '0123456789abcdef 1 600 2026-11-20T18:00:00Z Ann' >/var/lib/platon/best_times
  chown platon: /var/lib/platon/best_times
  start_server
  console <<<'ban 203.0.113.9 30d' || fails 'the console of the old release does not answer'
  until_true grep -q 203.0.113.9 /var/lib/platon/bans
  bots_play 6 || fails 'the bots do not play on the old release'
  until_true recordings_are_whole
  before=$(files_of_the_server)
  process=$(server_process)
  install_from "$debs"
  until_true server_is_restarted "$process"
  [[ $(dpkg-query -W -f='${Version}' platon-server) != "$old_version" ]] || fails 'the old version is installed'
  [[ $(files_of_the_server) == "$before" ]] || fails 'these files are others than before'
  console <<<status | grep -q 'server: Kept' || fails 'the settings are gone'
  console <<<bans | grep -q 203.0.113.9 || fails 'the bans are gone'
  recordings_are_whole || fails 'the recordings are damaged'
  bots_play 1 || fails 'the bots do not play after the upgrade'
  stop_server || fails 'the stop was a failure'
  purged
}
