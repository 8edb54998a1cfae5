"""Reports of shots and of players: one file with text, tables, pictures and data."""

from clubface.present.player_report import write_report as write_report
