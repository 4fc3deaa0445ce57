# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Components in Python: as good as those in C++, and harmless when they are not."""

import math
import pathlib
import tempfile
import unittest

import numpy

import gestalt
from scenes import demo, synthesize


class Size(gestalt.Relation):
    """Relative size, as the relation relative_size has it"""

    values = (gestalt.Value("r_own", 0, 1, "smaller over larger"),)
    parameters = {"power": gestalt.Parameter(1.0, 0.1, 10, text="exponent")}

    def bind(self, scene):
        sizes = scene.sizes

        def measure(pairs):
            smaller, larger = numpy.sort(sizes[pairs], axis=1).T
            return (smaller / larger) ** self.power

        return measure


class NearestMean(gestalt.Classifier):
    """Which of the two classes' means is nearer"""

    def train(self, values, positive):
        return {"means": [values[positive].mean(axis=0).tolist(), values[~positive].mean(axis=0).tolist()]}

    def restore(self, state, columns):
        same, other = numpy.array(state["means"])
        assert len(same) == columns

        def predict(values):
            near = numpy.linalg.norm(values - other, axis=1) - numpy.linalg.norm(values - same, axis=1)
            return 1 / (1 + numpy.exp(-4 * near))

        return predict


class Threshold(gestalt.Solver):
    """Connected components, as the solver threshold has them"""

    parameters = {"probability": gestalt.Parameter(0.5, 0.0, 1.0)}

    def solve(self, sizes, pairs, probabilities, assembly):
        group = numpy.arange(len(sizes))
        for (a, b), p in zip(pairs, probabilities):
            if p >= self.probability:
                group[group == group[b]] = group[a]
        return group


def relation(measure=None, bind=None, low=0.0, high=1.0):
    """A relation of one value that is measured so."""

    class Own(gestalt.Relation):
        values = (gestalt.Value("r_own", low, high),)

        def bind(self, scene):
            return bind(scene) if bind else measure

    return Own


OWN_RELATION = ["structural.relations.own=on", "assembly.relations.own=on"]
OWN_SOLVER = ["decision.solver=own"]


class ComponentsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory()
        cls.scenes = synthesize(pathlib.Path(cls.work.name, "scenes"), 2)
        cls.reference = gestalt.Segmenter().segment(demo)

    @classmethod
    def tearDownClass(cls):
        cls.work.cleanup()

    def trained(self, components, overrides):
        model = pathlib.Path(self.work.name, "model.json")
        gestalt.train(self.scenes, model, overrides=overrides, components=components)
        return gestalt.Segmenter(overrides=[*overrides, f"model={model}"], components=components)

    def test_a_relation_gives_what_the_same_in_cpp_gives(self):
        result = self.trained({"own": Size}, OWN_RELATION).segment(demo)
        table = result.structural
        own, theirs = (table["values"][:, table["names"].index(name)] for name in ("r_own", "r_rs"))
        numpy.testing.assert_array_equal(own, theirs)
        self.assertGreater(len(own), 10)

    def test_parameters_come_from_the_config(self):
        components = {"own": Size}
        overrides = [*OWN_RELATION[:1], "structural.relations.own.params.power=2"]
        table = self.trained(components, overrides).segment(demo).structural
        own, theirs = (table["values"][:, table["names"].index(name)] for name in ("r_own", "r_rs"))
        numpy.testing.assert_allclose(own, theirs**2)
        with self.assertRaisesRegex(gestalt.ConfigError, r"expected a number in \[0.1, 10\]"):
            gestalt.Segmenter(overrides=[OWN_RELATION[0], "structural.relations.own.params.power=11"], components=components)

    def test_a_relation_sees_the_frame(self):
        seen = {}

        def bind(scene):
            a, b = scene.neighbours[0]
            there, back = scene.border(a, b), scene.border(b, a)
            numpy.testing.assert_array_equal(there, back[:, ::-1])
            labels = scene.labels.ravel()
            if len(there):
                self.assertEqual(set(labels[there[:, 0]]), {a + 1})
                self.assertEqual(set(labels[there[:, 1]]), {b + 1})
            self.assertLessEqual(len(there), len(scene.border(a, b, close=False)))
            numpy.testing.assert_array_equal(scene.sizes, numpy.bincount(labels)[1:])
            self.assertEqual(scene.count, len(scene.sizes))
            self.assertEqual(scene.points.shape, (480, 640, 3))
            self.assertEqual(scene.colour.dtype, numpy.uint8)
            self.assertIn("type", scene.surface(0))
            with self.assertRaises(IndexError):
                scene.surface(scene.count)
            seen["scene"], seen["depth"] = scene, scene.depth
            return lambda pairs: numpy.zeros(len(pairs))

        self.trained({"own": relation(bind=bind)}, OWN_RELATION[:1]).segment(demo)
        self.assertGreater(seen["depth"].max(), 0)
        with self.assertRaisesRegex(RuntimeError, "the frame of this scene has ended"):
            seen["scene"].sizes

    def test_a_classifier_learns_is_kept_and_decides(self):
        components, overrides = {"own": NearestMean}, ["structural.classifier=own"]
        first = self.trained(components, overrides).segment(demo)
        model = pathlib.Path(self.work.name, "model.json")
        again = gestalt.Segmenter(overrides=[*overrides, f"model={model}"], components=components).segment(demo)
        p = first.structural["probabilities"]
        numpy.testing.assert_array_equal(p, again.structural["probabilities"])
        self.assertGreater(numpy.nanstd(p), 0.05)

    def test_a_solver_decides_as_the_same_in_cpp(self):
        own = gestalt.Segmenter(overrides=OWN_SOLVER, components={"own": Threshold}).segment(demo)
        theirs = gestalt.Segmenter(overrides=["decision.solver=threshold"]).segment(demo)
        numpy.testing.assert_array_equal(own.labels, theirs.labels)

    def test_what_is_registered_is_known(self):
        gestalt.register("registered_threshold")(Threshold)
        gestalt.Segmenter(overrides=["decision.solver=registered_threshold"]).segment(demo)
        with self.assertRaisesRegex(ValueError, "registered already"):
            gestalt.register("registered_threshold")(Size)
        with self.assertRaisesRegex(TypeError, "derived from"):
            gestalt.register("function")(len)
        with self.assertRaisesRegex(gestalt.ConfigError, "did you mean"):
            gestalt.Segmenter(overrides=["decision.solver=registered_treshold"])

    def test_a_name_that_is_taken_is_refused(self):
        with self.assertRaisesRegex(gestalt.PluginError, "threshold"):
            gestalt.Segmenter(components={"threshold": Threshold})
        with self.assertRaisesRegex(ValueError, "'threshold' is already the name of a solver.*choose another"):
            gestalt.register("threshold")(Threshold)
        gestalt.Segmenter()

    def fails(self, text, components, overrides, error=gestalt.PluginError):
        """The frame fails with the component's name and this text, and the next one of others is as ever."""
        with self.assertRaises(error) as raised:
            self.trained(components, overrides).segment(demo)
        self.assertIn("own", str(raised.exception))
        self.assertIn(text, str(raised.exception))
        numpy.testing.assert_array_equal(gestalt.Segmenter().segment(demo).labels, self.reference.labels)

    def test_relations_that_misbehave_fail_the_frame(self):
        def raises(pairs):
            raise LookupError("nowhere")

        for text, measure in (
            ("nowhere", raises),
            ("r_own", lambda pairs: numpy.full(len(pairs), numpy.nan)),
            ("r_own", lambda pairs: numpy.full(len(pairs), 1.5)),
            ("returned an array of shape (3, 7)", lambda pairs: numpy.zeros((3, 7))),
            ("returned an array of shape ()", lambda pairs: 0.5),
            ("did not return an array of numbers", lambda pairs: ["a"] * len(pairs)),
            ("returned an array of shape ()", lambda pairs: None),
            ("not callable", 7),
        ):
            with self.subTest(text):
                self.fails(text, {"own": relation(measure)}, OWN_RELATION[:1])
        self.fails("nowhere", {"own": relation(bind=raises)}, OWN_RELATION[:1])

    def test_classifiers_that_misbehave_fail(self):
        def classifier(state=None, p=0.5):
            class Own(gestalt.Classifier):
                def train(self, values, positive):
                    return state

                def restore(self, state, columns):
                    return lambda values: numpy.full(len(values), p)

            return Own

        overrides = ["structural.classifier=own"]
        self.fails("not JSON serializable", {"own": classifier(state=numpy.zeros(2))}, overrides)
        self.fails("not JSON compliant", {"own": classifier(state=math.nan)}, overrides)
        self.fails("not in [0, 1]", {"own": classifier(p=1.01)}, overrides)
        self.fails("not in [0, 1]", {"own": classifier(p=math.nan)}, overrides)

    def test_solvers_that_misbehave_fail(self):
        def solver(answer):
            class Own(gestalt.Solver):
                def solve(self, sizes, pairs, probabilities, assembly):
                    return answer(len(sizes))

            return Own

        for text, answer in (
            ("returned an array of shape", lambda n: numpy.zeros(n + 1)),
            ("not a number", lambda n: numpy.full(n, numpy.nan)),
            ("did not return an array", lambda n: "all"),
            ("division by zero", lambda n: 1 / 0),
        ):
            with self.subTest(text), self.assertRaises(gestalt.PluginError) as raised:
                gestalt.Segmenter(overrides=OWN_SOLVER, components={"own": solver(answer)}).segment(demo)
            self.assertIn(text, str(raised.exception))

    def test_declarations_that_misbehave_are_told(self):
        class Raising(Threshold):
            def __init__(self, **parameters):
                raise OSError("no licence")

        class Nothing(gestalt.Relation):
            """Declares no values"""

        class Odd(Threshold):
            parameters = {"probability": gestalt.Parameter(None)}

        for text, cls, overrides in (
            ("no licence", Raising, OWN_SOLVER),
            ("declares no values", Nothing, OWN_RELATION),
            ("own", Odd, OWN_SOLVER),
        ):
            with self.subTest(text), self.assertRaisesRegex(gestalt.Error, text):
                gestalt.Segmenter(overrides=overrides, components={"own": cls})


if __name__ == "__main__":
    unittest.main()
