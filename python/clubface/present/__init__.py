"""Results presented to people: terminal, files, reports, notebooks and pictures."""

from clubface.present.report import write_report as write_report
from clubface.support.files import InputRecord as InputRecord

__all__ = ["InputRecord", "write_report"]
