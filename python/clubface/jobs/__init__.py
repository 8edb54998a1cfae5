"""Long computations: parts that are kept and resumed, on threads, processes, shards of a study, or a Dask cluster."""

from clubface.jobs.engine import Job, run
from clubface.jobs.store import Finished, Store

__all__ = ["Finished", "Job", "Store", "run"]
