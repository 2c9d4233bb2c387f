"""Command line: ``python -m toolkit VERB``. One verb per job; bad input is one line on stderr and exit status 2."""

import io
import logging
import sys

from toolkit import verbs

VERBS = {
    "demo": ("toolkit.commands:demo_app", "Something to look at in a minute."),
    "data": ("toolkit.commands:data_app", "Get datasets and look at them."),
    "preprocess": ("toolkit.commands:preprocess", "Compute the features, phases and contacts of all files into a store."),
    "train": ("toolkit.commands:train", "Train a model; print the error on held-out frames."),
    "rollout": ("toolkit.commands:rollout", "Walk straight ahead in a style, write it, and print what was measured."),
    "export": ("toolkit.export.commands:app", "To other programs: web page, ONNX, glTF, BVH."),
    "style": ("toolkit.styles.commands:app", "Add styles to a trained model, and look at those it has."),
    "compare": ("toolkit.comparison.commands:app", "Train and measure the seven models of Table 2 side by side."),
    "train-stylizer": ("toolkit.stylization.commands:train_stylizer", "Train the motion stylizer of Park et al. 2021."),
    "stylize": ("toolkit.stylization.commands:stylize_", "Restyle a clip, by noise or by a reference clip."),
    "bench": ("toolkit.benchmarks:app", "Measure, and print what it is compared with."),
}

app = verbs.group(VERBS, pretty_exceptions_enable=False, help=__doc__)


def _say(line: str) -> None:
    from toolkit import engine

    if engine.first():  # of several processes that train together, one
        print("".join(c if c.isprintable() else repr(c)[1:-1] for c in line), file=sys.stderr)


class _Says(logging.Handler):
    def emit(self, record: logging.LogRecord) -> None:
        _say(record.getMessage())


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; returns the exit status."""
    logger = logging.getLogger("toolkit.datasets")  # says which data is used
    if not logger.handlers:
        logger.addHandler(_Says())
        logger.setLevel(logging.INFO)
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="replace")  # a pipe on Windows has no letters like → or ±
    try:
        app(arguments, standalone_mode=True)
    except (ValueError, OSError, ImportError) as error:
        _say(f"error: {error}")
        return 2
    except KeyboardInterrupt:
        _say("stopped")
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
