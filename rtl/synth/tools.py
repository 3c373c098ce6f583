# SPDX-License-Identifier: Apache-2.0
"""What every step of the area tool uses: its error, the programs it runs, whole files, the cache."""

import hashlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile


class AreaError(Exception):
    """One sentence for the user: what is wrong, where, and what to do."""


def run(command, what, cwd=None):
    """Standard output of a program; its own words in the error if it fails."""
    try:
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, cwd=cwd)
    except FileNotFoundError:
        raise AreaError(f"there is no program {command[0]}: install it, or name it on the command line") from None
    if done.returncode:
        lines = [line for line in (done.stdout + done.stderr).splitlines() if line.strip()]
        said = next((line for line in lines if "ERROR" in line), lines[-1] if lines else "nothing")
        raise AreaError(f"{what}: {pathlib.Path(command[0]).name} says: {said.strip()}")
    return done.stdout + done.stderr


def write_file(path, text):
    """Whole or not at all, also when two programs write the same file at once."""
    path = pathlib.Path(path)
    temporary = None
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile("w", dir=path.parent, prefix=f".{path.name}.", delete=False) as file:
            temporary = file.name
            os.fchmod(file.fileno(), 0o644)
            file.write(text)
        os.replace(temporary, path)
    except OSError as error:
        if temporary:
            pathlib.Path(temporary).unlink(missing_ok=True)
        raise AreaError(f"cannot write {path} ({error.strerror}): name a place that can be written") from None


class Cache:
    """Results by key. A key is the SHA-256 of all that a result depends on, so nothing in here ever gets old."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    @staticmethod
    def key(*parts):
        return hashlib.sha256(json.dumps(parts).encode()).hexdigest()

    def load(self, key):
        """None if it is not there; a file that somebody cut short is as good as none."""
        try:
            return json.loads((self.folder / key[:2] / f"{key}.json").read_text())
        except (OSError, ValueError):
            return None

    def store(self, key, result):
        write_file(self.folder / key[:2] / f"{key}.json", json.dumps(result, separators=(",", ":")))


def say(text):
    print(f"area: {text}", file=sys.stderr, flush=True)
