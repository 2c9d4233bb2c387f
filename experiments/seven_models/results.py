"""The stored results (`experiments.tables`) of the comparisons in this folder."""

from experiments.seven_models.models import SIZES
from experiments.tables import Result

COLUMNS = {
    "model": ["model"], "seeds": ["seeds", 0], "shared": ["MSE", 4], "joints": ["MSE of joints", 4],
    "other": ["own MSE, another style's vector", 3],
    "mse": ["own MSE", 4], "bone": ["bone, mm", 2, 1000], "recognised": ["recognised, %", 0, 100],
    "upright": ["upright, %", 0, 100], "hands": ["hand range", 2],
    "together": ["hand correlation", 2],
    "clavicle": ["clavicle, cm", 2, 100], "hand": ["hand, cm", 1, 100], "skate": ["skate", 1, 100],
    "skate_ik": ["skate with IK", 1, 100], "steps": ["steps/s", 2], "speed": ["speed", 2],
    "path": ["path, cm", 1, 100], "parameters": ["parameters", 0], "per_style": ["per style", 0],
    "minutes": ["processor minutes", 1], "step_ms": ["ms per step", 0],
}
#: Of the field's measures on held-out recordings.
RECORDED = {"measure": ["measure"], "model": ["model", 3], "other": ["another style's vector", 3],
            "still": ["standing still", 3], "real": ["recordings", 3], "unit": ["unit"]}
#: Of ways to make style vectors.
VECTORS = {"vector": ["style vectors"], "mse": ["MSE", 4],
           "better": ["styles better than the mean, %", 0, 100],
           "recognised": ["recognised, %", 0, 100]}
KEYS = ("shared", "joints", "other", "mse", "bone", "recognised", "upright", "hands", "together",
        "clavicle", "hand",
        "skate", "skate_ik", "steps", "speed", "path")


def comparison(name: str, about: str, command: str, table: dict) -> Result:
    """The table of `experiments.seven_models.models.collect`: floors, ceiling, and the models with
    a value for each seed.
    """
    floors, say = table["baselines"], {"mean": "floor: predicting the mean",
                                       "repeat": "floor: repeating the frame"}
    rows = [{"model": text, "shared": floors[name], "joints": floors[f"{name}, joints"]}
            for name, text in say.items()]
    settings = table["settings"]
    for model, found in table["models"].items():
        runs, counts = found["runs"], found["counts"]
        rows.append({
            "model": model, "seeds": len(runs), **{key: [run[key] for run in runs] for key in KEYS},
            "parameters": counts["synthesis"] + counts["style"],
            "per_style": counts["per_style"], "minutes": [run["processor"] / 60 for run in runs],
            "step_ms": [1000 * run["processor"] / run["trained"] for run in runs],
        })
    if "ceiling" in table:
        top = table["ceiling"]
        rows.append({"model": "the published network",
                     **{key: top[key] for key in KEYS if key in top}})
    first = next(iter(table["models"].values()))["runs"][0]["styles"]
    floors = {f"{part}: between clips of the data, cm": 100 * sum(
        row[f"{part}_data"] for row in first.values()) / len(first)
              for part in ("clavicle", "hand")}
    numbers = {"recogniser on held-out seconds": table["recogniser"], **floors,
               "styles recognised": {model: [sum(row["recognised"]
                                                 for row in run["styles"].values())
                                             for run in found["runs"]]
                                             for model, found in table["models"].items()}}
    if "ceiling" in table:
        numbers["styles recognised"]["published"] = sum(
            r["recognised"] for r in table["ceiling"]["styles"].values())
        numbers["styles of the published network that are not recognised"] = [
            s for s, row in table["ceiling"]["styles"].items() if not row["recognised"]]
    about_settings = {"size": settings["size"], "hidden": SIZES[settings["size"]].hidden,
                      "steps": settings["steps"],
                      "batch": settings["batch"], "style rates": settings["style_rates"],
                      "styles": len(settings["frames"]), "frames": sum(settings["frames"].values())}
    return Result(name, about, command, COLUMNS, rows, about_settings, numbers)
