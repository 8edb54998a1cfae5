"""The layouts of the files of launch monitors, and ``FORMATS``, which lists them by name.

A new layout is one :class:`Format`, and its name in ``FORMATS``.

FlightScope (Mevo, Mevo+, X3): the session table of FS Golf and myflightscope.com, sides written as ``10.5 L``.

Units stand in the headings, a dash where nothing was measured, and below the shots rows ``Avg`` and ``Dev``. The
headings are those of public exports (repositories dmombo/GolfStats and sghill/golf on GitHub) and parsers.

Foresight (GCQuad, GC3, GCHawk and others): the tables of FSX Play, and of FSX 2020 and FSX Pro.

FSX Play names unit and sign in its headings, as in ``Face Impact Horizontal (mm toe-/heel+)``. The older programs write
a title line and the side after each number, as in ``2.1 R`` or ``3.4 In-Out``, with rows of averages. The headings are
those of public parsers of such exports; the meanings are those of Foresight's guide to club and ball data.

Garmin Approach R10 and R50: the driving range table of the Garmin Golf app, in the language of the phone.

The file is UTF-8 with a byte order mark, and usually has a row of units such as ``[km/h]`` below the header. In
languages with decimal commas, semicolons may separate the cells. The headings are those of public exports and parsers
(repositories ummerr/mackenzie, jgamblin/golf and others on GitHub). In all of them sidespin has the opposite sign of
the spin axis.

GSPro: the shots that its portal exports, sides written as letters: ``11.4 R``, ``2.6° U``, ``1.2 I-O``, ``0.9 C``.

Speeds and lengths name their units in the headings, angles in the cells; spins name none.

Rapsodo MLM2PRO: the shot export, one table a club below a title line, ended by rows of average and deviation.

The title names the player. A newer export is a single table without the title. Neither names its units. The headings
are those of public exports (repository mmender2/GolfAnalysis on GitHub) and parsers.

Square Golf: the session that its app exports, a line of date and place, then shots club by club with their averages.

The side stands before the number, as in ``L1.2``; speed and lengths name their units, angles and spins do not.

TrackMan: the CSV of TrackMan Performance Studio, one row a shot, a row of units such as ``[mph]`` below the header.

The headings are those of public exports (repositories j72jones/stochasticGolf and tim-blackmore/
launch-monitor-regression on GitHub); the meanings are TrackMan's own parameter definitions (support.trackmangolf.com)
and the article "Club Data Definitions" (blog.trackmangolf.com).

Tables of recorded shots of any other kind: clubface's own, and those of programs whose columns are named as usual.

Their columns are those of the one vocabulary of quantities, :mod:`clubface.shots.tables.headings`. Nothing is known of
whoever wrote them: every quantity must have a unit, and columns of the same quantity must agree.
"""

from __future__ import annotations

from collections.abc import Mapping

from clubface.shots.formats import CG, CONTACT, FACE, PLAYER, UNKNOWN, Field, Format, common_names
from clubface.shots.monitor_cells import FACE_TO_PATH
from clubface.shots.tables.headings import HAND, plain, shot_words
from clubface.support.checks import Frozen
from clubface.units import DIMENSIONLESS

