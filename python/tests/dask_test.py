# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Many frames and variants on a local cluster, one of whose workers is killed."""

import json
import os
import pathlib
import shutil
import signal
import tempfile
import threading
import time
import unittest

import cv2
import distributed
import numpy

import gestalt
import gestalt.dask
from scenes import demo, synthesize


class First(gestalt.Solver):
    """Every patch is an object"""

    def solve(self, sizes, pairs, probabilities, assembly):
        return range(len(sizes))


def labels(folder):
    return cv2.imread(str(pathlib.Path(folder, "labels.png")), cv2.IMREAD_UNCHANGED)


class DaskTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.work = pathlib.Path(cls.folder.name)
        cls.cluster = distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)
        cls.client = distributed.Client(cls.cluster)
        cls.scenes = []
        for i in range(24):
            scene = cls.work / "scenes" / f"scene_{i:02}"
            shutil.copytree(demo, scene)
            cls.scenes.append(scene)
        cls.expected = gestalt.Segmenter().segment(demo).labels

    @classmethod
    def tearDownClass(cls):
        cls.client.close()
        cls.cluster.close()
        cls.folder.cleanup()

    def test_a_killed_worker_loses_nothing(self):
        output = self.work / "out"
        pids = list(self.client.run(os.getpid).values())
        killed = []

        def kill():
            while not list(output.glob("*/result.json")):
                time.sleep(0.005)
            os.kill(pids[0], signal.SIGKILL)
            killed.append(len(list(output.glob("*/result.json"))))

        killer = threading.Thread(target=kill)
        killer.start()
        outcomes = gestalt.dask.segment(self.client, self.scenes, output)
        killer.join()
        self.assertLess(killed[0], len(self.scenes), "the worker was killed when all was done")
        self.assertEqual([outcome.error for outcome in outcomes], [None] * len(self.scenes))
        self.assertEqual([pathlib.Path(o.folder).name for o in outcomes], [scene.name for scene in self.scenes])
        self.assertEqual(sorted(folder.name for folder in output.iterdir()), [scene.name for scene in self.scenes])
        for outcome in outcomes:
            numpy.testing.assert_array_equal(labels(outcome.folder), self.expected)
        self.assertFalse([file for file in output.rglob("*") if ".tmp" in file.name or file.name.startswith(".")])

    def test_a_scene_that_cannot_be_used_does_not_stop_the_others(self):
        outcomes = gestalt.dask.segment(self.client, [self.work / "no_such_scene", demo], self.work / "some")
        self.assertIn("no_such_scene", outcomes[0].error)
        self.assertIsNone(outcomes[0].folder)
        numpy.testing.assert_array_equal(labels(outcomes[1].folder), self.expected)

    def test_a_config_that_does_not_hold_is_raised(self):
        with self.assertRaises(gestalt.ConfigError):
            gestalt.dask.segment(self.client, [demo], self.work / "none", overrides=["no.such=1"])

    def test_workers_take_the_config_and_model_that_are_there_now(self):
        config, model = self.work / "mine.yaml", self.work / "model.json"
        shutil.copy(pathlib.Path(gestalt.data_directory(), "models", "default.json"), model)
        config.write_text(f"schema_version: 1\nextends: default.yaml\nmodel: {model}\n")

        def patches():
            outcome = gestalt.dask.segment(self.client, [demo], self.work / "changed", config)[0]
            return json.loads(pathlib.Path(outcome.folder, "result.json").read_text())

        before = patches()
        config.write_text(f"schema_version: 1\nextends: default.yaml\nmodel: {model}\ndecision: {{figure_ground: {{separate: false}}}}\n")
        self.assertNotEqual(patches()["config"]["values"], before["config"]["values"])
        content = json.loads(model.read_text())
        forest = content["levels"]["structural"]["state"]
        leaves = [variable < 0 for variable in forest["variables"]]
        forest["values"] = [0.25 if leaf else value for leaf, value in zip(leaves, forest["values"])]
        before = patches()
        model.write_text(json.dumps(content))
        probabilities = [[pair["p"] for pair in result["pairs"]] for result in (before, patches())]
        self.assertNotEqual(*probabilities)

    def test_scenes_of_one_name_are_refused(self):
        other = self.work / "other" / demo.name
        shutil.copytree(demo, other)
        with self.assertRaisesRegex(gestalt.InputError, "has the same name as"):
            gestalt.dask.segment(self.client, [demo, other], self.work / "twice")
        self.assertFalse((self.work / "twice").exists())

    def test_a_frame_that_takes_too_long_does_not_stop_the_others(self):
        outcomes = gestalt.dask.segment(self.client, [demo], self.work / "late", overrides=["time_budget=1"])
        self.assertIn("time_budget of 1 ms", outcomes[0].error)

    def test_a_link_below_the_output_is_not_followed(self):
        output, elsewhere = self.work / "linked", self.work / "elsewhere"
        output.mkdir()
        elsewhere.mkdir()
        (output / demo.name).symlink_to(elsewhere)
        with self.assertRaisesRegex(gestalt.OutputError, "is a symbolic link"):
            gestalt.dask.segment(self.client, [demo], output)
        self.assertEqual(list(elsewhere.iterdir()), [])

    def test_components_in_python_go_to_the_workers(self):
        outcomes = gestalt.dask.segment(
            self.client, [demo] , self.work / "own", overrides=["decision.solver=own"], components={"own": First}
        )
        self.assertGreater(labels(outcomes[0].folder).max(), self.expected.max())

    def test_an_ablation_gives_what_each_variant_gives_alone(self):
        scenes = [synthesize(self.work / "labelled", 2)]
        variants = {"all": [], "no gabor": ["structural.relations.gabor=off"]}
        scores = gestalt.dask.ablate(self.client, scenes, variants, folds=2)
        self.assertEqual(list(scores), list(variants))
        for name, overrides in variants.items():
            self.assertEqual(scores[name], gestalt.cross_validate(scenes, 2, overrides=overrides))


if __name__ == "__main__":
    unittest.main()
