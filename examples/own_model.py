"""Your own models compared with the paper's: python examples/own_model.py [NAME …]

NAME is a file of `examples/models`: flow_transformer, vq_codebook, low_rank or gru (default:
low_rank). Importing a file registers its model. Data, training, held-out errors, style vectors,
runtime and files are those of the package.
"""

import os
import sys
import time
from importlib import import_module
from pathlib import Path

import toolkit as tk

sys.path.insert(0, str(Path(__file__).parent / "models"))
FAST = bool(os.environ.get("TOOLKIT_FAST"))
STEPS, SECONDS, WALK = (60, 12.0, 2.0) if FAST else (1000, 60.0, 6.0)
TINY = tk.networks.Sizes(hidden=64, film_channels=8, film_kernel=5, film_dense=32, dropout=0.0)
SIZES = TINY if FAST else tk.networks.Sizes.small()

files = sys.argv[1:] or ["low_rank"]
for file in files:
    import_module(file)
takes = tk.datasets.load("procedural", styles=("Neutral", "Zombie", "Aeroplane"), gaits="FW",
                         seconds=SECONDS)
data = tk.features.build(takes)
runs, clips = {}, {}
for name in ("lpn-film", *(file.replace("_", "-") for file in files)):
    began = time.perf_counter()
    config = tk.training.Config.quick(model=name, steps=STEPS, sizes=SIZES)
    runs[name] = run = tk.training.fit(data, config)
    seconds = time.perf_counter() - began
    commands = tk.runtime.straight(1.0, WALK)
    clips[name] = tk.runtime.rollout(run.model, commands, run.bank["Zombie"])
    count = sum(p.numel() for p in run.model.parameters())
    overall = run.table()[-1]
    print(f"{name}: {count:,} parameters, {run.model.style_size} numbers a style, {seconds:.0f} s")
    print("  error on held-out frames " + ", ".join(
        f"{overall[key]:.3f} ({text})" for key, text in {
            "error": "model", "other": "with another style's vector", "repeat": "same frame again",
            "mean": "mean"}.items()))
    print(f"  a zombie asked for 1 m/s walks at {tk.metrics.speed(clips[name]):.2f} m/s, "
          f"{'upright' if tk.metrics.upright(clips[name]) else 'it falls'}")
