#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# report.sh: installs what is missing, builds, runs the main job, and writes build/report/index.html.
# Debian 12, as root or with sudo; about six minutes the first time on two cores.
#   TRIALS=1000000 ./report.sh     more trials a row (default 200000 for boxes, a quarter of it for balls)
#   QUERIES=100000 ./report.sh     more queries a workload of a scene (default 5000)
set -euo pipefail
cd "$(dirname "$0")"
trials=${TRIALS:-200000}
queries=${QUERIES:-5000}

cmake/install-packages.sh build
# Other projects to compare with: the report does without those that can't be had.
cmake/install-packages.sh peers || echo "going on without the packages of section peers" >&2
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
# Other bounding volumes against shafts; lists of candidates and pairs of patches, in small scenes and in the office.
few=$((trials / 20 > 0 ? trials / 20 : 1))
for question in shaft-slabs shaft-oriented-box shaft-ellipsoid; do
  "$gnomon" fuzz "$question" --trials "$few" --out build/report --distribution uniform --distribution integer-grid \
      --distribution near-touch | tail -n 1 || status=$?
done
for question in shaft-candidates patch-pair; do
  "$gnomon" fuzz "$question" --trials "$few" --out build/report --distribution integer-grid \
      --distribution near-touch --distribution scene:office | tail -n 1 || status=$?
done

# Shadows and first hits in scenes of two thousand to ninety thousand faces, and what the scenes look like.
# cgal-epick leaves out scenes with balls; the method that looks at every face would take most of the time.
scenes=(living-room office sphereflake tetra city)
methods=()
listed=$("$gnomon" list)
for method in bvh-naive-f32 bvh-certified-f32 bvh-exact reference embree embree-robust cgal-epick; do
  if grep -q "^  $method " <<<"$listed"; then methods+=(--method "$method"); fi
done
"$gnomon" measure "${scenes[@]}" "${methods[@]}" --workload primary --workload surface --workload hard \
    --workload primary-rays --workload hard-rays --variant given --queries "$queries" --rounds 3 \
    --json build/report/scenes.json >/dev/null || status=$?

# Radiosity: the paper's candidate lists next to its Table 1, and batches of rays next to Embree.
methods=()
for method in bvh-naive-f32 bvh-certified-f32 bvh-exact shaft-naive-f32 shaft-certified-f32 shaft-exact embree \
    embree-robust embree-high embree-pairs embree-unfiltered cgal-epick; do
  if grep -q "^  $method " <<<"$listed"; then methods+=(--method "$method"); fi
done
"$gnomon" measure office office-fine "${methods[@]}" --workload radiosity --variant given \
    --queries $((2 * queries)) --rounds 3 --json build/report/radiosity.json >/dev/null || status=$?
"$gnomon" measure classroom:2 floor:2 "${methods[@]}" --workload radiosity@16 --workload radiosity@400 \
    --variant given --queries "$queries" --rounds 3 --json build/report/batches.json >/dev/null || status=$?

for scene in "${scenes[@]}"; do
  "$gnomon" render "$scene" --method bvh-exact --size 480x360 -o "build/report/$scene.png"
done

"$gnomon" report build/report -o build/report/index.html
echo "report: $PWD/build/report/index.html"
[ "$status" -eq 0 ] || echo "a promise was broken: see the report" >&2
exit "$status"
