"""The design of heads of shells: a fast model proposes, finite elements dispose."""

from __future__ import annotations

from clubface.design.shells.run import improve as improve
from clubface.design.shells.study import Blow as Blow, NamedMetal as NamedMetal, ShellStudy as ShellStudy, read as read
