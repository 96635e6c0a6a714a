"""A ball cutter lowered at many points at once: OpenCAMLib's batch-drop example."""
import numpy as np
import facetmill

part = facetmill.sample("concave")
(x0, y0, _), (x1, y1, _) = part.box
x, y = np.meshgrid(np.linspace(x0, x1, 200), np.linspace(y0, y1, 200))
cutter = facetmill.Cutter.ball(12)
z = facetmill.DropCutter(part, cutter).drop(np.column_stack([x.ravel(), y.ravel()]))
print(f"{np.isfinite(z).sum()} of {z.size} points touch the part, the highest at {z.max():.3f} mm")

assert z.shape == (40000,) and np.isfinite(z).sum() > 30000
