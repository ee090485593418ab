"""Draws processes of a press shop from a seed."""
import random

import shop_first
import shop_more
from shop_parts import of_metal

MORE = 1000  # seeds from here on draw the processes of shop_more, those below keep their scenes
SHEETS, BULK = shop_first.SHEETS + shop_more.SHEETS, shop_first.BULK + shop_more.BULK


def draw(seed):
    """Returns the text of scene number @p seed and the name of its process."""
    processes = shop_more if seed >= MORE else shop_first
    kinds = processes.SHEETS + processes.BULK
    make, chance = kinds[seed % len(kinds)], random.Random(f"shop {seed}")
    scene = make(chance)
    if make in SHEETS:
        of_metal(scene)
    kind = make.__name__.replace("_", " ")
    return scene.text(f"shop scene {seed}, {kind}"), kind
