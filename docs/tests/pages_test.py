# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs every command and snippet of a page, in order, in a folder of its own.

    pages_test.py BUILD FOLDER PAGE     PAGE relative to the sources

What a fenced block is, its language says:

    sh        commands; those of all blocks run in one shell that ends at the first that fails
    yaml      a config, for `gestalt config check`, or a camera file, for `gestalt info`
    cpp       is compiled, unless its first line is `// FILE`
    python    is run
    text      output and schemes; not run

A block whose first line is `// FILE` or `# FILE` is written there, for the commands after it. Commands in the text,
like `gestalt config check FILE`, must exist and have the options that they are shown with.
"""

import os
import pathlib
import re
import shlex
import subprocess
import sys

SOURCES = pathlib.Path(__file__).resolve().parents[2]

# Words that stand for what a reader has, and what the test takes for them. The first that fits is taken.
PLACEHOLDERS = {
    r"scripts/(coverage|fuzz|soak|valgrind)\b[^\n]*": r"(cd scripts && test -x \1)",  # they take long, and are in Python
    r"python3 tests/soak/write_page.py[^\n]*": "test -f tests/soak/write_page.py",  # of what those report
    r"scripts/(\w+)": r"bash -n scripts/\1",  # these build or test everything themselves
    r"\(cd build && cpack\)": "test -f build/CPackConfig.cmake",  # scripts/test_packages
    r"out/SCENE\b": "out/demo_scene",
    r"\bSCENE\.\.\.": "examples/demo_scene",
    r"\bSCENE\b": "examples/demo_scene",
    r"\bSCENES\b": "prepared/scenes",
    r"\bDATA\b": "prepared/scenes",
    r"\bDIR\b": "installed",
    r"\bmy_driver\b": "ls -d examples/demo_scene",
}


def placed(text):
    for pattern, replacement in PLACEHOLDERS.items():
        text = re.sub(pattern, replacement, text)
    return text


class Block:
    def __init__(self, language, line, text):
        self.language, self.line, self.text = language, line, text

    @property
    def file(self):
        """The file that its first line names."""
        named = re.match(r"(?://|#) ([\w./-]+\.\w+)\n", self.text)
        return named.group(1) if named else None


def blocks_of(page):
    """Fenced blocks of a page. Everything that looks like code must be one, with its language."""
    blocks, language, start, lines = [], None, 0, []
    for number, line in enumerate(page.splitlines(), 1):
        fence = re.match(r"\s*```(.*)$", line)
        if fence and language is None:
            language, start, lines = fence.group(1).strip(), number, []
        elif fence:
            blocks.append(Block(language, start, "\n".join(lines) + "\n"))
            language = None
        elif language is not None:
            lines.append(line)
        elif re.match(r"    (gestalt|cmake|scripts/|build/)", line):
            raise SystemExit(f"line {number}: an indented command; write it as a fenced block, ```sh")
    return blocks


# What pages need that they do not make themselves.


def synthesize(folder, count=6, width=320, height=240):
    size = ["--width", str(width), "--height", str(height)]
    command = ["gestalt", "synthesize", "--category", "complex_scene", "--seed", "1", "--count", str(count), *size]
    subprocess.run([*command, "--output", folder], check=True, stdout=subprocess.DEVNULL)


def write_cloud(file):
    """The demo scene as an organized cloud."""
    import cv2
    import numpy

    depth = cv2.imread("examples/demo_scene/depth.png", cv2.IMREAD_UNCHANGED).astype(numpy.float32) / 1000
    height, width = depth.shape
    v, u = numpy.mgrid[0:height, 0:width].astype(numpy.float32)
    z = numpy.where(depth > 0, depth, numpy.nan)
    colour = cv2.imread("examples/demo_scene/rgb.png").astype(numpy.uint32)
    rgb = (colour[..., 2] << 16 | colour[..., 1] << 8 | colour[..., 0]).astype(numpy.uint32).view(numpy.float32)
    points = numpy.stack([(u - 319.5) * z / 525, (v - 239.5) * z / 525, z, rgb], axis=-1)
    header = (
        "VERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n"
        f"WIDTH {width}\nHEIGHT {height}\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {width * height}\nDATA binary\n"
    )
    pathlib.Path(file).write_bytes(header.encode() + points.astype(numpy.float32).tobytes())


def write_osd(folder):
    """Synthetic scenes in the layout of the OSD's release, four to learn from and two to test with."""
    import cv2
    import numpy

    synthesize("prepared/for_osd", width=640, height=480)
    for kind in ("image_color", "disparity", "annotation"):
        (pathlib.Path(folder) / kind).mkdir(parents=True)
    for i, scene in enumerate(sorted(pathlib.Path("prepared/for_osd").glob("*_*"))):
        name = f"learn{i}.png" if i < 4 else f"test{i - 4}.png"
        label = cv2.imread(str(scene / "label.png"), cv2.IMREAD_UNCHANGED)
        cv2.imwrite(f"{folder}/annotation/{name}", numpy.maximum(label.astype(int) // 10 - 1, 0).astype(numpy.uint8))
        cv2.imwrite(f"{folder}/disparity/{name}", cv2.imread(str(scene / "depth.png"), cv2.IMREAD_UNCHANGED))
        cv2.imwrite(f"{folder}/image_color/{name}", cv2.imread(str(scene / "rgb.png")))


# By a word of the page: what makes it there.
PREPARED = {
    r"\b(SCENES|DATA)\b": lambda: synthesize("prepared/scenes"),
    r"\bscenes\b": lambda: None if pathlib.Path("scenes").exists() else synthesize("scenes"),
    r"ablate learn --test test": lambda: (synthesize("learn"), synthesize("test", 2)),
    r"\bcloud\.pcd\b": lambda: write_cloud("cloud.pcd"),
    r"--camera camera\.yaml": lambda: pathlib.Path("camera.yaml").symlink_to("examples/demo_scene/camera.yaml"),
    r"\bOSD-0\.2-depth\b": lambda: write_osd("OSD-0.2-depth"),
    r"extends: base\.yaml": lambda: pathlib.Path("base.yaml").write_text("schema_version: 1\nextends: default.yaml\n"),
}


def prepare(blocks):
    code = "".join(block.text for block in blocks if block.language in ("sh", "yaml", "python"))
    makes_scenes = re.search(r"--output scenes\b", code)
    for word, make in PREPARED.items():
        if re.search(word, code) and not (word == r"\bscenes\b" and makes_scenes):
            make()


# Running


def shell_of(blocks):
    """A script of all blocks. $block is the line of the page that the current one begins at."""
    parts = ["set -eEuo pipefail\ntrap 'echo \"line $block of the page: failed: $BASH_COMMAND\" >&2' ERR\n"]
    for block in blocks:
        parts.append(f"block={block.line}\n")
        if block.file and block.language != "sh":
            body = block.text
            if block.language == "yaml":
                body = placed(body)
            parts.append(f"mkdir -p $(dirname {block.file})\ncat > {block.file} <<'END_OF_BLOCK'\n{body}END_OF_BLOCK\n")
        if block.language == "sh":
            parts.append(placed(block.text))
        elif block.language == "yaml":
            parts.append(yaml_check(block))
        elif block.language == "python":
            # From a file, which processes that it starts can read, too.
            file = block.file or f"block_{block.line}.py"
            if not block.file:
                parts.append(f"cat > {file} <<'END_OF_BLOCK'\n{placed(block.text)}END_OF_BLOCK\n")
            parts.append(f"{shlex.quote(sys.executable)} {file}\n")
        elif block.language == "cpp" and not block.file:
            parts.append(
                f"c++ -std=c++20 -fsyntax-only {INCLUDES} -x c++ - <<'END_OF_BLOCK'\n{block.text}END_OF_BLOCK\n"
            )
    return "".join(parts)


INCLUDES = (
    f"-I{shlex.quote(str(SOURCES / 'core' / 'include'))} -isystem /usr/include/eigen3 -isystem /usr/include/opencv4"
)


def yaml_check(block):
    file = block.file or f"block_{block.line}.yaml"
    writing = "" if block.file else f"cat > {file} <<'END_OF_BLOCK'\n{block.text}END_OF_BLOCK\n"
    if re.search(r"^schema_version:", block.text, re.M):
        return writing + f"gestalt config check {file}\n"
    if re.search(r"^fx:", block.text, re.M):
        return writing + f"gestalt info {file}\n"
    if block.file:
        return ""  # for the commands after it
    raise SystemExit(f"line {block.line}: this is neither a config (schema_version) nor a camera file (fx)")


def inline_commands(page):
    text = re.sub(r"^\s*```.*?^\s*```", "", page, flags=re.M | re.S)
    return re.findall(r"`(?:build/bin/)?gestalt ([a-z][^`]*)`", text.replace("\n", " "))


def check_inline(page):
    """Commands in the text: their subcommands and options must be in the help."""
    for command in inline_commands(page):
        words = [word for word in re.findall(r"[^\s|\[\]]+", command)]
        subcommand = []
        for word in words:
            help_text = subprocess.run(
                ["gestalt", *subcommand, "--help"], capture_output=True, text=True, check=True
            ).stdout
            if not re.search(rf"^  {re.escape(word)}\s", help_text, re.M) or word.startswith("-"):
                break
            subcommand.append(word)
        if not subcommand:
            raise SystemExit(f"`gestalt {command}`: there is no such command")
        help_text = subprocess.run(
            ["gestalt", *subcommand, "--help"], capture_output=True, text=True, check=True
        ).stdout
        for option in re.findall(r"(?<!\S)--[a-z][a-z-]*", command):
            if not re.search(rf"{option}\b", help_text):
                raise SystemExit(f"`gestalt {command}`: gestalt {' '.join(subcommand)} has no option {option}")


def main():
    build, folder, page = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3]
    text = (SOURCES / page).read_text()
    known = ("sh", "yaml", "cpp", "python", "text", "json")
    blocks = blocks_of(text)
    for block in blocks:
        if block.language not in known and not block.language.startswith("{"):
            raise SystemExit(f"{page}:{block.line}: a block has to say that it is one of {', '.join(known)}")

    subprocess.run(["rm", "-rf", folder], check=True)
    folder.mkdir(parents=True)
    os.chdir(folder)
    (folder / "prepared").mkdir()
    (folder / "build").symlink_to(build)
    for name in ("examples", "configs", "models", "docs", "scripts", "bench", "tests"):
        (folder / name).symlink_to(SOURCES / name)
    os.environ["PATH"] = f"{build / 'bin'}:{os.environ['PATH']}"
    os.environ["CMAKE_GENERATOR"] = "Ninja"  # all cores, where a page names no generator
    os.environ["PYTHONPATH"] = f"{build / 'lib' / 'python3' / 'dist-packages'}:{os.environ.get('PYTHONPATH', '')}"

    check_inline(text)
    prepare(blocks)
    run = subprocess.run(["bash", "-c", shell_of(blocks)], check=False)
    if run.returncode:
        print(f"{page}: see the lines above", file=sys.stderr)
    return 1 if run.returncode else 0


if __name__ == "__main__":
    sys.exit(main())
