# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""The JSON schema of configs, by an independent validator: it takes what `gestalt config check` takes and refuses what
that refuses.

    schema_test.py GESTALT SCHEMA SOURCES
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import jsonschema
import yaml

GESTALT, SCHEMA, SOURCES = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
VALIDATOR = jsonschema.Draft7Validator(json.loads(SCHEMA.read_text()))

COMPLETE = """schema_version: 1
signal: {clusterer: normals}
primitive: {fitters: [plane]}
structural: {relations: [gabor], classifier: svm}
decision: {solver: graph_cut}
"""

RIGHT = {
    "the least": COMPLETE,
    "only another": "schema_version: 1\nextends: default.yaml\n",
    "a list of every form": "schema_version: 1\nextends: default.yaml\nstructural:\n  relations:\n    - gabor\n"
    "    - {plugin: fourier}\n    - {name: coarse, plugin: colour_histogram, params: {bins: 2}}\n",
    "a mapping of every form": "schema_version: 1\nextends: default.yaml\nstructural:\n  relations:\n    gabor: off\n"
    "    fourier: on\n    coarse: {plugin: colour_histogram, params: {bins: 2}}\n    again: gabor\n"
    "    border_curvature: {values: [r_cu3]}\n    colour_histogram: {values: all, params: {bins: 3}}\n",
    "params of the plugin below": "schema_version: 1\nextends: default.yaml\n"
    "assembly: {classifier: {params: {trees: 30}}}\n",
    "params of a listed plugin below": "schema_version: 1\nextends: default.yaml\n"
    "structural: {relations: [{name: colour_histogram, params: {bins: 2}}]}\n",
    "switches as truth values": "schema_version: 1\nextends: default.yaml\n"
    "structural: {classifier: {plugin: svm, params: {class_weights: yes}}}\n",
    "no model": "schema_version: 1\nextends: default.yaml\nmodel:\n",
    "the sensor": "schema_version: 1\nextends: default.yaml\nsensor: {noise: realsense}\n",
}

WRONG = {
    "no version": COMPLETE.replace("schema_version: 1\n", ""),
    "another version": COMPLETE.replace("schema_version: 1", "schema_version: 2"),
    "a version in quotes": COMPLETE.replace("schema_version: 1", "schema_version: '1'"),
    "no mapping": "gabor\n",
    "an unknown key": COMPLETE + "modle: none\n",
    "an unknown key of a section": COMPLETE.replace("{clusterer:", "{clustrer: normals, clusterer:"),
    "an unknown key of a component": COMPLETE.replace("clusterer: normals", "clusterer: {plugin: normals, parms: {}}"),
    "no solver": COMPLETE.replace("decision: {solver: graph_cut}\n", ""),
    "no clusterer": COMPLETE.replace("clusterer: normals", ""),
    "no fitters": COMPLETE.replace("fitters: [plane]", ""),
    "a list for a section": COMPLETE.replace("{solver: graph_cut}", "[graph_cut]"),
    "a list for a component": COMPLETE.replace("solver: graph_cut", "solver: [graph_cut]"),
    "a word for a list": COMPLETE.replace("[plane]", "plane"),
    "a switched component that is not of a list": COMPLETE.replace("clusterer: normals", "clusterer: off"),
    "an unknown plugin": COMPLETE.replace("normals", "norm_als"),
    "a plugin of another kind": COMPLETE.replace("normals", "gabor"),
    "an unknown plugin in a list": COMPLETE.replace("[gabor]", "[gabr]"),
    "an unknown plugin of a named one": COMPLETE.replace("[gabor]", "{fine: {plugin: gabr}}"),
    "an item without a plugin": COMPLETE.replace("[gabor]", "[{params: {}}]"),
    "a switch in a list": COMPLETE.replace("[gabor]", "[gabor, off]"),
    "a name with a dot": COMPLETE.replace("[gabor]", "[{name: a.b, plugin: gabor}]"),
    "a key with a dot": COMPLETE.replace("[gabor]", "{a.b: gabor}"),
    "a value of another relation": COMPLETE.replace("[gabor]", "[{plugin: gabor, values: [r_co]}]"),
    "no values": COMPLETE.replace("[gabor]", "[{plugin: gabor, values: []}]"),
    "values of a fitter": COMPLETE.replace("[plane]", "[{plugin: plane, values: all}]"),
    "an unknown level": COMPLETE + "levels: assembly\n",
    "a list for a file": COMPLETE + "model: [a.json]\n",
    "one directory": COMPLETE + "plugin_directories: plugins\n",
    "two bases": "schema_version: 1\nextends: [default.yaml, paper.yaml]\n",
    "an unknown sensor": COMPLETE + "sensor: {noise: realsens}\n",
    "too small a size": COMPLETE.replace("classifier: svm", "classifier: svm, minimum_size: 0"),
    "too large a size": COMPLETE.replace("classifier: svm", "classifier: svm, minimum_size: 1000001"),
    "a size in quotes": COMPLETE.replace("classifier: svm", "classifier: svm, minimum_size: '30'"),
    "half a pixel": COMPLETE.replace("classifier: svm", "classifier: svm, minimum_size: 30.5"),
}


