"""A mesh from NumPy arrays, and back."""
import numpy as np
import facetmill

vertices = [[0, 0, 0], [20, 0, 0], [20, 20, 5], [0, 20, 5]]
mesh = facetmill.Mesh(vertices, [[0, 1, 2], [0, 2, 3]])
mesh.save("slope.stl")
again = facetmill.load_mesh("slope.stl", units="mm")

assert len(again) == 2
assert np.array_equal(again.vertices[again.facets], mesh.vertices[mesh.facets])
