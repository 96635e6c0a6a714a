"""Heights that can be worked out: a flat cutter over a slope touches with its edge, a ball with its side."""
import math
import numpy as np
import facetmill

slope = facetmill.Mesh([[-50, -50, -25], [50, -50, -25], [50, 50, 25], [-50, 50, 25]], [[0, 1, 2], [0, 2, 3]])
points = np.random.default_rng(1).uniform(-20, 20, (1000, 2))
angle = math.atan(0.5)
flat = facetmill.DropCutter(slope, facetmill.Cutter.flat(10)).drop(points)
ball = np.empty(len(points))  # is filled, instead of a new array
facetmill.DropCutter(slope, facetmill.Cutter.ball(10)).drop(points, out=ball)

assert np.allclose(flat, (points[:, 1] + 5) * 0.5, atol=1e-9)
assert np.allclose(ball, points[:, 1] * 0.5 + 5 / math.cos(angle) - 5, atol=1e-9)