FLIGHTSCOPE = Format(
    name="flightscope",
    title="FlightScope Mevo, Mevo+ and X3, CSV of FS Golf",
    marks=(("Ball", "Smash", "Launch V", "Launch H"), ("Ball", "Smash", "Lateral"), ("Launch Angle V", "Ball Speed")),
    club=("Club",),
    fields={
        "speed": Field("Club", "Club Speed"),
        "attack": Field("AOA", "Angle of Attack", unit="deg"),
        "path": Field("Club Path", unit="deg", positive="right"),
        "loft": Field("Dynamic Loft", "D Loft", unit="deg"),
        "face": Field("FTT", "Face to Target", unit="deg", positive="right"),
        FACE_TO_PATH: Field("FTP", "Face to Path", unit="deg", positive="right"),
        "toe": Field("Lateral Impact", positive="toe"),
        "high": Field("Vertical Impact", positive="high"),
        "ball_speed": Field("Ball", "Ball Speed"),
        "smash": Field("Smash", "Smash Factor", unit="1"),
        "launch": Field("Launch V", "Launch Angle V", unit="deg"),
        "azimuth": Field("Launch H", "Launch Angle H", unit="deg", positive="right"),
        "total_spin": Field("Spin", unit="rpm"),
        "spin_axis": Field("Spin Axis", unit="deg", positive="right"),
        "apex": Field("Height"),
        "flight_time": Field("Time"),
        "carry": Field("Carry", "Carry Distance"),
        "side": Field("Lateral", positive="right"),
        "landing_angle": Field("DescentV", "Descent V", unit="deg"),
        "total": Field("Total"),
    },
    needs_units=False,
    speed_at=UNKNOWN,
    notes={"toe": "FlightScope does not publish the sign of its lateral impact: the toe was taken as positive"},
    source="public exports of FS Golf",
)


NOTES = {"closure": "Foresight takes the closure rate about the shaft; it is used as the rate about the vertical"}

_CLUB = {
    "attack": Field("Angle of Attack", unit="deg"),
    "path": Field("Club Path", unit="deg", positive="in-out"),
    "loft": Field("Loft", "Dynamic Loft", unit="deg"),
    "lie": Field("Lie", unit="deg", positive="toe up"),
    "closure": Field("Closure Rate", unit="deg/s"),
    "high": Field("Face Impact Vertical", unit="mm", positive="high"),
}
_BALL = {
    "ball_speed": Field("Ball Speed", unit="mph"),
    "smash": Field("Efficiency", "Smash Factor", unit="1"),
    "launch": Field("Launch Angle", unit="deg"),
    "total_spin": Field("Total Spin", unit="rpm"),
    "backspin": Field("Back Spin", "Backspin", unit="rpm"),
    "sidespin": Field("Side Spin", "Sidespin", unit="rpm", positive="right"),
    "landing_angle": Field("Descent Angle", unit="deg"),
    "apex": Field("Peak Height", unit="yd"),
    "carry": Field("Carry", unit="yd"),
}

PLAY = Format(
    name="foresight",
    title="Foresight FSX Play, CSV",
    marks=(
        ("Push/Pull",),
        ("Face to Target", "Closure Rate"),
        ("Face Impact Horizontal", "Face Impact Vertical", "Angle of Attack"),
    ),
    club=("Club Name", "Club", "Club Type"),
    fields={
        "speed": Field("Club Speed", unit="mph"),
        **_CLUB,
        "face": Field("Face to Target", unit="deg", positive="open"),
        "toe": Field("Face Impact Horizontal", unit="mm", positive="heel"),
        **_BALL,
        "azimuth": Field("Push/Pull", unit="deg", positive="right"),
        "total": Field("Total Distance", unit="yd"),
        "total_side": Field("Offline", unit="yd", positive="right"),
    },
    speed_at=FACE,
    face_at=UNKNOWN,
    notes=NOTES,
    source="Foresight Sports, Introduction to Understanding Ball Launch and Club Data",
)

FSX_2020 = Format(
    name="foresight-2020",
    title="Foresight FSX 2020 and FSX Pro, CSV",
    marks=(("Side Angle", "Tilt Angle"), ("Face Impact Lateral", "Face Impact Vertical"), ("Side Angle", "Backspin")),
    fields={
        "speed": Field("Club Speed", unit="mph"),
        **_CLUB,
        "face": Field("Face to Target", unit="deg", positive="open"),
        FACE_TO_PATH: Field("Face to Path", unit="deg", positive="open"),
        "toe": Field("Face Impact Lateral", unit="mm", positive="heel"),
        **_BALL,
        "azimuth": Field("Side Angle", unit="deg", positive="right"),
        "spin_axis": Field("Tilt Angle", "Spin Tilt Axis", unit="deg", positive="right"),
        "total": Field("Total", "Total Distance", unit="yd"),
        "total_side": Field("Offline", unit="yd", positive="right"),
    },
    speed_at=FACE,
    face_at=UNKNOWN,
    notes=NOTES,
    source=PLAY.source,
)


