# SPDX-License-Identifier: Apache-2.0
"""What a person pastes from a page, run where it can do no harm: in a copy of the tree, a git repository of its own,
with the program that is tested at build/cli/halfspace."""
import contextlib
import pathlib
import shutil
import subprocess
import tempfile


def sources(root):
    """The paths of the tree, relative: what git knows or would take, else all that is no build."""
    listed = subprocess.run(["git", "-C", root, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                            capture_output=True, text=True, check=False)
    if listed.returncode == 0:
        paths = [pathlib.Path(name) for name in listed.stdout.split("\0") if name]
    else:
        paths = [path.relative_to(root) for path in root.rglob("*")]
        paths = [path for path in paths if not path.parts[0].startswith(("build", ".git"))]
    return [path for path in paths if (root / path).is_file()]


@contextlib.contextmanager
def copy_of(root, halfspace):
    """The folder of a copy."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for path in sources(root):
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(root / path, folder / path)
        for command in (["init", "-q"], ["add", "-A"],
                        ["-c", "user.name=test", "-c", "user.email=test@localhost", "commit", "-q", "-m", "copy"]):
            subprocess.run(["git", "-C", folder, *command], check=True)
        (folder / "build/cli").mkdir(parents=True)
        (folder / "build/cli/halfspace").symlink_to(pathlib.Path(halfspace).resolve())
        yield folder


def paste(line, folder):
    """Runs a line as a shell would."""
    return subprocess.run(["bash", "-c", line], cwd=folder, capture_output=True, text=True, timeout=3600, check=False)


def strewn(folder):
    """What lies in the sources that was not there, or is not as it was. build/ may be there."""
    status = subprocess.run(["git", "-C", folder, "status", "--porcelain", "--ignored"],
                            capture_output=True, text=True, check=True)
    return [line for line in status.stdout.splitlines() if line != "!! build/"]
