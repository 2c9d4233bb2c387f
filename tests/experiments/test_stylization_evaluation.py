"""What judges restyled motion: classifiers, measures, the baselines of Table 2, the comparison."""

import pytest
import torch
from course import halves

import toolkit as tk
from experiments.stylization import comparison, evaluation, floors, sets
from experiments.stylization.judges import Judge, Judges, NetworkJudge
from toolkit.stylization import Config, data
from toolkit.stylization.networks import Sizes

METHODS = ("ours", "ours without ds", "1-D convolutions", "Aberman et al. 2020")
TINY = Config.quick(iterations=1, warm_up=0, sizes=Sizes(channels=4, hidden=8, detailed=True))


@pytest.fixture(scope="module")
def motions() -> data.Motions:
    """Two styles walking and standing, five takes of each, a window of each take."""
    clips = []
    for seed in range(5):
        clips += tk.datasets.procedural.load(["Neutral", "Zombie"], ["FW", "ID"], 2.3, seed)
    return data.build(clips)


@pytest.fixture(scope="module")
def judges(motions) -> Judges:
    """Trained on everything there is: what is tested here is what they are asked."""
    return Judges.train({"content": motions, "style": motions}, motions)


class Paste:
    """Restyles by giving back the reference."""

    def code_of(self, x, domain):
        return x

    def translate(self, x, code):
        return code


class Unchanged(Paste):
    """Restyles by doing nothing."""

    def translate(self, x, code):
        return x


def test_a_judge_names_contents_and_styles_of_takes_it_never_saw(motions, monkeypatch):
    monkeypatch.setattr("experiments.stylization.judges.STEPS", 40)  # enough for two styles
    train, test = halves.split(motions, 0.4, 0)
    for kind, label in ((Judge, "content"), (Judge, "domain"), (NetworkJudge, "domain")):
        judge = kind.train(train, label)
        assert (judge.named(test.x) == getattr(test, label)).float().mean() > 0.9
    again = NetworkJudge.train(train, "domain")
    assert torch.equal(judge.network(judge.described(test.x)),
                       again.network(again.described(test.x)))


def measured(model, motions, judges, seed=0):
    """Measures of the motions restyled with references among themselves."""
    rows, target = evaluation.pairs(motions)
    made = evaluation.results(model, motions, motions, "reference", seed)
    return evaluation.measures(motions.select(rows), target, made, judges)


def test_doing_nothing_keeps_all_content_and_moves_no_style(motions, judges):
    found = measured(Unchanged(), motions, judges)
    assert found["content"] == 1.0
    assert found["style"] == 0.0
    assert found["diversity"] == pytest.approx(0, abs=0.1)  # arccos near 1
    assert found["both"] == 0.0
    assert found["movement"] < 0.1


def test_pasting_the_reference_moves_all_style_and_loses_the_content(motions, judges):
    found = measured(Paste(), motions, judges)
    assert found["style"] == 1.0
    assert found["content"] < 0.8  # half of the references stand, half of the sources do
    assert found["diversity"] > 1
    assert measured(Paste(), motions, judges, seed=1) != found


@pytest.fixture(scope="module")
def task(motions) -> sets.Task:
    parts = {"test": motions, "validation": motions}
    judged = {part: {"content": motions, "style": motions} for part in sets.PARTS}
    return sets.Task(motions, parts, parts, judged)


@pytest.fixture(scope="module")
def compared(task, tmp_path_factory):
    """A comparison of two iterations, in its folder."""
    folder = tmp_path_factory.mktemp("comparison")
    plan = comparison.Plan(seconds=60, sources=2, iterations=2)
    for method in METHODS:
        comparison.measure(method, task, plan, 0, folder)
    return folder, plan


def test_a_comparison_has_rows_for_every_method_and_floor(compared, task):
    folder, plan = compared
    result = comparison.summary(task, plan, folder)
    named = {(row["method"], row.get("codes")) for row in result.rows}
    assert {("real motion", None), *((floor, None) for floor in floors.FLOORS)} <= named
    for by in evaluation.WAYS:
        assert ("ours", by) in named
    assert ("Aberman et al. 2020", "reference") in named
    most = result.rows[1]
    assert most["method"] == "most frequent class"
    # of the two sources one stands and one walks; both become Zombies
    assert (most["style"], most["content"], most["both"]) == (1.0, 0.5, 0.5)


def test_no_take_is_in_two_parts():
    styles, gaits = ["Neutral", "Zombie", "Old"], ["FW", "SW", "FR", "ID"]
    motions = data.build([clip for seed in range(2)
                          for clip in tk.datasets.procedural.load(styles, gaits, 2.3, seed)])
    task = sets.few_takes(motions, ("Neutral", "Zombie"), {"FW": "walk", "SW": "walk", "FR": "run"})
    assert task.sources["test"].contents == ("run", "walk")
    takes = {part: set(task.references[part].take.tolist()) for part in sets.PARTS}
    assert not takes["test"] & takes["validation"]
    for part in sets.PARTS:
        for others in (task.train, *task.judged[part].values()):
            assert not takes[part] & set(others.take.tolist())
        assert set(task.sources[part].take.tolist()) <= takes[part]
    many = sets.many_takes(motions)
    parts = [many.train, *many.sources.values(), many.judged["test"]["style"]]
    every = torch.cat([part.take for part in parts]).unique()
    assert sum(len(part.take.unique()) for part in parts) == len(every)
