"""Stylised character animation, one command for each job.

Bad input prints one line and gives exit status 2.
"""

import sys

from toolkit.cli import verbs

VERBS = {
    "demo": ("toolkit.cli.demo:demo", "Make something to look at: a small model is trained, and "
             "walks through three styles."),
    "data": ("toolkit.cli.data:app", "Download datasets and show what they hold."),
    "inspect": ("toolkit.cli.inspect:inspect",
                "Show what a motion file holds, and how it is understood."),
    "preprocess": ("toolkit.extra.store.verbs:preprocess",
                   "Compute features of all files into a store."),
    "train": ("toolkit.cli.train:train", "Train a model and print its error on held-out frames."),
    "rollout": ("toolkit.cli.rollout:rollout",
                "Walk straight ahead in a style, write the motion and print measurements."),
    "shot": ("toolkit.extra.shots.verbs:shot",
             "Render a file of shots, say what cannot be met, and write the motion."),
    "evaluate": ("toolkit.cli.evaluate:evaluate",
                 "Measure motion files with the field's measures, beside real ones."),
    "benchmark": ("toolkit.extra.benchmark.verbs:app",
                  "Score steered walks in a style by the benchmark StyleWalk."),
    "export": ("toolkit.__main__:export",
               "Write files for other programs: web page, ONNX, glTF, BVH."),
    "style": ("toolkit.cli.style:app", "Add styles to a trained model, and list its styles."),
    "train-stylizer": ("toolkit.cli.train_stylizer:train_stylizer",
                       "Train the motion stylizer of Park et al. 2021."),
    "stylize": ("toolkit.cli.stylize:stylize_clip",
                "Give a clip another style, from noise or a reference clip."),
}

EXPORTS = {
    "web": ("toolkit.cli.export:web",
            "Write a page with network, styles and scene, which shows a character to steer."),
    "director": ("toolkit.extra.shots.verbs:director", "Write a page in which shots are planned."),
    "onnx": ("toolkit.extra.engines.verbs:onnx",
             "Write the network as ONNX and its style vectors as safetensors."),
    "clip": ("toolkit.cli.export:clip",
             "Convert a motion file to glTF, BVH, web page, strip of poses or film."),
}

export = verbs.group(EXPORTS, VERBS["export"][1])
app = verbs.group(VERBS, __doc__)


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; returns the exit status."""
    return verbs.execute(app, arguments)


if __name__ == "__main__":
    sys.exit(main())
