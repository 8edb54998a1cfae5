"""Studies at any scale: inputs swept over a computation, in chunks that any number of processes and machines share."""

from clubface.studies.joining import Joined as Joined, join as join
from clubface.studies.running import Outcome as Outcome, Status as Status, run as run, status as status
from clubface.studies.study import StudyFile as StudyFile, read_study as read_study
from clubface.studies.summaries import Summary as Summary, summary as summary
