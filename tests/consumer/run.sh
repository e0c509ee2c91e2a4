#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh BUILD CXX: installs BUILD into a prefix of its own and uses it as strangers do. One line and exit status 1 on the
# first thing that is not as promised.
set -euo pipefail
build=$1 cxx=$2
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() { echo "consumer: $1" >&2; [ ! -f "$work/log" ] || tail -n 30 "$work/log" >&2; exit 1; }
quiet() { "$@" >"$work/log" 2>&1; }
configure() {  # PREFIX DIR COMPONENTS
  quiet cmake -S "$here" -B "$work/$2" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$cxx" \
    -DCMAKE_PREFIX_PATH="$work/$1" -DCONSUMER_COMPONENTS="$3"
}

quiet cmake --install "$build" --prefix "$work/all" || fail "cmake --install failed"
quiet cmake --install "$build" --prefix "$work/mit" --component fast || fail "cmake --install --component fast failed"

# Everything: built with -O3 -march=native and run.
configure all full "fast;exact" || fail "find_package(gnomon COMPONENTS fast exact) failed"
quiet cmake --build "$work/full" -j1 --target consumer || fail "the consumer of fast and exact does not build"
"$work/full/consumer" || fail "a promise does not hold in the consumer"
if ninja -C "$work/full" -t deps | grep -q "/CGAL/"; then fail "an installed header includes CGAL"; fi
"$work/all/bin/gnomon" list >"$work/log" || fail "the installed command does not run"
[ -s "$work/log" ] || fail "the installed command says nothing"

# The MIT part alone, every header of it: nothing of exact/ is there, and nothing of CGAL or GMP is read or linked.
[ ! -e "$work/mit/include/gnomon/exact" ] || fail "component fast installs headers of exact/"
[ ! -e "$work/mit/bin" ] || fail "component fast installs the command"
if find "$work/mit" -name 'GPL*' | grep -q .; then fail "component fast installs the GPL"; fi
configure mit part "fast" || fail "find_package(gnomon COMPONENTS fast) failed without exact"
quiet cmake --build "$work/part" -j1 || fail "the consumer of fast alone does not build"
"$work/part/consumer_fast" || fail "the consumer of fast alone fails"
ninja -C "$work/part" -t deps >"$work/deps"
grep -q "fast/shaft.h" "$work/deps" || fail "expected dependencies to look at, found none"
if grep -E "CGAL|gmp|mpfr|boost" "$work/deps"; then fail "a header of fast/ or scene/ includes CGAL, GMP or Boost"; fi
if ldd "$work/part/consumer_fast" | grep -E "gmp|mpfr"; then fail "gnomon::fast links GMP"; fi

# What can't be had is said.
if configure mit none "exact"; then fail "component exact was found where it is not installed"; fi
tr -s ' \n' ' ' <"$work/log" | grep -q '"exact" is not installed here' || fail "expected words about the missing component"
if configure all none "nosuch"; then fail "component nosuch was found"; fi
tr -s ' \n' ' ' <"$work/log" | grep -q 'no component "nosuch"; expected one of: fast' || fail "expected the known components"

# Headers refuse -ffast-math.
headers=0
for header in "$work"/mit/include/gnomon/fast/*.h; do
  name=fast/$(basename "$header")
  echo "#include \"$name\"" >"$work/refuse.cpp"
  if quiet "$cxx" -std=c++20 -I "$work/mit/include/gnomon" -ffast-math -fsyntax-only "$work/refuse.cpp"; then
    fail "$name compiles with -ffast-math"
  fi
  grep -q "compile without -ffast-math" "$work/log" || fail "$name: expected our #error with -ffast-math"
  quiet "$cxx" -std=c++20 -I "$work/mit/include/gnomon" -fsyntax-only "$work/refuse.cpp" || fail "$name does not compile"
  headers=$((headers + 1))
done
[ "$headers" -ge 5 ] || fail "expected headers in fast/, found $headers"
echo "consumer: all held ($headers headers refuse -ffast-math)"
