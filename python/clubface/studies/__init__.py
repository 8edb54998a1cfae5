"""Studies at any scale: sweeps of inputs over a computation, in chunks shared by processes and machines."""

from clubface.jobs.workers import shard_of
from clubface.studies.joining import Joined, histories, join
from clubface.studies.running import Outcome, Status, run, status
from clubface.studies.study import StudyFile, read_study
from clubface.studies.summaries import Along, Figures, Summary, summary

__all__ = [
    "Along", "Figures", "Joined", "Outcome", "Status", "StudyFile", "Summary", "histories", "join", "read_study",
    "run", "shard_of", "status", "summary",
]  # fmt: skip