GARMIN = Format(
    name="garmin",
    title="Garmin Approach R10 and R50, CSV of the Garmin Golf app",
    marks=(
        ("Carry Deviation Distance", "Launch Direction"),
        ("Carry-Abweichungsdistanz", "Abflugrichtung"),
        ("Carry-afwijkingsafstand", "Slagrichting"),
        ("Distancia de desviación de vuelo", "Dirección de lanzamiento"),
    ),
    club=("Club Type", "Schlägerart", "Type club", "Tipo de palo", "Club Name", "Schlägername", "Clubnaam"),
    player=(*PLAYER, "Spieler", "Speler", "Jugador"),
    fields={
        "speed": Field("Club Speed", "Schl.gsch.", "Schlägergeschwindigkeit", "Clubsnelh.", "Vel. palo"),
        "attack": Field("Attack Angle", "Anstellwinkel", "Aanvalshoek", "Ángulo de ataque", unit="deg"),
        "path": Field(
            "Club Path", "Schwungbahn", "Clubtraject", "Línea cabeza del palo", unit="deg", positive="right"
        ),
        "face": Field(
            "Club Face", "Schlagfläche", "Slagvlak van de club", "Cara del palo", unit="deg", positive="right"
        ),
        "loft": Field("Dynamic Loft", unit="deg"),
        "ball_speed": Field("Ball Speed", "Ballgeschwindigkeit", "Balsnelheid", "Velocidad de la pelota"),
        "smash": Field("Smash Factor", "Smash-Faktor", "Smashfactor", "Calidad del impacto", unit="1"),
        "launch": Field("Launch Angle", "Abflugwinkel", "Slaghoek", "Ángulo de lanzamiento", unit="deg"),
        "azimuth": Field(
            "Launch Direction", "Abflugrichtung", "Slagrichting", "Dirección de lanzamiento", unit="deg",
            positive="right",
        ),
        "backspin": Field("Backspin", "Retroceso", unit="rpm"),
        "sidespin": Field("Sidespin", "Efecto lateral", unit="rpm", positive="left"),
        "total_spin": Field("Spin Rate", "Drehrate", "Spinsnelheid", "Velocidad de rotación", unit="rpm"),
        "spin_axis": Field("Spin Axis", "Drehachse", "Spinas", "Eje de rotación", unit="deg", positive="right"),
        "apex": Field("Apex Height", "Höhe des Scheitelpunkts", "Apexhoogte", "Altura máxima"),
        "carry": Field("Carry Distance", "Carry-Distanz", "Carry-afstand", "Dist.vuelo"),
        "side": Field(
            "Carry Deviation Distance", "Carry-Abweichungsdistanz", "Carry-afwijkingsafstand",
            "Distancia de desviación de vuelo", positive="right",
        ),
        "total": Field("Total Distance", "Gesamtstrecke", "Totale afstand", "Distancia total"),
        "total_side": Field(
            "Total Deviation Distance", "Gesamtabweichungsdistanz", "Totale afwijkingsafstand",
            "Distancia de desviación total", positive="right",
        ),
    },
    needs_units=True,
    counted=("Spin Rate Type", "Drehratentyp", "Type draaisnelheid", "Tipo de velocidad de rotación"),
    speed_at=UNKNOWN,
    face_at=UNKNOWN,
    notes={"sidespin": "Garmin's sidespin is positive to the left: its sign was turned"},
    source="public exports of the Garmin Golf app",
)  # fmt: skip


