"""The runtime as an environment for reinforcement learning: python examples/gym_loop.py

`Walk()` has one character of the embedded model. `Walk(N)` has N characters in the compiled
runtime, and all its values are arrays with a leading axis. If Gymnasium is installed, `Walk` is a
gymnasium.Env. The task is to stay close to a point that moves along a curved path at 1 m/s.

- Action: the velocity, seen from the character (left, forward); 1 means 2 m/s.
- Observation, seen from the character (left, forward): where the point will be in half a second and
  in one second (m), the velocity of the character (m/s), and its two foot contacts.
- Reward: exp(-d), where d is the distance from the point in metres. The episode ends at a distance
  of 3 m.
"""

import os

import numpy as np
import torch

import toolkit as tk

try:
    from gymnasium import Env, spaces
except ImportError:
    Env, spaces = object, None

SECONDS, CHARACTERS = (5.0, 8) if os.environ.get("TOOLKIT_FAST") else (20.0, 64)
# frames per action (a tenth of a second), m/s of action 1, metres at which it ends
FRAMES, FASTEST, FAR = 6, 2.0, 3.0


class Walk(Env):
    """Characters, each with its own style and its own path."""

    def __init__(self, characters=None, seconds=SECONDS):
        model, self.bank = tk.pretrained()
        self.model, self.many, self.n = (
            tk.runtime.compile(model), characters is not None, characters or 1
        )
        self.steps = round(seconds * tk.runtime.FPS / FRAMES)
        if spaces:
            self.observation_space, self.action_space = spaces.Box(
                -20.0, 20.0, (8,)), spaces.Box(-1.0, 1.0, (2,))

    def reset(self, *, seed=None, options=None):
        """Start new paths; returns the observation and a dict."""
        if spaces:
            super().reset(seed=seed)
        draw = self.np_random if spaces else np.random.default_rng(seed)
        at = np.arange((self.steps + 11) * FRAMES)[:, None] / tk.runtime.FPS
        heading = draw.uniform(0.5, 1.5, self.n) * np.sin(draw.uniform(0.2, 0.6, self.n) * at)
        # 1 m/s
        self.path = np.stack((np.sin(heading), np.cos(heading)),
                             -1).cumsum(0)[::FRAMES] / tk.runtime.FPS
        styles = draw.integers(len(self.bank), size=self.n)
        self.state, self.count = tk.runtime.start(self.model,
                                                  self.bank.vectors[torch.from_numpy(styles)]), 0
        return self._observe(), {"styles": [self.bank.names[i] for i in styles]}

    def step(self, action):
        """Returns the observation, the reward, whether the character is too far away, whether time
        is up, and a dict.
        """
        velocity = FASTEST * self._turned(np.clip(np.atleast_2d(action), -1.0, 1.0), 1.0)
        # it faces ahead
        command = tk.runtime.Command(torch.from_numpy(velocity), torch.from_numpy(velocity))
        for _ in range(FRAMES):
            self.state = tk.runtime.step(self.model, self.state, command)
        self.count += 1
        away = np.linalg.norm(self.path[self.count] - self.state.root[:, :2].numpy(), axis=-1)
        rows = np.exp(-away), away > FAR, np.full(self.n, self.count >= self.steps)
        return self._observe(), *(rows if self.many else (row.item() for row in rows)), {}

    def _observe(self):
        root, before = (self.state.history[:, frame, :2].numpy() for frame in (-1, -31))
        seen = (self.path[self.count + 5] - root, self.path[self.count + 10] - root,
                2 * (root - before))
        seen = np.concatenate((*(self._turned(v, -1.0) for v in seen), self.state.contacts.numpy()),
                              -1)
        return np.clip(seen if self.many else seen[0], -20.0, 20.0).astype(np.float32)

    def _turned(self, vectors, way):
        """(x, z) ``[N, 2]`` turned from the root frame to the world frame, or with ``way`` -1 the
        other way round.
        """
        (sin, cos), (x, z) = self.state.root[:, 2:].numpy().T, vectors.T
        return np.stack((cos * x + way * sin * z, cos * z - way * sin * x), -1)


def play(env, policy):
    """Mean reward ``[N]`` of an episode; a character that was too far away gets no more reward."""
    (seen, _), total, playing, over = env.reset(seed=0), 0.0, True, False
    while not over:
        seen, reward, lost, truncated, _ = env.step(policy(seen))
        playing = playing & ~lost
        total, over = total + reward * playing, truncated.all()
    return total / env.steps


draw = np.random.default_rng(0)
policies = {"random": lambda seen: draw.uniform(-1.0, 1.0, (len(seen), 2)),
            # walk to where the point will be in half a second
            "heuristic": lambda seen: seen[:, :2] / 0.5 / FASTEST}
rewards = {name: play(Walk(CHARACTERS), policy) for name, policy in policies.items()}
for name, reward in rewards.items():
    print(f"{name}: mean reward {reward.mean():.2f} of {CHARACTERS} characters, "
          f"{reward.min():.2f} to {reward.max():.2f}")
