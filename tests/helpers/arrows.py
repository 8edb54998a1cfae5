"""Which files use which, and what is wrong with that."""

from graphlib import CycleError, TopologicalSorter


def circle(arrows):
    """The names of a circle of arrows, the first one again at the end, or nothing."""
    try:
        TopologicalSorter(arrows).prepare()
    except CycleError as error:
        return error.args[1]
    return []


def upward(arrows, floor):
    """The arrows to what stands on a higher floor."""
    return sorted((name, other) for name, used in arrows.items() for other in used if floor(other) > floor(name))
