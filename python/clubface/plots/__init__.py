"""Pictures for papers: force histories, trajectories, a whole shot, and the style of every other figure.

Every function returns a matplotlib ``Figure``; :func:`save` writes it as PNG, SVG or PDF by the file's ending.
"""

from clubface.plots.shot import (
    force_histories as force_histories,
    shot_figure as shot_figure,
    trajectories as trajectories,
)
from clubface.plots.style import save as save
