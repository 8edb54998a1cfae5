"""Results as people read them: terminal, files, reports, notebooks and pictures."""

from clubface.present.report import write_report as write_report

__all__ = ["write_report"]
