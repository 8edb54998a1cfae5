"""Garmin Approach R10 and R50: the driving range table of the Garmin Golf app, in the language of the phone.

The file is UTF-8 with a byte order mark, and usually has a row of units such as ``[km/h]`` below the header. In
languages with decimal commas, semicolons may separate the cells. The headings are those of public exports and parsers
(repositories ummerr/mackenzie, jgamblin/golf and others on GitHub). In all of them sidespin has the opposite sign of
the spin axis.
"""

from __future__ import annotations

from clubface.launch_monitor.formats import PLAYER, UNKNOWN, Field, Format

FORMAT = Format(
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
