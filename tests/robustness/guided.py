"""Coverage-guided fuzzing with atheris: ``python tests/robustness/guided.py TARGET [-runs=N] …`` (libFuzzer's flags).

Readers, seeds and half of the mutations are those of ``python -m experiments fuzz``; the other mutations are libFuzzer's. An
input that is neither read nor refused with one line stops the run and is stored in a file ``crash-…``.
"""

import random
import sys
import tempfile
import warnings
from pathlib import Path

import atheris

with atheris.instrument_imports(include=["toolkit"], exclude=["toolkit.io.decimals"]):  # which is compiled
    from robustness.fuzz import targets, trials


def main(target: str, flags: list[str]) -> None:
    """Fuzz the first reader of a target, with the budget of the flags."""
    warnings.simplefilter("ignore")
    folder = Path(tempfile.mkdtemp())
    reader = targets.make(folder, target)[target][0]
    corpus = folder / "corpus"
    corpus.mkdir()
    for number, seed in enumerate(reader.seeds):
        (corpus / str(number)).write_bytes(seed)

    def one(data: bytes) -> None:
        outcome, said, *_ = trials.trial(reader, data)
        if outcome == "failed":
            raise RuntimeError(said)

    def mutate(data: bytes, most: int, seed: int) -> bytes:
        rng = random.Random(seed)
        try:
            made = reader.mutate(rng, data) if rng.random() < 0.5 else atheris.Mutate(data, most)
        except Exception:  # the mutation cannot parse its input
            made = atheris.Mutate(data, most)
        return made[:most]

    atheris.Setup([sys.argv[0], str(corpus), "-max_len=100000", *flags], one, custom_mutator=mutate)
    atheris.Fuzz()


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
