"""Where models come from: a folder of the user's, the bundled gallery, libcgal-demo, or this laboratory itself."""
import os
import tarfile

from lab.errors import LabError
from lab.mesh import write_off
from lab.programs import file_digest

ARCHIVES = tuple(f"/usr/share/doc/{package}/data.tar.gz" for package in ("libcgal-dev", "libcgal-demo"))
ENDING = ".off"

# The paper's models are not free to ship: what takes the place of each, by size of the run where that matters.
STAND_INS = {
    "fertility": {"tiny": "made:torus", "else": "elephant.off"},
    "blade": {"tiny": "gallery:bracket", "else": "turbine.off"},
    "armadillo": {"tiny": "made:torus", "else": "armadillo.off"},
    "lucy": {"tiny": "made:torus", "else": "elephant.off"},
    "elephant": {"tiny": "made:torus", "else": "elephant.off"},
}


class Model:
    """A file or gallery:NAME for the programs, with a name to print and a digest that tells contents apart."""

    def __init__(self, name, path, digest, stands_in):
        self.name, self.path, self.digest, self.stands_in = name, path, digest, stands_in

    def is_file(self):
        return not self.path.startswith("gallery:")


class Models:
    """Finds models by the names that the paper gives them."""

    def __init__(self, folder, size, work, archives=ARCHIVES):
        self._folder, self._size, self._work, self._archives = folder, size, work, archives
        if folder is not None and not os.path.isdir(folder):
            raise LabError(f"--models {folder} is no folder")
        os.makedirs(work, exist_ok=True)

    def of_paper(self, name):
        """The paper's own model where --models has it, else what stands in for it."""
        own = self._in_folder(name)
        if own is not None:
            return Model(os.path.basename(own), own, file_digest(own), False)
        choice = STAND_INS[name]
        choice = choice.get(self._size, choice["else"])
        kind, _, rest = choice.rpartition(":")
        if kind == "gallery":
            return Model(rest, choice, choice, True)
        if kind == "made":
            from lab import shapes
            return self.made(rest, lambda path: write_off(path, getattr(shapes, rest)()), stands_in=True)
        path = self._demo(choice)
        # A scan of the same statue, at another resolution, is no stand-in but still not the paper's file.
        return Model(choice, path, file_digest(path), True)

    def made(self, name, write, ending=".off", stands_in=False):
        """A model that `write(path)` makes, the same one each time."""
        path = os.path.join(self._work, name + ending)
        write(path)
        return Model(name, path, file_digest(path), stands_in)

    def _in_folder(self, name):
        if self._folder is None:
            return None
        for file in sorted(os.listdir(self._folder)):
            stem, ending = os.path.splitext(file)
            if stem.lower() == name and ending.lower() == ENDING:
                return os.path.join(self._folder, file)
        return None

    def _demo(self, file):
        if self._folder is not None and os.path.exists(os.path.join(self._folder, file)):
            return os.path.join(self._folder, file)
        path = os.path.join(self._work, file)
        if os.path.exists(path):
            return path
        for archive in self._archives:
            if not os.path.exists(archive):
                continue
            with tarfile.open(archive) as tar:
                try:
                    data = tar.extractfile(f"data/meshes/{file}").read()
                except KeyError:
                    continue
            with open(path + ".part", "wb") as out:
                out.write(data)
            os.replace(path + ".part", path)
            return path
        raise LabError(f"the model {file} is missing: apt install libcgal-demo, or give a folder with --models", 3)
