#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# report.sh: installs what is missing, builds, runs the main job, and writes build/report/index.html.
# Debian 12, as root or with sudo; about five minutes the first time on two cores.
#   TRIALS=1000000 ./report.sh     more trials a row (default 200000 for boxes, a quarter of it for balls)
set -euo pipefail
cd "$(dirname "$0")"
trials=${TRIALS:-200000}

cmake/install-packages.sh build
cmake --preset release -DGNOMON_TESTS=OFF >/dev/null
cmake --build --preset release --target gnomon

gnomon=build/release/gnomon
rm -rf build/report
mkdir -p build/report
status=0
"$gnomon" fuzz shaft-box --trials "$trials" --out build/report | tail -n 1 || status=$?
"$gnomon" fuzz shaft-sphere --trials $((trials / 4 > 0 ? trials / 4 : 1)) --out build/report | tail -n 1 || status=$?
# Renderers ask each shaft about many boxes: the batch rows beside the others, with set-up shared.
"$gnomon" fuzz shaft-box --trials "$trials" --seed 2 --out build/report --distribution uniform@64 \
    --distribution offset@64 --distribution integer-grid@64 --distribution near-touch@64 | tail -n 1 || status=$?
"$gnomon" report build/report -o build/report/index.html
echo "report: $PWD/build/report/index.html"
[ "$status" -eq 0 ] || echo "a promise was broken: see the report" >&2
exit "$status"
