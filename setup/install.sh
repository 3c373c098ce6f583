#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs the Debian packages of setup/packages.txt that are missing. Needs no network when none is.
set -eu
list=$(dirname "$0")/packages.txt
missing=""
for package in $(sed 's/#.*//' "$list"); do
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
