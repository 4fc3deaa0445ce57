# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Builds the site: the pages of docs/, pages made of what the command and the headers tell, and pictures that the
command makes. A warning is an error.

    build.py GESTALT OUTPUT      writes OUTPUT/site; OUTPUT/source is what Sphinx reads
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import furo

sys.dont_write_bytecode = True
import api
import pictures
import reference

SITE = pathlib.Path(__file__).resolve().parent
ROOT = SITE.parents[1]


def page_names():
    """Where each page of the tree stands in the site, by its path in the tree."""
    names = {
        f"docs/{file.relative_to(ROOT / 'docs')}": str(file.relative_to(ROOT / "docs"))
        for file in ROOT.glob("docs/**/*.md")
    }
    names |= {
        f"examples/{file.parent.name}/README.md": f"examples/{file.parent.name}.md"
        for file in ROOT.glob("examples/*/README.md")
    }
    return names | {
        "CONTRIBUTING.md": "contributing.md",
        "SECURITY.md": "security.md",
        "tests/fuzz/README.md": "fuzzing.md",
        "CHANGELOG.md": "changelog.md",
        "README.md": "index.md",
    }


def relink(text, page, names):
    """The text of a page with its links to other pages as they are in the site. A link to a file that is not a page is its
    words alone; one to nothing is an error."""

    def replace(match):
        words, target, anchor = match.group(1), match.group(2), match.group(3) or ""
        path = os.path.normpath(os.path.join(os.path.dirname(page), target))
        if path in names and not (path == "README.md" and anchor):  # the site's first page has other sections
            return f"[{words}]({os.path.relpath(names[path], os.path.dirname(names[page]) or '.')}{anchor})"
        if (ROOT / path).exists():
            return words
        raise SystemExit(f"{page}: the link to '{target}' leads nowhere")

    parts = re.split(r"(^```.*?^```$)", text, flags=re.M | re.S)
    link = r"(?<!!)\[([^\]]*)\]\((?![a-z]+:|#)([^)#\s]+)(#[^)]*)?\)"
    return "".join(part if part.startswith("```") else re.sub(link, replace, part) for part in parts)


def with_made_pictures(text):
    """The text of a page with the pictures that are made below in place of their copies in the sources."""
    text = re.sub(r"images/pages/(\w+)\.jpg", r"pictures/\1.png", text)
    return re.sub(r"images/pages/(\w+)\.svg", r"pictures/\1.svg", text)


def write(file, text):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)


def dark_rules(css):
    """The theme's dark rules for readers who prefer dark and have chosen nothing. Debian's build of Furo lost them."""
    rules = re.findall(r"([^{}]*\[data-theme=\"dark\"\][^{}]*)(\{[^{}]*\})", css)
    unchosen = "".join(
        selector.replace('[data-theme="dark"]', ':not([data-theme="light"])') + rule for selector, rule in rules
    )
    return f"@media not print {{ @media (prefers-color-scheme: dark) {{ {unchosen} }} }}\n"


def gather(gestalt, source):
    names = page_names()
    for page, name in names.items():
        if page != "README.md":
            write(source / name, with_made_pictures(relink((ROOT / page).read_text(), page, names)))
    for picture in ROOT.glob("docs/*.svg"):
        shutil.copy(picture, source)
    shutil.copytree(ROOT / "docs" / "images", source / "images", ignore=shutil.ignore_patterns("pages"))
    found = pictures.make(gestalt, ROOT / "examples" / "demo_scene", source / "pictures")
    shutil.rmtree(source / "pictures" / "work")

    command = reference.Command(gestalt)
    for name, text in reference.plugin_pages(command, found).items():
        write(source / "reference" / "plugins" / f"{name}.md", text)
    write(source / "reference" / "config.md", reference.config_page(command))
    write(source / "reference" / "commands.md", reference.command_page(command))
    for name, text in api.pages(includes(gestalt)).items():
        write(source / "api" / f"{name}.md", text)
    shutil.copytree(SITE / "static", source / "static")
    theme = pathlib.Path(furo.__file__).parent / "theme" / "furo" / "static" / "styles" / "furo.css"
    write(source / "static" / "dark.css", dark_rules(theme.read_text()))
    shutil.copy(SITE / "conf.py", source)


def includes(gestalt):
    """The folders of a build tree with links to the public headers, one for each library."""
    return [gestalt.parent.parent / "include" / f"gestalt_{library}" for library in ("core", "io", "evaluation")]


def run_doxygen(gestalt, source):
    settings = (SITE / "Doxyfile").read_text()
    folders = " ".join(f'"{include}"' for include in includes(gestalt))
    settings += f'INPUT = {folders}\nSTRIP_FROM_PATH = {folders}\nOUTPUT_DIRECTORY = "{source / "doxygen"}"\n'
    settings += f'INPUT_FILTER = "awk -f {SITE / "group.awk"}"\n'
    (source / "doxygen").mkdir()
    subprocess.run(["doxygen", "-"], input=settings, text=True, check=True)


def main():
    gestalt, output = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    source = output / "source"
    shutil.rmtree(source, ignore_errors=True)
    source.mkdir(parents=True)
    gather(gestalt, source)
    run_doxygen(gestalt, source)
    # Rebuild all pages: a page of an earlier build may hide a warning.
    sphinx = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-n", "-E", "-a", "-j", "auto", "-b", "html"]
    built = subprocess.run([*sphinx, "-d", output / "doctrees", source, output / "site"], check=False)
    return built.returncode


if __name__ == "__main__":
    sys.exit(main())
