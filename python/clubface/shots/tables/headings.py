"""Which column of a table of shots is which quantity, and in which unit.

How the headings of tables are spelled: their words, and the unit in brackets behind them.

Headings of tables of shots in the languages of golfers, as translated programs and people write them.

Only words that can mean nothing else are here; how they are spelled together does not count.
"""

from __future__ import annotations

import re
import unicodedata
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import cache, lru_cache
from typing import NamedTuple

from clubface import units
from clubface.errors import FileError, UnitError, shortened
from clubface.quantities import file_unit
from clubface.simulation.results import flight_outputs, input_dimensions, inputs, outputs
from clubface.support.checks import check_choice
from clubface.units import unit

_UNITS = {
    "yards": "yd", "yds": "yd", "yd": "yd", "feet": "ft", "inches": "in", "inch": "in", "meters": "m", "metres": "m",
    "meter": "m", "metre": "m", "deg/sec": "deg/s", "degrees/s": "deg/s", "dps": "deg/s", "°/sec": "deg/s",
    "degs": "deg", "grad": "deg", "graden": "deg", "grados": "deg", "km/u": "km/h", "km/hr": "km/h", "kmph": "km/h",
    "u/min": "rpm", "1/min": "rpm", "tpm": "rpm", "omw/min": "rpm", "sek": "s", "sec": "s",
    **dict.fromkeys(("yard", "yrd", "yrds", "y", "yarda", "yardas", "ヤード", "码", "碼", "야드"), "yd"),
    **dict.fromkeys(("foot", "pieds", "pies", "piedi", "fuß", "フィート", "英尺", "피트"), "ft"),
    **dict.fromkeys(("zoll", "pouces", "pulgadas", "pollici", "インチ"), "in"),
    **dict.fromkeys(("mtr", "mtrs", "mètres", "mètre", "metros", "metri", "メートル", "米", "미터"), "m"),
    **dict.fromkeys(("º", "degré", "degrés", "gradi", "graus", "grader", "aste", "度", "도"), "deg"),
    **dict.fromkeys(("º/s", "grad/s", "grados/s", "度/秒"), "deg/s"),
    **dict.fromkeys(("m.p.h", "mi/h", "miles/h", "英里/小时", "英里/小時"), "mph"),
    **dict.fromkeys(("km/t", "kph", "kmh", "㎞/h", "公里/小时", "公里/小時"), "km/h"),
    **dict.fromkeys(("m/sec", "mps", "m/秒", "米/秒", "㎧"), "m/s"),
    **dict.fromkeys(("rev/min", "r/min", "tr/min", "giri/min", "upm", "v/min", "回転/分", "转/分", "轉/分"), "rpm"),
    **dict.fromkeys(("varv/min", "tr/mn"), "rpm"),
    **dict.fromkeys(("seconds", "secs", "秒", "초"), "s"),
}  # fmt: skip
"""Further spellings of units in the files of launch monitors and spreadsheets, without a point at the end."""

_WIDE = {code: code - 0xFEE0 for code in range(0xFF01, 0xFF5F)} | {0x3000: " "}
"""The letters, digits and brackets that take the width of a Chinese character, and the usual ones."""
_GAPS = re.compile(r"(?:[\s,/_–-]|\bin\b)+")
"""What stands between a heading and its unit."""
_BRACKETS = re.compile(r"\s*[\[(]([^\[\]()]*)[\])]\s*$")


def plain(text: str) -> str:
    """Return the words of a text in lower case, without punctuation; an underscore parts words as a space does."""
    return " ".join(re.findall(r"[^\W_]+", unicodedata.normalize("NFC", text).casefold()))


def squeezed(name: str) -> str:
    """Return plain words without the spaces between them, in which ``BallSpeed`` and ``Ball Speed`` are the same."""
    return name.replace(" ", "")