GSPRO = Format(
    name="gspro",
    title="GSPro, CSV of the portal",
    marks=(("Shot Key", "Ball Speed"), ("HLA", "VLA", "Club AoA"), ("HLA", "VLA", "Desc Angle")),
    club=("Club Name", "Club"),
    fields={
        "speed": Field("Club Speed", unit="mph"),
        "attack": Field("Club AoA", unit="deg"),
        "path": Field("Club Path", unit="deg", positive="in-out"),
        "loft": Field("Club Loft", "Dynamic Loft", unit="deg"),
        "face": Field("Face to Target", unit="deg", positive="open"),
        FACE_TO_PATH: Field("Face to Path", unit="deg", positive="open"),
        "lie": Field("Lie", unit="deg", positive="toe up"),
        "ball_speed": Field("Ball Speed", unit="mph"),
        "smash": Field("Smash Factor", unit="1"),
        "launch": Field("VLA", unit="deg"),
        "azimuth": Field("HLA", unit="deg", positive="right"),
        "backspin": Field("Back Spin", unit="rpm"),
        "sidespin": Field("Side Spin", unit="rpm", positive="right"),
        "total_spin": Field("Total Spin", unit="rpm"),
        "spin_axis": Field("Spin Axis", unit="deg", positive="right"),
        "apex": Field("Peak Height", unit="yd"),
        "landing_angle": Field("Desc Angle", "Descent Angle", unit="deg"),
        "carry": Field("Carry Dist", "Carry", unit="yd"),
        "total": Field("Total Dist", "Total", unit="yd"),
        "total_side": Field("Offline", unit="yd", positive="right"),
    },
    speed_at=UNKNOWN,
    source="exports of the GSPro portal",
)


RAPSODO = Format(
    name="rapsodo",
    title="Rapsodo MLM2PRO, shot export",
    marks=(("Club Type", "Club Brand", "Club Model"), ("Club Type", "Side Carry", "Launch Direction")),
    club=("Club Type",),
    title_of_player=r"Rapsodo MLM2PRO:\s*(.*?)\s+-\s+\d.*",
    fields={
        "speed": Field("Club Speed", unit="mph"),
        "attack": Field("Attack Angle", unit="deg"),
        "path": Field("Club Path", unit="deg", positive="right"),
        "ball_speed": Field("Ball Speed", unit="mph"),
        "smash": Field("Smash Factor", unit="1"),
        "launch": Field("Launch Angle", unit="deg"),
        "azimuth": Field("Launch Direction", unit="deg", positive="right"),
        "total_spin": Field("Spin Rate", unit="rpm"),
        "spin_axis": Field("Spin Axis", unit="deg", positive="right"),
        "apex": Field("Apex", unit="ft"),
        "carry": Field("Carry Distance", unit="yd"),
        "side": Field("Side Carry", unit="yd", positive="right"),
        "landing_angle": Field("Descent Angle", unit="deg"),
        "total": Field("Total Distance", unit="yd"),
    },
    counted=("Club Data Est Type",),
    speed_at=UNKNOWN,
    source="public exports of the MLM2PRO",
)


SQUARE = Format(
    name="square",
    title="Square Golf, CSV of the app",
    marks=(("Index", "Launch Direction", "Offline", "Landing Angle"), ("Index", "Spin Axis", "Apex", "Offline")),
    fields={
        "speed": Field("Club Speed", unit="mph"),
        "attack": Field("Attack Angle", unit="deg"),
        "path": Field("Club Path", unit="deg", positive="right"),
        "loft": Field("Dynamic Loft", unit="deg"),
        "face": Field("Face Angle", unit="deg", positive="right"),
        "ball_speed": Field("Ball Speed", unit="mph"),
        "smash": Field("Smash Factor", unit="1"),
        "launch": Field("Launch Angle", unit="deg"),
        "azimuth": Field("Launch Direction", unit="deg", positive="right"),
        "total_spin": Field("Spin Rate", unit="rpm"),
        "backspin": Field("Back Spin", unit="rpm"),
        "sidespin": Field("Side Spin", unit="rpm", positive="right"),
        "spin_axis": Field("Spin Axis", unit="deg", positive="right"),
        "apex": Field("Apex", unit="yd"),
        "landing_angle": Field("Landing Angle", unit="deg"),
        "carry": Field("Carry", unit="yd"),
        "total": Field("Total", unit="yd"),
        "total_side": Field("Offline", unit="yd", positive="right"),
    },
    speed_at=UNKNOWN,
    source="exports of the Square Golf app",
)


