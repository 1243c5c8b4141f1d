"""Where the programs are, how they are built, and which build of them it is."""
import hashlib
import os
import subprocess

from lab.errors import LabError

NEEDED = ("isoscope-run", "isoscope-peer")


def built(root, install):
    """The folder of the programs, after what is missing was installed and what is out of date was built."""
    commands = 'root=$1; source "$root/scripts/lib.sh"; [[ $2 == no ]] || install_packages tests; build_preset release "${@:3}"'
    done = subprocess.run(["bash", "-euo", "pipefail", "-c", commands, "experiments", root, "yes" if install else "no",
                           *NEEDED], check=False)
    if done.returncode != 0:
        raise LabError("the programs could not be built")
    return os.path.join(root, "build", "release", "bin")


class Programs:
    """The programs of one folder, by name, with a digest of each."""

    def __init__(self, folder):
        self._paths = {name: os.path.join(folder, name) for name in NEEDED}
        for name, path in self._paths.items():
            if not os.access(path, os.X_OK):
                raise LabError(f"there is no {name} in {folder}; build it: ninja -C build/release {name}")
        self._digests = {name: file_digest(path) for name, path in self._paths.items()}

    def path(self, name):
        return self._paths[name]

    def digest(self, name):
        return self._digests[name]


def file_digest(path):
    """The first twelve digits of a file's SHA-256: enough to tell builds and models apart."""
    digest = hashlib.sha256()
    with open(path, "rb") as file:
        for block in iter(lambda: file.read(1 << 20), b""):
            digest.update(block)
    return digest.hexdigest()[:12]
