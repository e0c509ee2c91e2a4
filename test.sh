#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# test.sh: installs what is missing, builds, and runs every test: release, sanitizers, fuzz targets, mutants.
# Debian 12, as root or with sudo; about 25 minutes on two cores. On demand, not here: the presets tsan and coverage,
# and tests/mutants.py --all.
#   FUZZ_SECONDS=60 FUZZ_SEED=2 ./test.sh      how long each fuzz target runs, and where its search starts
set -euo pipefail
cd "$(dirname "$0")"
fuzz_seconds=${FUZZ_SECONDS:-20}

step() { printf '\n== %s (%d s so far)\n' "$1" "$SECONDS"; }

step "packages"
cmake/install-packages.sh build dev proofs
cmake/install-packages.sh peers || echo "section peers of apt-packages.txt is left out: no tests of Embree"

step "release: build and test"
cmake --preset release -DGNOMON_TESTS=ON >/dev/null
cmake --build --preset release
ctest --preset release -j "$(nproc)"

step "address and undefined-behaviour sanitizers: build and test"
cmake --preset asan >/dev/null
cmake --build --preset asan
# What the ledger says and enumerations of test code are no different under sanitizers, only slower.
ctest --preset asan -j "$(nproc)" -E "^LedgerPointers|^ProofsExhaustive"
for question in shaft-box shaft-sphere; do
  build/asan/gnomon fuzz "$question" --trials 4000 --out build/asan/campaign | tail -n 1
done
build/asan/gnomon replay tests/corpus/shaft.txt >/dev/null
build/asan/gnomon report build/asan/campaign -o build/asan/campaign/index.html

step "fuzz targets, $fuzz_seconds s each"
fuzz/run_targets.sh "$fuzz_seconds" build/asan

step "mutants"
python3 tests/mutants.py --subset

step "done"
