"""Stock to leave on the part: the same heights, farther away."""
import numpy as np
import facetmill

part = facetmill.sample("convex", tolerance=0.2)
middle = np.mean(part.box, axis=0)[None, :2]
cutter = facetmill.Cutter("ball:8")
near = facetmill.DropCutter(part, cutter).drop(middle)
far = facetmill.DropCutter(part, cutter, allowance=0.5).drop(middle)

assert 0.49 < far[0] - near[0] < 0.6
