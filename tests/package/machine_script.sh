# shellcheck shell=bash
# What packages_test.py runs as root in a booted machine without network, after the commands of docs/hosting.md. The
# variable `debs` names the folder of the packages, `debs/next` that of a newer version.

: "${debs:?}"

# fails SENTENCE: ends the script.
fails() {
  printf 'failed: %s\n' "$1"
  systemctl status --no-pager platon-server || true
  journalctl --no-pager -u 'platon-server*' -n 40 || true
  exit 1
}

# until_true COMMAND…: waits until a command succeeds, at most 40 seconds.
until_true() {
  local end=$((SECONDS + 40))
  until "$@"; do
    [[ $SECONDS -lt $end ]] || fails "still not: $*"
    sleep 0.2
  done
}

property() { systemctl show --value --property "$1" platon-server; }
logged() { journalctl --no-pager -u platon-server | grep -q -- "$1"; }
console() { platon-server --console --config /etc/platon/server.toml; }
bots_play() { platon-bot 127.0.0.1 --count 2 --seconds 8 --json | grep -q '"connected": *2'; }
process_is() { [[ $(property MainPID) != "$1" ]] && systemctl is-active -q platon-server; }

step() { printf 'step: %s\n' "$1"; }

step 'no library of OpenGL or X11 came with the server'
! dpkg-query -W -f='${Package}\n' | grep -E '^(libgl|libegl|libglx|libopengl|libx11|mesa)' || fails 'a graphics library is installed'

step 'it runs as its own user, and systemd knows that it is ready'
[[ $(ps -o user= -p "$(property MainPID)") == platon ]] || fails 'the server runs as another user'
[[ $(property Type) == notify ]] || fails 'the unit has another type'

step 'bots play on it'
apt-get install "$debs"/platon-tools_*.deb
bots_play || fails 'the bots do not play'

step 'console, metrics and reload work'
console <<<'ban 203.0.113.7 1h' || fails 'the console does not answer'
until_true grep -q 203.0.113.7 /var/lib/platon/bans
wget -qO- http://127.0.0.1:9100/metrics | grep -q '^platon_bans 1$' || fails 'the metrics count no ban'
sed -i 's/^name = .*/name = "Reloaded"/' /etc/platon/server.toml
systemctl reload platon-server
until_true logged 'configuration and levels reloaded'
console <<<status | grep -q 'server: Reloaded' || fails 'the reload has no effect'

step 'its files are its own'
find /var/lib/platon/recordings -name '*.recording' | grep -q . || fails 'there is no recording'
! find /var/lib/platon ! -user platon | grep . || fails 'a file of the server belongs to another user'
[[ $(stat -c %a /var/lib/platon/server.key) == 600 ]] || fails 'others may read the key'

step 'a server that stands still is restarted'
process=$(property MainPID)
kill -STOP "$process"
until_true process_is "$process"
logged 'Watchdog timeout' || fails 'the watchdog did not restart it'

step 'another server runs beside it'
sed -e 's,\(run\|lib\)/platon/,&second/,' -e 's/^port = .*/port = 7778/' -e 's/:9100"/:9101"/' \
  /etc/platon/server.toml >/etc/platon/second.toml
systemctl start platon-server@second || fails 'the second server does not start'
console <<<status >/dev/null || fails 'the first server is gone'
systemctl stop platon-server@second

step 'an upgrade keeps the changed configuration, key and bans, and restarts the server'
key=$(cat /var/lib/platon/server.key)
process=$(property MainPID)
apt-get install "$debs"/next/platon-data_*.deb "$debs"/next/platon-server_*.deb "$debs"/next/platon-tools_*.deb
until_true process_is "$process"
grep -q '^name = "Reloaded"$' /etc/platon/server.toml || fails 'the configuration has changed'
[[ $(cat /var/lib/platon/server.key) == "$key" ]] || fails 'the key has changed'
grep -q 203.0.113.7 /var/lib/platon/bans || fails 'the bans are gone'
bots_play || fails 'the bots do not play after the upgrade'

step 'a stop ends it with 0'
systemctl stop platon-server
[[ $(property Result) == success ]] || fails 'the stop was a failure'

step 'a purge leaves nothing'
apt-get purge platon-data platon-server platon-tools
! find /etc /run /usr /var/lib -xdev -iname '*platon*' | grep . || fails 'these files are left'
! systemctl list-unit-files --no-pager | grep platon || fails 'a unit is left'
printf 'all steps done\n'
