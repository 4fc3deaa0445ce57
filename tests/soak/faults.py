# SPDX-FileCopyrightText: 2026 The Gestalt authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs whose outputs cannot be written or vanish, and whose inputs change under them."""

import os
import random
import resource
import shutil
import subprocess
import threading
import time

from interruptions import timed
from runs import Tally, check_whole, command, finish, run, start, synthesize


def prepared(scratch, count):
    scenes, reference = scratch / "scenes", scratch / "reference"
    synthesize(scenes, count, 160, 120)
    return scenes, reference, timed([command(), "segment", scenes, "--output", reference])


def full_disk(scratch, times, count):
    """A file system of its own where the system lets us mount one, else a limit on the size of files."""
    scenes, reference, _ = prepared(scratch, count)
    mount = ["unshare", "-rm", "sh", "-c"]
    mountable = subprocess.run([*mount, f"mount -t tmpfs -o size=1m none {scenes}"], capture_output=True).returncode == 0
    tally = Tally("a full disk" if mountable else "a limit on the size of files, as no file system could be mounted here")
    chance = random.Random(5)
    disk = scratch / "disk"
    disk.mkdir()
    for _ in range(times):
        if mountable:
            script = (f"mount -t tmpfs -o size={chance.randint(16, 2000)}k none {disk}; "
                      f"{command()} segment {scenes} --output {disk}/out; code=$?; "
                      f"rm -rf {scratch}/out; cp -r {disk}/out {scratch}/out 2>/dev/null; exit $code")
            code, error = run([*mount, script])
        else:
            size = chance.randint(100, 20000)
            shutil.rmtree(scratch / "out", ignore_errors=True)
            code, error = run([command(), "segment", scenes, "--output", scratch / "out"],
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
        tally.judge(code, error, {0, 1})
        if code == 1 and "cannot be written" not in error:
            tally.fault("wrong exit codes", f"no word of what cannot be written: {error}")
        if (scratch / "out").exists():
            check_whole(tally, scratch / "out", reference)
            if left := list((scratch / "out").rglob(".gestalt-*")):
                tally.fault("lost or half-written", f"{left[0].name} is left")
    return tally


def unwritable(scratch, times, count):
    """Outputs where nothing can be written, for any user."""
    scenes, _, _ = prepared(scratch, count)
    tally = Tally("outputs that cannot be written: /proc, below a file, a device")
    file = scratch / "file"
    file.touch()
    for i in range(times):
        out = ["/proc/gestalt", file / "out", "/dev/null/out"][i % 3]
        code, error = run([command(), "segment", scenes, "--output", out])
        tally.judge(code, error, {1})
        if "cannot be written" not in error:
            tally.fault("wrong exit codes", f"no word of what cannot be written: {error}")
    return tally


def vanishing_output(scratch, times, count):
    scenes, reference, duration = prepared(scratch, count)
    tally = Tally("the output folder is removed during the run")
    chance = random.Random(6)
    for _ in range(times):
        out, away = scratch / "out", scratch / "away"
        for folder in (out, away):
            shutil.rmtree(folder, ignore_errors=True)
        process = start([command(), "segment", scenes, "--output", out])
        time.sleep(chance.uniform(0, duration))
        if out.exists():
            os.rename(out, away)
        tally.judge(*finish(process), {0, 1})
        for folder in (out, away):
            if folder.exists():
                check_whole(tally, folder, reference)
    return tally


def changing_input(scratch, times, count):
    """Files of the scenes are cut off, emptied, removed and written again all the time."""
    scenes, _, _ = prepared(scratch, count)
    tally = Tally("files of scenes are cut off, removed and written again during the run")
    chance = random.Random(7)
    files = {file: file.read_bytes() for file in scenes.rglob("*.png")}
    for _ in range(times):
        out = scratch / "out"
        shutil.rmtree(out, ignore_errors=True)
        process = start([command(), "segment", scenes, "--output", out])
        done = threading.Event()

        def change():
            while not done.is_set():
                file = chance.choice(list(files))
                what = chance.random()
                if what < 0.3:
                    file.unlink(missing_ok=True)
                elif what < 0.6:
                    file.write_bytes(files[file][: chance.randrange(len(files[file]))])
                else:
                    file.write_bytes(files[file])

        changer = threading.Thread(target=change)
        changer.start()
        code, error = finish(process)
        done.set()
        changer.join()
        tally.judge(code, error, {0, 1})
        for result in out.rglob("result.json"):
            missing = {"labels.png", "objects.png", "overlay.png", "patches.png"} - set(os.listdir(result.parent))
            if missing:
                tally.fault("lost or half-written", f"{missing} missing")
    for file, data in files.items():
        file.write_bytes(data)
    return tally
