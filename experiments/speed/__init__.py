"""Speed of each part of the package, compared with its alternatives: ``python -m experiments speed NAME``."""

from experiments import commands
from toolkit.cli import verbs

app = verbs.group(commands(__name__, __path__), help=__doc__)
