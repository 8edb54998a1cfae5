"""What ``clubface dispersion`` found as JSON has it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from clubface.support.version import __version__

if TYPE_CHECKING:
    from clubface.design.dispersion.derivatives import ByDerivatives
    from clubface.design.dispersion.indices import Indices
    from clubface.design.dispersion.sampling import Dispersion

QUANTILES = (0.05, 0.25, 0.5, 0.75, 0.95)
"""The shares of the shots whose quantiles are told."""


def document(of: Dispersion, slopes: ByDerivatives | None, shares: Indices | None) -> dict[str, Any]:
    """Return a dispersion with its spread by derivatives and its shares of the variance, as JSON has them [SI]."""
    from dataclasses import asdict

    from clubface.design.dispersion.sampling import SHARES

    found: dict[str, Any] = {
        "golfer": of.golfer.name, "club": of.club.name, "ball": of.ball.name, "model": of.model, "shots": of.count,
        "lost": of.lost, "reasons": dict(of.reasons), "seed": of.seed, "clubface_version": __version__,
        "quantities": {
            name: {
                "mean": of.mean(name), "spread": of.spread(name), "of_mean_delivery": of.mean_shot[name],
                "quantiles": {f"{share:g}": of.quantile(name, share) for share in QUANTILES},
            }
            for name in of.quantities
        },
    }  # fmt: skip
    if of.points.size:
        found["ellipses"] = [
            {
                "share": each.share,
                "centre": each.centre.tolist(),
                "half_axes": each.half_axes.tolist(),
                "angle": each.angle,
            }
            for each in map(of.ellipse, SHARES)
        ]
    if slopes is not None:
        found["by_derivatives"] = {
            name: {
                "mean": slopes.mean(name),
                "spread": slopes.spread(name),
                "spread_first_order": slopes.spread(name, order=1),
            }
            for name in slopes.value
        }
    if of.hole is not None:
        found["hole"] = {
            **asdict(of.hole),
            "before": of.hole.before(),
            "after": of.strokes,
            "gained": of.gained,
            "lies": dict(of.lies),
        }
    if shares is not None:
        found["shares"] = {
            "kind": shares.kind, "variables": shares.variables,
            "share": {name: each.tolist() for name, each in shares.share.items()},
            "total": {name: each.tolist() for name, each in shares.total.items()},
        }  # fmt: skip
    return found
