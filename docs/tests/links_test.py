# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every relative link of every page leads to a file of the sources and, after a #, to one of its headings, as on a
repository host.

    links_test.py [FOLDER]     default: the sources
"""

import pathlib
import re
import sys

LEFT_OUT = ("build", "out", "node_modules", "plugins/templates", ".git")
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)(?:\s+\"[^\"]*\")?\)")


def without_code(text):
    text = re.sub(r"^ *```.*?^ *```", "", text, flags=re.M | re.S)
    return re.sub(r"`[^`\n]*`", "", text)


def anchor(heading):
    """The anchor that repository hosts give a heading: lower case, punctuation removed, hyphens for spaces."""
    heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "")
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchors(page):
    text = re.sub(r"^ *```.*?^ *```", "", page.read_text(), flags=re.M | re.S)
    return {anchor(heading) for heading in re.findall(r"^#+ (.*)$", text, flags=re.M)}


def pages_of(root):
    for page in sorted(root.rglob("*.md")):
        path = page.relative_to(root).as_posix()
        if not path.startswith(LEFT_OUT) and "node_modules" not in path:
            yield page


def broken_links(root):
    for page in pages_of(root):
        for target in LINK.findall(without_code(page.read_text())):
            if re.match(r"[a-z]+:", target):
                continue
            path, _, heading = target.partition("#")
            file = (page.parent / path).resolve() if path else page
            if not file.exists():
                yield f"{page.relative_to(root)}: {target}: there is no such file"
            elif heading and file.suffix == ".md" and heading not in anchors(file):
                yield f"{page.relative_to(root)}: {target}: there is no such heading"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    broken = list(broken_links(root))
    print("\n".join(broken) if broken else f"{len(list(pages_of(root)))} pages: no broken links")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
