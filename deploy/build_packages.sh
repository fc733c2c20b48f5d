#!/usr/bin/env bash
# Builds the Debian packages of this tree into build/packages/, checks them with lintian and prints their paths.
# Called by `./platon package`.
set -euo pipefail

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
packages=$root/build/packages
work=$packages/work/platon

# dpkg-buildpackage wants a folder debian/ at the top of the tree: it gets a tree of links to ours, and one debian/.
mkdir -p "$work"
find "$work" -mindepth 1 -maxdepth 1 -not -name 'obj-*' -exec rm -rf {} +
for entry in "$root"/*; do
  [[ $entry == "$root/build" ]] || ln -s "$entry" "$work/"
done
cp -r "$root/deploy/debian" "$work/debian"
rm -f "$packages"/*.deb "$packages"/work/*.deb

# The build has a home folder of its own, where ccache would find nothing.
if [[ ${CMAKE_CXX_COMPILER_LAUNCHER-} == *ccache ]]; then
  CCACHE_DIR=$(ccache --get-config cache_dir)
  export CCACHE_DIR
fi
# Debug symbols would take a quarter of the time: who wants them names other options.
export DEB_BUILD_OPTIONS=${DEB_BUILD_OPTIONS-noautodbgsym} DEB_CXXFLAGS_STRIP=${DEB_CXXFLAGS_STRIP--g}
cd "$work"
# Without cleaning before: what has not changed is not built again.
dpkg-buildpackage --build=binary --unsigned-source --unsigned-changes --no-pre-clean >&2
lintian --fail-on error,warning "$packages"/work/*.changes >&2
mv "$packages"/work/*.deb "$packages/"
printf '%s\n' "$packages"/*.deb
