#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs the Debian packages of setup/packages.txt that are missing, up to a section: install.sh [demo|build|test],
# test if none is given. Needs no network when none is missing.
set -eu
list=$(dirname "$0")/packages.txt
section=${1:-test}
grep -qxF "[$section]" "$list" || {
  sections=$(sed -n 's/^\[\(.*\)\]$/\1/p' "$list" | paste -sd, | sed 's/,/, /g')
  echo "setup/install.sh: there is no section '$section': it is $sections" >&2
  exit 2
}
# Lines up to the first section after it.
wanted=$(awk -v last="[$section]" \
  '/^\[/ { if (done) exit; if ($0 == last) done = 1; next } { sub(/#.*/, ""); print }' "$list")
missing=""
for package in $wanted; do
  status=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
  [ "$status" = "install ok installed" ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

sudo=""
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || {
    echo "setup/install.sh: these packages are missing and need root to install: apt-get install$missing" >&2
    exit 1
  }
  sudo=sudo
fi
echo "setup/install.sh: installing$missing"
log=$(mktemp)
export DEBIAN_FRONTEND=noninteractive
if ! { $sudo apt-get update && $sudo apt-get install -y --no-install-recommends $missing; } >"$log" 2>&1; then
  tail -n 20 "$log" >&2
  echo "setup/install.sh: apt-get could not install these packages; its log is $log" >&2
  exit 1
fi
rm -f "$log"
