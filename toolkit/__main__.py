"""Stylised character animation, one command for each job. Bad input prints one line and gives exit status 2."""

import logging
import sys

from toolkit.cli import verbs

VERBS = {
    "demo": ("toolkit.cli.demo:app", "Make something to look at in a minute."),
    "data": ("toolkit.cli.data:app", "Download datasets and show what they hold."),
    "inspect": ("toolkit.cli.inspect:inspect", "Show what a motion file holds, and how it is understood."),
    "preprocess": ("toolkit.cli.preprocess:preprocess", "Compute features, phases and contacts of all files into a store."),
    "train": ("toolkit.cli.train:train", "Train a model and print its error on held-out frames."),
    "rollout": ("toolkit.cli.rollout:rollout", "Walk straight ahead in a style, write the motion and print measurements."),
    "shot": ("toolkit.cli.shot:shot", "Render a file of shots, say what cannot be met, and write the motion."),
    "evaluate": ("toolkit.cli.evaluate:evaluate", "Measure motion files with the field's measures, beside real ones."),
    "export": ("toolkit.cli.export:app", "Write files for other programs: web page, ONNX, glTF, BVH."),
    "style": ("toolkit.cli.style:app", "Add styles to a trained model, and list its styles."),
    "train-stylizer": ("toolkit.cli.train_stylizer:train_stylizer", "Train the motion stylizer of Park et al. 2021."),
    "stylize": ("toolkit.cli.stylize:stylize_clip", "Give a clip another style, from noise or from a reference clip."),
}

app = verbs.group(VERBS, __doc__)


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; returns the exit status."""
    logger = logging.getLogger("toolkit.datasets")  # says which data is used
    if not logger.handlers:
        logger.addHandler(verbs.Lines())
        logger.setLevel(logging.INFO)
    return verbs.execute(app, arguments)


if __name__ == "__main__":
    sys.exit(main())
