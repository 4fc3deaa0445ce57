# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pages of reference, made of what the command tells: plugins of their declarations, keys of the schema of configs,
commands of their help."""

import json
import re
import subprocess

KINDS = {
    "clusterer": ("Clusterers", "Signal level: pixels to planar patches. `signal.clusterer` of a config names one."),
    "fitter": (
        "Fitters",
        "Primitive level: a surface model of a patch. `primitive.fitters` of a config lists them; the first must fit "
        "any patch.",
    ),
    "relation": (
        "Relations",
        "Structural and assembly level: values of a pair of patches. `structural.relations` and `assembly.relations` of "
        "a config list them.",
    ),
    "classifier": (
        "Classifiers",
        "A pair's values to the probability that both patches are of one object. Each level of a config has one.",
    ),
    "solver": (
        "Solvers",
        "Global decision: the graph of probabilities to objects. `decision.solver` of a config names one.",
    ),
}


class Command:
    """The gestalt command, with no plugins but those installed with it."""

    def __init__(self, path):
        self.path = path

    def text(self, *arguments):
        outcome = subprocess.run([self.path, *arguments], capture_output=True, text=True, check=False, env={})
        if outcome.returncode:
            raise RuntimeError(f"gestalt {' '.join(arguments)}: {outcome.stderr}")
        return outcome.stdout

    def json(self, *arguments):
        return json.loads(self.text(*arguments))


def cell(text):
    """Text in a cell of a table: a bar ends it, and what looks like HTML or emphasis is neither."""
    text = str(text).replace("\n", " ")
    return re.sub(r"([\\|<>*_`\[\]$])", r"\\\1", text)


def code(text):
    text = str(text).replace("|", r"\|")
    return f"`{text}`" if text else ""


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def spelled(value):
    if isinstance(value, bool):
        return str(value).lower()
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def range_text(bounds):
    low, high = bounds
    if low is None and high is None:
        return ""
    # Round brackets where nothing bounds it.
    left = f"[{spelled(low)}" if low is not None else "(-∞"
    right = f"{spelled(high)}]" if high is not None else "∞)"
    return f"{left}, {right}"


def parameter_row(parameter):
    words = ", ".join(parameter.get("choices", [])) or range_text(parameter.get("range", (None, None)))
    return [
        code(parameter["name"]),
        parameter["type"],
        cell(words),
        cell(parameter["unit"]),
        code(spelled(parameter["default"])),
        cell(parameter["text"]),
    ]


def value_pictures(component, pictures):
    """The pictures of a relation's values, level by level."""
    cells = []
    for value in component.get("values", []):
        for level, (file, low, high) in sorted(pictures.get(value["name"], {}).items(), reverse=True):
            caption = f"{value['name']}, {level} level: from {low:.3g} (dark) to {high:.3g} (bright)"
            options = f":width: 420px\n:alt: {json.dumps(caption)}"
            cells.append(f"```{{figure}} ../../pictures/{file}\n{options}\n\n{cell(caption)}\n```\n")
    return "\n".join(cells)


def component_section(component, pictures):
    parts = [f"## {component['name']}\n", cell(component["description"]) + "\n", f"Version {component['version']}."]
    needs = [
        word for key, word in (("needs_colour", "colour"), ("needs_border", "a common border")) if component.get(key)
    ]
    if needs:
        parts[-1] += f" Needs {' and '.join(needs)}."
    parts[-1] += "\n"
    if "values" in component:
        rows = [[code(v["name"]), cell(range_text(v["range"])), cell(v["text"])] for v in component["values"]]
        parts.append(table(["value", "range", "meaning"], rows))
        parts.append(value_pictures(component, pictures))
    if component["parameters"]:
        head = ["parameter", "type", "range", "unit", "default", "meaning"]
        parts.append(table(head, map(parameter_row, component["parameters"])))
    else:
        parts.append("No parameters.\n")
    return "\n".join(parts)


def plugin_pages(command, pictures):
    """Markdown by kind, and the page that leads to them. pictures: of each value of a relation, by level."""
    components = command.json("plugins", "list", "--json")["components"]
    pages, overview = {}, []
    for kind, (title, text) in KINDS.items():
        described = [
            command.json("plugins", "describe", kind, component["name"], "--json")
            for component in components
            if component["kind"] == kind
        ]
        pages[kind] = f"# {title}\n\n{text}\n\n" + "\n".join(
            component_section(component, pictures) for component in described
        )
        rows = [[f"[{c['name']}]({kind}.md#{c['name']})", cell(c["description"])] for c in described]
        overview.append(f"## {title}\n\n{text}\n\n" + table(["plugin", "what it does"], rows))
    contents = "\n".join(KINDS)
    pages["index"] = (
        "# Plugins\n\nMade of the plugins' own declarations, as `gestalt plugins list` and `gestalt plugins describe "
        f"NAME` tell them.\n\n```{{toctree}}\n:hidden:\n\n{contents}\n```\n\n" + "\n".join(overview)
    )
    return pages


def schema_type(schema):
    if "const" in schema:
        return spelled(schema["const"])
    if "allOf" in schema:
        name = schema["allOf"][0]["$ref"].rsplit("/", 1)[1]
        kind, listed = name.removesuffix(".list"), name.endswith(".list")
        return f"list of [{kind}s](plugins/{kind}.md)" if listed else f"[{kind}](plugins/{kind}.md)"
    if "enum" in schema:
        if True in schema["enum"]:
            return "boolean"
        return ", ".join(code(word) for word in schema["enum"])
    if schema["type"] == "array":
        return "list of texts"
    if isinstance(schema["type"], list):
        return "text"
    return {"string": "text", "object": "section"}.get(schema["type"], schema["type"])


def key_row(key, schema):
    kind = ", ".join(
        filter(None, [schema_type(schema), cell(range_text((schema.get("minimum"), schema.get("maximum"))))])
    )
    default = code(spelled(schema["default"])) if "default" in schema else ""
    return [code(key), kind, default, cell(schema.get("description", ""))]


def key_sections(schema, path=""):
    """A table of the keys that have values, then a section for each that has keys."""
    head = ["key", "value", "default", "meaning"]
    rows = [key_row(key, value) for key, value in schema["properties"].items() if "properties" not in value]
    sections = [table(head, rows)] if rows else []
    for key, value in schema["properties"].items():
        if "properties" in value:
            sections += [f"## {path}{key}\n", cell(value["description"]) + ".\n", *key_sections(value, f"{path}{key}.")]
    return sections


def config_page(command):
    schema = command.json("config", "schema")
    return (
        "# Keys of a config\n\nEvery key that a config may have, made of the schema that `gestalt config schema` prints. "
        "[Configs](../config.md) explains how files merge and how components are written.\n\n"
        + "\n".join(key_sections(schema))
    )


def subcommands(help_text):
    """Names of the section "Subcommands:" of a help text."""
    section = re.search(r"^Subcommands:\n((?:  .*\n?)+)", help_text, re.M)
    return re.findall(r"^  ([a-z][a-z-]*)", section.group(1), re.M) if section else []


def command_page(command):
    parts = ["# Commands\n\nThe help of every command, as `gestalt COMMAND --help` prints it.\n"]

    def add(words):
        text = command.text(*words, "--help")
        title = f"gestalt {' '.join(words)}".strip()
        parts.append(f"{'#' * (2 if len(words) < 2 else 3)} {title}\n\n```text\n{text.strip()}\n```\n")
        for word in subcommands(text):
            add([*words, word])

    add([])
    return "\n".join(parts)
