"""Prints star.scene: a thousand lines through one point, and a small square that moves towards it."""

import math

print("# A thousand lines through one point.")
print("shape -3 -3 3 -3 3 3 -3 3")
for i in range(1000):
    x, y = (round(50000 * f(math.pi * i / 1000)) for f in (math.cos, math.sin))
    print("line", -x, -y, x, y)
print("entity 60000 47\nvelocity -7000 0")
