"""A report for a player, in plain language: what was measured, what it means, and how sure that is."""

from clubface.player_report.document import write_report as write_report
