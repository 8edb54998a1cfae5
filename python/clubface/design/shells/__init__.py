"""The design of heads of shells: a fast model proposes, finite elements dispose."""

from __future__ import annotations

from clubface.design.shells.run import improve
from clubface.design.shells.study import Blow, NamedMetal, ShellStudy, read

__all__ = ["Blow", "NamedMetal", "ShellStudy", "improve", "read"]
