"""Cutters by their shape, and the height of their lower surface."""
import math
import facetmill

ball = facetmill.Cutter.ball(6)
bull = facetmill.Cutter("bull:10,2")
cone = facetmill.Cutter.cone(6, math.radians(45))

assert math.isclose(ball.height_at(3), 3)
assert bull.height_at(3) == 0 and math.isclose(bull.height_at(5), 2)
assert math.isclose(cone.height_at(2), 2)
assert bull.apt[:2] == [10, 2]
