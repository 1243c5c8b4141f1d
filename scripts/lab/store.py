"""Results on disk, one JSON line a run, so that a stopped session goes on where it was."""
import json
import os


class Store:
    """The lines of one file by their keys. A line that was torn by a kill counts as not there."""

    def __init__(self, path):
        self._path = path
        self._rows = {}
        torn = False
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                text = file.read()
            torn = bool(text) and not text.endswith("\n")
            for line in text.splitlines():
                try:
                    row = json.loads(line)
                    self._rows[row["key"]] = row
                except (ValueError, KeyError, TypeError):
                    continue
        if torn:
            with open(path, "a", encoding="utf-8") as file:
                file.write("\n")

    def get(self, key):
        return self._rows.get(key)

    def add(self, row):
        with open(self._path, "a", encoding="utf-8") as file:
            file.write(json.dumps(row, sort_keys=True) + "\n")
            file.flush()
            os.fsync(file.fileno())
        self._rows[row["key"]] = row
