#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
# What a new user does in a fresh Debian 12 with the packages in /packages; ends with 1 at the first thing that fails.
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
cd /user

step() {
  echo "== $*"
}

step "install the command alone"
apt-get update -qq
apt-get install -y -qq --no-install-recommends /packages/gestalt_*.deb >log 2>&1 || { tail -20 log; exit 1; }
gestalt --version
gestalt synthesize --category complex_scene --seed 5 --count 4 --output scenes
gestalt segment scenes --output out

step "the viewer could be installed, too"
apt-get install -y -qq --no-install-recommends --simulate /packages/gestalt-view_*.deb >log 2>&1 || { tail -20 log; exit 1; }
gestalt segment scenes --output viewed --view 2>log && exit 1
grep -q "install the package gestalt-view" log

step "install what plugins are made with"
apt-get install -y -qq --no-install-recommends /packages/libgestalt-dev_*.deb g++ make libgtest-dev >log 2>&1 ||
  { tail -20 log; exit 1; }

step "a relation of one's own"
gestalt new-plugin relation own_relation
cmake -S own_relation -B own_relation/build
cmake --build own_relation/build
ctest --test-dir own_relation/build --output-on-failure

step "train and evaluate with it"
gestalt train scenes --config own_relation/config.yaml --output own_relation/own_relation.json
gestalt evaluate scenes --config own_relation/config.yaml
gestalt segment scenes --config own_relation/config.yaml --output own_out
gestalt inspect own_out/complex_scene_5_000 --config own_relation/config.yaml --output page.html
grep -q '"r_own_relation"' page.html

step "call it from Python"
apt-get install -y -qq --no-install-recommends /packages/python3-gestalt_*.deb >log 2>&1 || { tail -20 log; exit 1; }
cat >call.py <<'PYTHON'
import pathlib
import gestalt

scene = gestalt.read_scene(min(pathlib.Path("scenes").glob("*/depth.png")).parent)
overrides = [f"model={pathlib.Path('own_relation/own_relation.json').resolve()}"]
segmenter = gestalt.Segmenter("own_relation/config.yaml", overrides)
result = segmenter(scene.colour, scene.depth, scene.camera)
print(result, result.structural["names"])
assert result.objects and len(result.structural["names"]) == result.structural["values"].shape[1]
PYTHON
python3 call.py
