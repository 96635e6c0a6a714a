"""Work that another thread watches and cancels: the interpreter is free meanwhile."""
import threading
import numpy as np
import facetmill

part = facetmill.sample("concave")
drop = facetmill.DropCutter(part, facetmill.Cutter.ball(40))
(x0, y0, _), (x1, y1, _) = part.box
points = np.random.default_rng(1).uniform((x0, y0), (x1, y1), (10_000_000, 2))
job = facetmill.Job()
threading.Timer(0.2, job.cancel).start()
try:
    drop.drop(points, job=job)
    raise SystemExit("it was not cancelled")
except facetmill.Cancelled:
    print(f"cancelled at {job.fraction:.0%}")
