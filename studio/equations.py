"""Equations of the numbers of a shot, as the studio shows and computes them.

They are written as Python expressions of names of the core, and of ``TERMS``, which the studio takes from head and ball
at impact or from derivatives. A page draws each as a tree, with symbols and with the values of the shot.
"""

from __future__ import annotations

import ast
from typing import Any, NamedTuple


class Term(NamedTuple):
    """A value that no column of the core holds.

    Attributes
    ----------
    symbol, label
        How it is printed and called.
    quantity
        The quantity whose unit and digits it has.
    """

    symbol: str
    label: str
    quantity: str


TERMS = {
    "approach": Term("v_n", "speed of the face at the impact point along its normal, before impact", "ball_speed"),
    "along_face": Term("v_t", "speed of the ball along the face, after impact", "ball_speed"),
    "restitution": Term(
        "e",
        "restitution: speed at which head and ball part along the normal, over that at which they meet",
        "restitution",
    ),
    "head_mass": Term("m_e", "effective mass of the head at the impact point, where its turning gives way", "mass"),
    "spin_lever": Term("k", "lever of the force along the face, over the radius of the ball", "restitution"),
    "attack_share": Term("k_alpha", "degrees of launch angle for a degree of attack angle", "restitution"),
    "loft_share": Term("k_theta", "degrees of launch angle for a degree of loft", "restitution"),
    "launch_rest": Term("theta_r", "what the rest makes of it, such as a strike off the centre", "launch"),
    "path_share": Term("k_psi", "degrees of start for a degree of path", "restitution"),
    "face_share": Term("k_phi", "degrees of start for a degree of face", "restitution"),
    "azimuth_rest": Term("phi_r", "what the rest makes of it, such as bulge at a strike off the centre", "azimuth"),
    "spin_parameter": Term(
        "S", "spin parameter, the speed of the ball's surface by its spin over its speed", "restitution"
    ),
}

DEFINITION = "By definition"
IMPACT = "From the impact along the face normal"
ALONG = "From the speed along the face"
MOMENTUM = "From the momentum that the head loses"

EQUATIONS: dict[str, tuple[tuple[str, str], ...]] = {
    "ball_speed": (
        (DEFINITION, "sqrt(velocity_x**2 + velocity_y**2 + velocity_z**2)"),
        (IMPACT, "sqrt((approach * (1 + restitution) * head_mass / (head_mass + ball_mass))**2 + along_face**2)"),
    ),
    "smash": ((DEFINITION, "ball_speed / speed"),),
    "launch": (
        (DEFINITION, "asin(velocity_y / ball_speed)"),
        ("Between attack angle and loft", "attack_share * attack + loft_share * loft + launch_rest"),
    ),
    "azimuth": (
        (DEFINITION, "atan2(velocity_z, velocity_x)"),
        ("Between path and face", "path_share * path + face_share * face + azimuth_rest"),
    ),
    "backspin": ((DEFINITION, "spin_z * cos(azimuth) - spin_x * sin(azimuth)"),),
    "sidespin": ((DEFINITION, "-spin_y"),),
    "total_spin": (
        (DEFINITION, "sqrt(spin_x**2 + spin_y**2 + spin_z**2)"),
        (ALONG, "spin_lever * ball_mass * ball_radius * along_face / ball_inertia"),
    ),
    "spin_axis": ((DEFINITION, "atan2(sidespin, backspin)"),),
    "velocity_x": (
        (DEFINITION, "ball_speed * cos(launch) * cos(azimuth)"),
        (MOMENTUM, "club_mass * (speed * cos(attack) * cos(path) - club_velocity_x) / ball_mass"),
    ),
    "velocity_y": (
        (DEFINITION, "ball_speed * sin(launch)"),
        (MOMENTUM, "club_mass * (speed * sin(attack) - club_velocity_y) / ball_mass"),
    ),
    "velocity_z": (
        (DEFINITION, "ball_speed * cos(launch) * sin(azimuth)"),
        (MOMENTUM, "club_mass * (speed * cos(attack) * sin(path) - club_velocity_z) / ball_mass"),
    ),
    "curve": ((DEFINITION, "side * cos(azimuth) - sqrt(carry**2 - side**2) * sin(azimuth)"),),
    "spin_y": ((DEFINITION, "-sidespin"),),
    "club_velocity_x": (
        ("What the ball leaves of it", "speed * cos(attack) * cos(path) - ball_mass * velocity_x / club_mass"),
    ),
    "club_velocity_y": (("What the ball leaves of it", "speed * sin(attack) - ball_mass * velocity_y / club_mass"),),
    "club_velocity_z": (
        ("What the ball leaves of it", "speed * cos(attack) * sin(path) - ball_mass * velocity_z / club_mass"),
    ),
}  # fmt: skip
"""By the output of the core that each of them gives. What a model does not keep, such as momentum, is left out."""

OPERATORS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "^"}
FUNCTIONS = {"sqrt", "sin", "cos", "asin", "atan2"}


def tree(expression: str) -> Any:
    """Return an expression as a tree: a name, a number, or a list of an operator or function and what it is of."""
    return _branch(ast.parse(expression, mode="eval").body)


def _branch(node: ast.expr) -> Any:
    match node:
        case ast.Name(id=name):
            return name
        case ast.Constant(value=int() as value):
            return value
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return ["neg", _branch(operand)]
        case ast.BinOp(left=left, op=operator, right=right):
            return [OPERATORS[type(operator)], _branch(left), _branch(right)]
        case ast.Call(func=ast.Name(id=name), args=arguments) if name in FUNCTIONS:
            return [name, *map(_branch, arguments)]
    raise ValueError(ast.unparse(node))


def equations_data() -> dict[str, Any]:
    """Return equations and terms for the pages."""
    return {
        "terms": {name: term._asdict() for name, term in TERMS.items()},
        "equations": {
            name: [{"title": title, "tree": tree(expression)} for title, expression in each]
            for name, each in EQUATIONS.items()
        },
    }
