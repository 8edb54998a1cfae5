"""What a monitor would show of deliveries: the launch that a model computes and club data, with exact derivatives."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence

import numpy as np

from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.parameters import ParameterSet
from clubface.inference.prior import Prior
from clubface.launch_monitor.as_seen import ATTITUDE, MOTION, as_seen
from clubface.launch_monitor.formats import CG, CONTACT, FACE
from clubface.simulation import core
from clubface.simulation.inputs import equipped, shots
from clubface.simulation.quantities import input_columns, outputs
from clubface.simulation.run_options import thread_count, tolerance
from clubface.support.arrays import Floats

STEP = 1e-4
"""Step of the derivatives of what other points of the head do, in standard deviations of the prior; they are smooth."""


class Observer:
    """Computes what a monitor shows of deliveries.

    Deliveries are given as standard normal deviates of a prior, shape (n, uncertain quantities).

    Parameters
    ----------
    club, ball, model, parameters, accuracy, threads
        As for :func:`clubface.impact`.
    prior
        What is believed of the deliveries.
    speed_at, face_at
        Where the monitor takes club data, see :class:`clubface.RecordedShots`.
    """

    def __init__(
        self,
        club: Club,
        *,
        ball: str | os.PathLike[str] | Ball | None,
        model: str,
        parameters: ParameterSet,
        prior: Prior,
        accuracy: float | None,
        threads: int | None,
        speed_at: str = CG,
        face_at: str = FACE,
    ) -> None:
        self.impacts = 0
        """Impacts computed so far."""
        self.prior = prior
        self.club = club
        self.places = (speed_at, face_at)
        self._model = model
        self._equipment, chosen = equipped(model, club, ball, parameters)
        self._parameters = chosen.columns()
        self._accuracy, self._threads = tolerance(accuracy), thread_count(threads)
        self._output = {name: place for place, name in enumerate(outputs())}
        self._variables = [input_columns()[name] for name in prior.names]
        unit = prior.deliveries(np.eye(len(prior.names)))
        self._scale = np.array([unit[name] - prior.mean[name] for name in prior.names])
        self._mean = np.array([prior.mean[name] for name in prior.names])

    def seen(self, standard: Floats, launch: Sequence[str], club: Sequence[str], known: Mapping[str, float]) -> Floats:
        """Return what is shown of deliveries, shape (n, quantities); NaN for those that cannot be computed.

        Parameters
        ----------
        standard
            The deliveries.
        launch
            The quantities of the launch wanted.
        club
            The quantities of the delivery wanted, after them.
        known
            Values of the delivery that are no part of the prior.
        """
        self.impacts += len(standard)
        found, _ = core.impact(
            self._model, self._columns(standard, known), self._parameters, len(standard), self._accuracy, self._threads
        )
        values = found[[self._output[name] for name in launch]].T
        return np.hstack([values, self._club_data(standard, club, known)]) if club else values

    def derivatives(
        self, standard: Floats, launch: Sequence[str], club: Sequence[str], known: Mapping[str, float]
    ) -> tuple[Floats, Floats]:
        """Return what is shown of one delivery, shape (quantities,), and its derivatives by ``standard``, one a row."""
        places = [self._output[name] for name in launch]
        point = standard[None, :]
        values, slopes = np.empty((0,)), np.empty((0, standard.size))
        if places:
            found, _ = core.sensitivities(
                self._model, self._columns(point, known), self._parameters, 1, places, self._variables,
                self._accuracy, self._threads,
            )  # fmt: skip
            table = found.reshape(len(places), 1 + len(self._variables))
            values, slopes = table[:, 0], table[:, 1:] @ self._scale
        if club:
            steps = np.vstack([point, point + STEP * np.eye(standard.size), point - STEP * np.eye(standard.size)])
            data = self._club_data(steps, club, known)
            _, ahead, behind = np.split(data, [1, 1 + standard.size])
            values = np.concatenate([values, data[0]])
            slopes = np.vstack([slopes, (ahead - behind).T / (2.0 * STEP)])
        return values, slopes

    def _delivery(self, standard: Floats, known: Mapping[str, float]) -> dict[str, Floats]:
        values = self._mean + standard @ self._scale.T
        found = {name: np.ascontiguousarray(values[:, place]) for place, name in enumerate(self.prior.names)}
        return {**{name: np.full(len(standard), value) for name, value in known.items()}, **found}

    def _columns(self, standard: Floats, known: Mapping[str, float]) -> list[float | Floats]:
        return shots(self._equipment, self._delivery(standard, known)).columns

    def _club_data(self, standard: Floats, names: Sequence[str], known: Mapping[str, float]) -> Floats:
        given = self._delivery(standard, known)
        speed_at, face_at = self.places
        speed_at = speed_at if set(MOTION) & set(names) else CG
        face_at = face_at if set(ATTITUDE) & set(names) else FACE
        if speed_at == FACE or face_at == CONTACT:
            given = as_seen(given, self.club, speed_at=speed_at, face_at=face_at)
        return np.stack([given[name] for name in names], axis=1)
