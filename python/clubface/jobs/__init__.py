"""Long computations in resumable parts, on threads, processes, shards or a Dask cluster."""

from clubface.jobs.engine import Job, run
from clubface.jobs.store import Finished, Store

__all__ = ["Finished", "Job", "Store", "run"]