def run(*arguments, **options):
    return subprocess.run([GESTALT, *map(str, arguments)], capture_output=True, text=True, check=False, **options)


def command_takes(text):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "config.yaml"
        file.write_text(text)
        outcome = run("config", "check", file)
    if outcome.returncode not in (0, 2):
        raise AssertionError(f"gestalt config check: {outcome.stderr}")
    return outcome.returncode == 0


def complaints(text):
    errors = VALIDATOR.iter_errors(yaml.safe_load(text))
    return [f"{'/'.join(map(str, error.absolute_path))}: {error.message[:200]}" for error in errors]


def wrong_values(parameter):
    """Values that a parameter does not take: of another type, and out of its range or words."""
    if parameter["type"] in ("boolean", "choice"):
        return ["neither", 7]
    low, high = parameter["range"]
    step = 1 if parameter["type"] == "integer" else 1e-3 * max(1, abs(low or 0), abs(high or 0))
    values = ["many", "'3'"]
    if low is not None:
        values.append(low - step)
    if high is not None:
        values.append(high + step)
    return values


def parameters():
    """A config with one parameter set, for each parameter of each plugin: (name, text up to the value, parameter)."""
    below = "schema_version: 1\nextends: default.yaml\n"
    places = {
        "clusterer": "signal: {{clusterer: {{plugin: {0}, params: {{{1}: ",
        "fitter": "primitive: {{fitters: {{{0}: {{params: {{{1}: ",
        "relation": "structural: {{relations: {{own: {{plugin: {0}, params: {{{1}: ",
        "classifier": "structural: {{classifier: {{plugin: {0}, params: {{{1}: ",
        "solver": "decision: {{solver: {{plugin: {0}, params: {{{1}: ",
    }
    for component in json.loads(run("plugins", "list", "--json").stdout)["components"]:
        kind, name = component["kind"], component["name"]
        for parameter in json.loads(run("plugins", "describe", kind, name, "--json").stdout)["parameters"]:
            yield f"{kind} {name}.{parameter['name']}", below + places[kind].format(name, parameter["name"]), parameter


def closed(text):
    return text + "}" * (text.count("{") - text.count("}")) + "\n"


def spelled(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"{value:.12g}" if isinstance(value, float) else str(value)


class Schema(unittest.TestCase):
    def test_is_a_schema(self):
        jsonschema.Draft7Validator.check_schema(VALIDATOR.schema)

    def test_is_what_the_command_prints(self):
        self.assertEqual(json.loads(run("config", "schema").stdout), VALIDATOR.schema)

    def test_takes_every_config_of_ours(self):
        files = sorted(SOURCES.glob("configs/**/*.yaml")) + sorted(SOURCES.glob("bench/**/*.yaml"))
        self.assertGreater(len(files), 50)
        for file in files:
            with self.subTest(file=file.name):
                self.assertEqual(complaints(file.read_text()), [])

    def test_takes_what_the_command_prints(self):
        for config in ("default.yaml", "paper.yaml"):
            self.assertEqual(complaints(run("config", "print", config).stdout), [])

    def test_takes_what_is_right(self):
        for name, text in RIGHT.items():
            with self.subTest(name):
                self.assertTrue(command_takes(text))
                self.assertEqual(complaints(text), [])

    def test_refuses_what_is_wrong(self):
        for name, text in WRONG.items():
            with self.subTest(name):
                self.assertFalse(command_takes(text))
                self.assertNotEqual(complaints(text), [])

    def test_knows_every_parameter(self):
        count = 0
        for name, text, parameter in parameters():
            count += 1
            with self.subTest(name):
                right = closed(text + spelled(parameter["default"]))
                self.assertEqual(complaints(right), [])
                self.assertTrue(command_takes(right), right)
                unknown = right.replace(parameter["name"] + ": ", parameter["name"] + "_: ")
                self.assertNotEqual(complaints(unknown), [])
                for value in wrong_values(parameter):
                    wrong = closed(text + spelled(value))
                    self.assertNotEqual(complaints(wrong), [], wrong)
                    self.assertFalse(command_takes(wrong), wrong)
        self.assertGreater(count, 30)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
