"""What the tests of the command share: the command of the command line's first word, and tables."""
import csv
import os
import subprocess
import sys

GAPFLOW = os.path.abspath(sys.argv.pop(1))


def gapflow(*words, launcher=(), timeout=600, **options):
    return subprocess.run([*map(str, launcher), GAPFLOW, *map(str, words)], capture_output=True, text=True, timeout=timeout,
                          **options)


def rows(file):
    with open(file) as f:
        return list(csv.DictReader(f))
