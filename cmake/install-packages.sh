#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# install-packages.sh SECTION...: installs what is missing of those sections of apt-packages.txt (Debian, as root or with sudo).
set -euo pipefail
cd "$(dirname "$0")/.."

wanted=()
for section in "$@"; do
  mapfile -t packages < <(awk -v section="[$section]" '
    /^[[:space:]]*(#|$)/ { next }
    /^\[/ { inside = ($1 == section); next }
    inside { print $1 }' apt-packages.txt)
  [ ${#packages[@]} -gt 0 ] || { echo "apt-packages.txt: expected a section [$section] with packages" >&2; exit 2; }
  wanted+=("${packages[@]}")
done

missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "missing packages: ${missing[*]}; run as root, or install sudo" >&2; exit 2; }
  as_root=(sudo)
fi
echo "installing: ${missing[*]}"
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
