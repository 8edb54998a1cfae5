"""Pictures for papers: force histories, trajectories, a whole shot, the published tour averages.

Every function returns a matplotlib ``Figure``; :func:`save` writes it as PNG, SVG or PDF by the file's ending.
"""

from clubface.plots.shot import force_histories as force_histories
from clubface.plots.shot import shot_figure as shot_figure
from clubface.plots.shot import trajectories as trajectories
from clubface.plots.style import save as save
from clubface.plots.tour import error_figure as error_figure
from clubface.plots.tour import launch_figure as launch_figure

__all__ = ["error_figure", "force_histories", "launch_figure", "save", "shot_figure", "trajectories"]