def words_apart(text: str) -> str:
    """Return a text in which small and large letters begin words, ``ballSpeedMph``, with spaces between them."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text)


def units_behind(text: str) -> Iterator[tuple[str, str]]:
    """Yield how a heading may part into a name in plain words and the unit behind it: ``Carry/yd``, ``Spin in rpm``."""
    apart = words_apart(text)
    for gap in _GAPS.finditer(apart):
        last = apart[gap.end() :]
        if (len(last) > 1 or last in ("m", "s")) and (symbol := unit_symbol(last)) is not None:
            yield plain(apart[: gap.start()]), symbol


def narrow(text: str) -> str:
    """Return a text with usual letters for those that take the width of a Chinese character."""
    return text if text.isascii() else text.translate(_WIDE)


def bracketed(text: str) -> tuple[str, str | None]:
    """Return what stands before the brackets at the end of a heading, and what in them; None where there are none."""
    text = narrow(text)
    found = _BRACKETS.search(text)
    return (text, None) if found is None else (text[: found.start()], found[1].strip())


@lru_cache(maxsize=4096)
def unit_symbol(text: str) -> str | None:
    """Return the symbol of the unit that a monitor writes as ``text``, or None for an unknown one."""
    spelled = narrow(text).strip().strip("[]()").strip()
    lower = spelled.lower().removesuffix(".")
    for each in (spelled, lower, _UNITS.get(lower, "")):
        try:
            if each:
                return unit(each).symbol
        except UnitError:
            continue
    return None


def unit_of_column(text: str, dimension: str, heading: str, place: tuple[str, int | None]) -> str:
    """Return the symbol of the unit that a heading names; one that is unknown or does not fit is an error."""
    try:
        return unit(unit_symbol(text) or text, name=f"the unit of the column {heading!r}", dimension=dimension).symbol
    except UnitError as error:
        raise FileError(*place, str(error), heading) from None


_HEADINGS = {
    "speed": """Schlägerkopfgeschwindigkeit|Schlägerkopfgeschw|Schlägergeschwindigkeit|Schlägergeschw
        |Schlägerkopftempo|Vitesse club|Vitesse du club|Vitesse de club|Vitesse tête de club
        |Vitesse de la tête de club|Velocidad del palo|Velocidad de palo|Velocidad palo|Velocidad de la cabeza
        |Velocidad de la cabeza del palo|Velocidad cabeza palo|Velocità bastone|Velocità del bastone
        |Velocità testa bastone|Klubbhastighet|Klubbhuvudshastighet|Klubbhuvudhastighet|Køllehastighed
        |Køllehastighet|Clubsnelheid|Clubhoofdsnelheid|Velocidade do taco|ヘッドスピード|ヘッド速度|クラブスピード
        |クラブヘッドスピード|杆头速度|桿頭速度|挥杆速度|揮桿速度|球杆速度|헤드 스피드|클럽 스피드
        |클럽 헤드 스피드|클럽 속도""",
    "attack": """Eintreffwinkel|Angriffswinkel|Anstellwinkel|Angle d'attaque|Ángulo de ataque|Angolo di attacco
        |Angolo d'attacco|Attackvinkel|Anfaldsvinkel|Angrepsvinkel|Aanvalshoek|Ângulo de ataque|アタックアングル
        |アタック角|入射角|攻击角度|攻擊角度|攻击角|攻角|어택 앵글|어택앵글|입사각""",
    "path": """Schlägerpfad|Schwungbahn|Schlägerbahn|Chemin du club|Chemin de club|Trajectoire du club
        |Trayectoria del palo|Trayectoria de palo|Percorso bastone|Traiettoria bastone|Klubbana|Svingbana|Klubbväg
        |Køllebane|Clubpad|クラブパス|スイングパス|杆头路径|桿頭路徑|挥杆路径|揮桿路徑|클럽 패스|클럽 궤도
        |스윙 패스""",
    "loft": """Dynamischer Loft|Dyn Loft|Loft dynamique|Loft dinámico|Loft dinamico|Dynamiskt loft|Dynamisk loft
        |Dynamische loft|ダイナミックロフト|动态杆面倾角|動態桿面傾角|다이나믹 로프트|다이내믹 로프트""",
    "face": """Schlagflächenwinkel|Schlägerblattwinkel|Schlagflächenstellung|Angle de face|Angle de la face
        |Ángulo de cara|Ángulo de la cara|Angolo faccia|Angolo della faccia|Bladvinkel|Klubbladsvinkel
        |Klubbladvinkel|フェースアングル|フェース角|フェイスアングル|フェイス角|杆面角度|桿面角度|杆面角
        |페이스 앵글|페이스앵글|페이스 각도""",
    "ball_speed": """Ballgeschwindigkeit|Ballgeschw|Balltempo|Vitesse balle|Vitesse de balle|Vitesse de la balle
        |Velocidad de bola|Velocidad de la bola|Velocidad bola|Velocidad de la pelota|Velocità palla
        |Velocità della palla|Bollhastighet|Boldhastighed|Ballhastighet|Balsnelheid|Velocidade da bola
        |ボールスピード|ボール初速|ボール速度|初速|球速|球初速|볼 스피드|볼 속도""",
    "smash": """Smash Faktor|Facteur de smash|Smash facteur|Factor de smash|Fattore smash|ミート率
        |スマッシュファクター|击球效率|擊球效率|撞击系数|스매시 팩터|스매쉬 팩터|스매시팩터""",
    "launch": """Abflugwinkel|Startwinkel|Launchwinkel|Angle de lancement|Angle de départ|Angle de décollage
        |Ángulo de lanzamiento|Ángulo de salida|Angolo di lancio|Utgångsvinkel|Utslagsvinkel|Startvinkel
        |Udgangsvinkel|Utgangsvinkel|Lanceerhoek|Ângulo de lançamento|打ち出し角|打出角|打出し角|打ち出し角度
        |打出角度|起飞角|起飞角度|起飛角|起飛角度|发射角|发射角度|發射角|발사각|발사 각도|탄도각|런치 앵글""",
    "azimuth": """Abflugrichtung|Startrichtung|Direction de lancement|Direction de départ|Dirección de lanzamiento
        |Dirección de salida|Direzione di lancio|Utgångsriktning|Startriktning|Udgangsretning|Utgangsretning
        |Lanceerrichting|左右打ち出し角|左右打出角|打ち出し方向|打出方向|打出し方向|方向角|发射方向|起飞方向
        |發射方向|방향각|발사 방향|좌우 발사각""",
    "backspin": """Rückwärtsdrall|Rétro rotation|Bakspinn|Backspinn|バックスピン|バックスピン量|后旋|後旋|后旋转
        |백스핀|백 스핀""",
    "sidespin": """Seitendrall|Seitwärtsdrall|Rotation latérale|Sidspinn|Sidospinn|サイドスピン|サイドスピン量
        |侧旋|側旋|사이드스핀|사이드 스핀""",
    "total_spin": """Spinrate|Drehrate|Taux de rotation|Taux de spin|Vitesse de rotation|Giro|Tasa de giro
        |Velocidad de giro|Velocidad de rotación|Tasso di rotazione|Spinnhastighet|Spinn|Spinsnelheid|スピン量
        |スピンレート|トータルスピン|总旋转|總旋轉|旋转速度|自旋速率|스핀량|스핀 레이트|총 스핀|토탈 스핀""",
    "spin_axis": """Spinachse|Drehachse|Axe de rotation|Axe de spin|Eje de giro|Eje de rotación|Asse di rotazione
        |Spinnaxel|Spinaxel|Spinakse|Spinas|スピン軸|スピンアクシス|旋转轴|旋轉軸|스핀 축|스핀축""",
    "carry": """Carry Distanz|Carryweite|Flugweite|Fluglänge|Portée|Distance de carry|Vuelo|Distancia de vuelo
        |Distancia de carry|Distanza di volo|Carrylängd|Carryavstånd|Carrylængde|Carry afstand|キャリー
        |キャリー距離|飞行距离|飛行距離|落点距离|落點距離|캐리|캐리 거리|비거리""",
    "total": """Gesamtdistanz|Gesamtweite|Gesamtlänge|Distance totale|Distancia total|Distanza totale
        |Totalt avstånd|Total distans|Totallängd|Totale afstand|トータル|トータル距離|総飛距離|总距离|總距離
        |总码数|총 거리|총거리|총 비거리|토탈 거리""",
    "side": """Seitenabweichung Carry|Écart latéral|Déviation latérale|Desviación lateral|Deviazione laterale
        |Sidavvikelse|左右ブレ|左右幅|左右偏差|横向偏差|橫向偏差|좌우 편차|좌우편차""",
    "apex": """Scheitelhöhe|Scheitelpunkt|Maximale Höhe|Max Höhe|Hauteur maximale|Hauteur max|Altura máxima
        |Altezza massima|Höhe|Flughöhe|Hauteur|Höjd
        |Maxhöjd|Maximal höjd|最高到達点|最高点|最大高さ|最高飞行高度|最大高度|최고점|최고 높이
        |최대 높이""",
    "flight_time": """Flugzeit|Flugdauer|Temps de vol|Tiempo de vuelo|Tempo di volo|Flygtid|滞空時間|飞行时间
        |滞空时间|체공 시간|체공시간""",
    "landing_angle": """Landewinkel|Auftreffwinkel|Angle d'atterrissage|Angle de descente|Ángulo de aterrizaje
        |Ángulo de descenso|Ángulo de caída|Angolo di atterraggio|Landningsvinkel|Nedslagsvinkel|落下角|落下角度
        |着弾角|落地角度|落地角|下降角|착지각|낙하각|랜딩 앵글""",
}  # fmt: skip

CLUB = """Schläger|Schlägerart|Schlägertyp|Type de club|Palo|Tipo de palo|Bastone|Klubba|Klubb|Kølle|Maila|Taco
    |クラブ|番手|使用クラブ|球杆|球桿|球杆类型|클럽|클럽명|골프채"""
PLAYER = """Spieler|Spielername|Joueur|Nom du joueur|Jugador|Giocatore|Spelare|Spiller|Speler|Pelaaja|Jogador
    |プレーヤー|プレイヤー|選手|氏名|球员|球員|선수|플레이어"""


def names(text: str) -> tuple[str, ...]:
    """Return the names in a text, which bars part."""
    return tuple(each.strip() for each in text.replace("\n", "").split("|"))


FOREIGN_HEADINGS = {quantity: names(text) for quantity, text in _HEADINGS.items()}
"""The headings of each quantity."""


SYNONYMS = {
    "speed": (
        "club_speed", "clubhead_speed", "club_head_speed", "head_speed", "clubspeed", "swing_speed", "club_velocity",
        "clubhead_velocity", "club_head_velocity",
    ),
    "attack": (
        "attack_angle", "angle_of_attack", "aoa", "club_aoa", "attack_ang", "vert_path", "vertical_path",
        "vertical_club_path", "club_attack_angle",
    ),
    "path": (
        "club_path", "swing_path", "horiz_path", "horizontal_path", "horizontal_club_path", "path_angle",
        "club_path_angle", "clubhead_path",
    ),
    "loft": ("dynamic_loft", "dyn_loft", "delivered_loft", "loft_at_impact", "impact_loft"),
    "face": (
        "face_angle", "club_face_angle", "clubface_angle", "face_ang", "club_face", "face_to_target", "ftt",
        "face_to_target_angle", "club_face_to_target",
    ),
    "lie": ("lie_tilt",),
    "toe": (
        "impact_toe", "toe_offset", "impact_offset", "horiz_impact", "horizontal_impact", "impact_horizontal",
        "horizontal_face_impact", "face_impact_horizontal", "face_impact_lateral", "lateral_impact",
    ),
    "high": (
        "impact_high", "high_offset", "impact_height", "vert_impact", "vertical_impact", "impact_vertical",
        "vertical_face_impact", "face_impact_vertical",
    ),
    "closure": ("closure_rate", "face_closure", "face_closure_rate", "rate_of_closure"),
    "pitch_rate": ("loft_rate",),
    "lie_rate": (),
    "ball_backspin": (),
    "ball_sidespin": (),
    "ball_riflespin": (),
    "hand": ("handedness",),
}  # fmt: skip
"""Other names of the inputs of a delivery, in the words of launch monitors and of those who read them."""

LAUNCH_SYNONYMS = {
    "ball_speed": (
        "ball_velocity", "ballspeed", "initial_ball_speed", "launch_speed",
    ),
    "smash": ("smash_factor", "efficiency", "smash_fac"),
    "launch": (
        "launch_angle", "vertical_launch_angle", "vertical_launch", "vla", "launch_ang", "launch_v", "launch_angle_v",
        "vert_launch", "vert_launch_angle", "launch_angle_vertical",
    ),
    "azimuth": (
        "launch_direction", "horizontal_launch_angle", "horizontal_launch", "side_angle", "hla", "launch_dir",
        "launch_h", "launch_angle_h", "horiz_launch", "horiz_launch_angle", "launch_angle_horizontal", "push_pull",
        "launch_azimuth", "start_direction", "start_line",
    ),
    "backspin": ("back_spin",),
    "sidespin": ("side_spin",),
    "total_spin": ("spin_rate", "spin", "ball_spin", "total_spin_rate"),
    "spin_axis": (
        "spin_axis_tilt", "spin_tilt", "tilt_angle", "spin_tilt_axis", "spin_axis_angle", "axis_tilt", "tilt_axis",
    ),
    "contact_time": (),
    "peak_force": (),
    "carry": ("carry_distance", "carry_dist", "carry_length", "carry_flat", "carry_flat_length", "flat_carry"),
    "side": (
        "carry_side", "side_carry", "offline", "lateral", "lateral_distance", "side_distance", "carry_offline",
        "carry_deviation", "carry_deviation_distance",
    ),
    "apex": ("peak_height", "max_height", "apex_height", "height", "maximum_height", "peak_ht", "max_ht"),
    "flight_time": ("hang_time", "time_of_flight", "air_time", "hangtime"),
    "landing_angle": (
        "landing", "descent_angle", "desc_angle", "land_angle", "angle_of_descent", "descent", "descent_v", "descentv",
    ),
    "landing_speed": (),
    "total": ("total_distance", "total_dist", "total_length"),
    "total_side": ("side_total", "total_offline", "total_deviation", "total_deviation_distance"),
}  # fmt: skip
"""The quantities of a launch and its flight that a table may hold, with other names of each."""

SECOND_CHOICE = frozenset({"carry_flat", "carry_flat_length", "flat_carry"})
"""Names of what is nearly the quantity: read only where the file has no other column of it."""
HAND = "hand"
MOST_NAMED = 12
"""Columns that an error names."""


class Vocabulary(NamedTuple):
    """The words a table may use.

    Attributes
    ----------
    names
        The quantity meant by every name a column may have.
    dimensions
        The dimension of each quantity.
    """

    names: Mapping[str, str]
    dimensions: Mapping[str, str]

    def spelled(self, name: str) -> str:
        """Return the name that is the same but for where its words part, as of ``clubspeed``; else ``name``."""
        return name if name in self.names else _unparted(frozenset(self.names)).get(name.replace("_", ""), name)


@cache
def _unparted(names: frozenset[str]) -> Mapping[str, str]:
    return {each.replace("_", ""): each for each in names}


@cache
def delivery_words() -> Vocabulary:
    """Return the words for the inputs of an impact."""
    own = {name: name for name in inputs()}
    foreign = {name: each for name, each in FOREIGN_HEADINGS.items() if name in own}
    return Vocabulary({**_reversed(foreign), **own, **_reversed(SYNONYMS)}, input_dimensions())


@cache
def shot_words() -> Vocabulary:
    """Return the words for the inputs of an impact and for what is measured of the launch and the flight."""
    names, dimensions = delivery_words()
    found = {**flight_outputs(), **outputs()}
    own = {name: name for name in LAUNCH_SYNONYMS}
    launches = {name: found[name].dimension for name in LAUNCH_SYNONYMS}
    foreign = {name: each for name, each in FOREIGN_HEADINGS.items() if name in launches}
    words = {**_reversed(foreign), **names, **own, **_reversed(LAUNCH_SYNONYMS)}
    return Vocabulary(words, {**dimensions, **launches})


class Column(NamedTuple):
    """A column that is used.

    Attributes
    ----------
    place
        Its place in a row.
    heading
        As in the file.
    quantity
        The input it gives.
    unit
        The unit of its numbers.
    """

    place: int
    heading: str
    quantity: str
    unit: str


class Layout(NamedTuple):
    """What the columns of a file mean.

    Attributes
    ----------
    headings
        Names of all columns, as in the file; a column without a name is named after its place.
    used
        The columns that give inputs.
    passed
        Headings of the columns that are only passed through.
    notes
        What a reader of the result should know.
    """

    headings: tuple[str, ...]
    used: tuple[Column, ...]
    passed: tuple[str, ...]
    notes: tuple[str, ...]


POINTS = {"speed_at": ("cg", "face", "unknown"), "face_at": ("face", "contact", "unknown")}
"""Columns that say where on the club its motion and its face angles were taken, and what they may say, first where
models want them. They are there only where it is elsewhere."""


def layout(
    headings: Sequence[str],
    path: str,
    line: int | None,
    words: Vocabulary | None = None,
    given_units: Mapping[str, str] | None = None,
    remedy: Callable[[Mapping[str, str]], str] | None = None,
) -> Layout:
    """Find the quantities among ``headings``; a unit that does not fit or a repeated column is an error.

    Without ``words`` they are the inputs of an impact. ``given_units`` are the units, by quantity or dimension, of
    columns that name none; all columns that then have none are named in an error. ``remedy`` says how units are given,
    by name; unless given, as options of a command.
    """
    given_units = given_units or {}
    words = words or delivery_words()
    named = tuple(heading.strip() or f"column_{place + 1}" for place, heading in enumerate(headings))
    if len(set(named)) < len(named):
        heading = next(each for each, count in Counter(named).items() if count > 1)
        raise FileError(path, line, f"the column {heading!r} is there twice", heading)
    used: dict[str, Column] = {}
    passed, notes = [], []
    without_unit: list[tuple[str, str]] = []
    for place, heading in enumerate(named):
        name, unit = split_heading(heading, words)
        quantity = words.names.get(name)
        if quantity is None:
            passed.append(heading)
            near = None if name in POINTS else _near(name, words.names)
            if near is not None:
                notes.append(f"the column {shortened(heading, 80)!r} is not used; did you mean {near}?")
            continue
        if quantity in used:
            message = f"the columns {used[quantity].heading!r} and {heading!r} both give the {quantity}"
            raise FileError(path, line, message, heading)
        dimension = words.dimensions[quantity]
        if unit is not None:
            symbol = unit_of_column(unit, dimension, heading, (path, line))
        else:
            symbol = given_unit(given_units, quantity, dimension)
            if symbol is None and dimension != units.DIMENSIONLESS:
                without_unit.append((heading, quantity))
        used[quantity] = Column(place, heading, quantity, symbol or "1")
    if without_unit:
        raise missing_units(without_unit, path, line, words.dimensions, remedy)
    return Layout(named, tuple(used.values()), tuple(passed), tuple(notes))


SPIN = ("backspin", "sidespin", "total_spin")
GROUPS = {"spin": ("angular rate", SPIN)}
"""Names under which units may be given for several quantities of a dimension at once."""


def given_unit(given: Mapping[str, str], quantity: str, dimension: str) -> str | None:
    """Return the unit that was given for a quantity: by its name, its group or its dimension, the closest first."""
    groups = (name for name, (_, members) in GROUPS.items() if quantity in members)
    return next((given[name] for name in (quantity, *groups, dimension) if name in given), None)


def check_units(given: Mapping[str, str], dimensions: Mapping[str, str] | None = None) -> dict[str, str]:
    """Return units by quantity, group or dimension, each checked; ``dimensions`` are those of the quantities.

    Raises
    ------
    UnknownNameError
        A name is none of them.
    UnitError
        A unit is not known, or of another dimension.
    """
    dimensions = shot_words().dimensions if dimensions is None else dimensions
    groups = {name: dimension for name, (dimension, members) in GROUPS.items() if set(members) & set(dimensions)}
    known = {**{each: each for each in dimensions.values()}, **groups, **dimensions}
    for name, symbol in given.items():
        check_choice("quantity or dimension", name, known)
        units.unit(symbol, name=f"the unit of {name}", dimension=known[name])
    return dict(given)


def missing_units(
    columns: Sequence[tuple[str, str]],
    path: str,
    line: int | None,
    dimensions: Mapping[str, str],
    remedy: Callable[[Mapping[str, str]], str] | None = None,
) -> FileError:
    """Return the error on columns, by heading and quantity, whose unit nothing names: a number alone is no value."""
    options = {}
    for _, quantity in columns:
        dimension = dimensions[quantity]
        unit = heading_of(quantity, units.SI_UNITS[dimension])[1]
        unit = "yd" if unit == "m" else unit
        if quantity in SPIN:
            options["spin"] = unit
        elif options.setdefault(dimension, unit) != unit or " " in dimension:
            options[quantity] = unit
    options = {name: unit for name, unit in options.items() if " " not in name}
    if (shown := [shortened(repr(heading), 40) for heading, _ in columns[:MOST_NAMED]]) and len(columns) > MOST_NAMED:
        shown.append(f"and {len(columns) - MOST_NAMED} more")
    one = len(columns) == 1
    message = (
        f"the column{'s' * (not one)} {', '.join(shown)} name{'s' * one} no unit: give {'it' if one else 'them'}, as "
        f"in {(remedy or _as_options)(options)}, with the units in which the numbers were written"
    )
    return FileError(path, line, message, columns[0][0])


def _as_options(units: Mapping[str, str]) -> str:
    given = " ".join(f"--unit {name}={unit}" for name, unit in units.items())
    return f"{given} (in Python units={units!r} of launch_monitor.read or predict)"


def require_speed(found: Layout, path: str, line: int | None) -> None:
    """Refuse a table without the clubhead speed, the one input without a default."""
    if all(each.quantity != "speed" for each in found.used):
        message = f'there is no column for the clubhead speed, such as "club_speed_mph"; {listed(found.headings)}'
        raise FileError(path, line, message, "speed")


def listed(headings: Sequence[str]) -> str:
    """Name the columns there are, the first dozen of them; what no terminal should be sent becomes a question mark."""
    first = [shortened(heading, 40) for heading in headings[:12]]
    shown = ["".join(each if each.isprintable() else "?" for each in heading) for heading in first]
    return "there are: " + ", ".join(shown) + (", ..." if len(headings) > 12 else "")


def split_heading(heading: str, words: Vocabulary) -> tuple[str, str | None]:
    """Return the name in lower case and the unit of a heading, known or not: ``club_speed_mph``, ``Speed [mph]``."""
    before, unit_text = bracketed(heading)
    name = words.spelled(plain_name(before))
    if unit_text is None:
        for spelled in (before, before.lower()):
            short, unit = units.parse_column_name("_".join(spelled.replace("-", "_").split()), words.names)
            if (known := words.spelled(plain_name(short))) in words.names:
                return known, unit
        for short, unit in units_behind(before):
            if (known := words.spelled(plain_name(short))) in words.names:
                return known, unit
        return name, None
    return name, unit_text or None


def plain_name(name: str) -> str:
    """Return a heading in lower case with underscores between its words."""
    return plain(name).replace(" ", "_").strip("_")


def _near(name: str, known: Collection[str]) -> str | None:
    """Return the known name that ``name``, with or without a unit at its end, is most likely a misspelling of."""
    from difflib import get_close_matches

    for each in (name, name.rpartition("_")[0]):
        if len(each) > 3 and (near := get_close_matches(each, known, 1, 0.8)):
            return near[0]
    return None


def _reversed(synonyms: Mapping[str, Sequence[str]]) -> dict[str, str]:
    return {plain_name(other): name for name, others in synonyms.items() for other in others}


def heading_of(name: str, si_unit: str) -> tuple[str, str]:
    """Return the heading of a column and its unit."""
    shown = "mph" if si_unit == "m/s" else file_unit(name, si_unit)
    spelled = "club_speed" if name == "speed" else name
    if shown == "1":
        return spelled, shown
    return (f"{spelled}_{shown}" if shown.isalnum() else f"{spelled} [{shown}]"), shown
