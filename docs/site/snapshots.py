# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Copies of the pages' pictures for readers of the pages on a repository host, which does not build the site.

    snapshots.py GESTALT     writes docs/images/pages; the site itself shows the pictures of the current build
"""

import pathlib
import re
import shutil
import sys
import tempfile

import cv2

sys.dont_write_bytecode = True
import pictures

ROOT = pathlib.Path(__file__).resolve().parents[2]
WIDTH = 640


def main():
    folder = ROOT / "docs" / "images" / "pages"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    pages = "".join(page.read_text() for page in (ROOT / "docs").rglob("*.md"))
    with tempfile.TemporaryDirectory() as work:
        made = pathlib.Path(work) / "pictures"
        pictures.make(pathlib.Path(sys.argv[1]).resolve(), ROOT / "examples" / "demo_scene", made)
        for name in sorted(set(re.findall(r"images/pages/([\w.]+)", pages))):
            if name.endswith(".svg"):
                shutil.copy(made / name, folder)
                continue
            picture = cv2.imread(str(made / name.replace(".jpg", ".png")))
            scale = min(1, WIDTH / picture.shape[1])
            picture = cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
            cv2.imwrite(str(folder / name), picture, [cv2.IMWRITE_JPEG_QUALITY, 85])


if __name__ == "__main__":
    main()