TRACKMAN = Format(
    name="trackman",
    title="TrackMan Performance Studio, CSV",
    marks=(
        ("Swing Direction", "Dyn. Loft"),
        ("Swing Direction", "Dynamic Loft"),
        ("Carry Flat - Length",),
        ("Swing Plane", "Swing Direction"),
        ("Club Speed", "Ball Speed", "Launch Direction", "Dyn. Loft"),
    ),
    fields={
        "speed": Field("Club Speed", unit="mph"),
        "attack": Field("Attack Angle", "Attack Ang.", unit="deg"),
        "path": Field("Club Path", unit="deg", positive="right"),
        "loft": Field("Dyn. Loft", "Dynamic Loft", unit="deg"),
        "face": Field("Face Angle", "Face Ang.", unit="deg", positive="right"),
        "toe": Field("Impact Offset", unit="mm", positive="toe"),
        "high": Field("Impact Height", unit="mm", positive="high"),
        "ball_speed": Field("Ball Speed", unit="mph"),
        "smash": Field("Smash Factor", unit="1"),
        "launch": Field("Launch Angle", "Launch Ang.", unit="deg"),
        "azimuth": Field("Launch Direction", "Launch Dir.", unit="deg", positive="right"),
        "total_spin": Field("Spin Rate", unit="rpm"),
        "spin_axis": Field("Spin Axis", unit="deg", positive="right"),
        "apex": Field("Max Height - Height", "Max Height", "Height", "Apex Height", unit="ft"),
        "carry": Field("Carry Flat - Length", "Carry", unit="yd"),
        "side": Field("Carry Flat - Side", "Carry Side", "Side", unit="yd", positive="right"),
        "landing_angle": Field("Carry Flat - Land. Angle", "Landing Angle", "Land. Angle", unit="deg"),
        "flight_time": Field("Carry Flat - Time", "Hang Time", unit="s"),
        "total": Field("Est. Total Flat - Length", "Total", unit="yd"),
        "total_side": Field("Est. Total Flat - Side", "Side Total", "Total Side", unit="yd", positive="right"),
    },
    counted=("Spin Rate Type",),
    speed_at=CG,
    face_at=CONTACT,
    notes={
        "path": "TrackMan takes attack angle, path, dynamic loft and face angle at maximum compression, about a "
        "quarter of a millisecond after first touch",
    },
    source="TrackMan, Data Parameter Definitions; TrackMan, Club Data Definitions (C. Hahn)",
)


_LAYOUTS = (
    TRACKMAN, PLAY, FSX_2020, GARMIN, RAPSODO, FLIGHTSCOPE,
    GSPRO, SQUARE,
)  # fmt: skip
FORMATS: Mapping[str, Format] = Frozen({each.name: each for each in _LAYOUTS})


def _fields() -> dict[str, Field]:
    """Return the columns of all that is measured, and of the properties of club and ball that a delivery may have."""
    names, dimensions = shot_words()
    headings = {name: quantity for name, (quantity, _) in common_names().items()}
    headings |= {plain(name.replace("_", " ")): name for name in names if name == names[name] and name != HAND}
    return {
        quantity: Field(
            *(name for name, each in headings.items() if each == quantity),
            unit="1" if dimensions.get(quantity) == DIMENSIONLESS else None,
        )
        for quantity in dict.fromkeys(headings.values())
    }


TABLE = Format(
    name="clubface",
    title="table of shots",
    fields=_fields(),
    file=("File",),
    needs_units=True,
    all_columns=True,
    speed_at=CG,
    face_at=FACE,
)
"""Its club data is taken where models want it unless columns ``speed_at`` and ``face_at`` say otherwise."""
