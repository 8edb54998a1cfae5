"""The design of heads of shells: a fast model proposes, finite elements dispose."""

from __future__ import annotations

from clubface.design.shells.metals import MetalChoice, NamedMetal
from clubface.design.shells.run import improve
from clubface.design.shells.study import Blow, ShellStudy, read

__all__ = ["Blow", "MetalChoice", "NamedMetal", "ShellStudy", "improve", "read"]
