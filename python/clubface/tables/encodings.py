"""The encoding of a table's text: Unicode by its mark or its zero bytes, else what makes words of the other bytes."""

from __future__ import annotations

import codecs
import re
import tempfile
from collections.abc import Mapping
from typing import BinaryIO

from clubface.errors import FileError

SAMPLE = 1 << 18
"""Bytes that decide the encoding of what is not UTF-8."""
IN_MEMORY = 1 << 25
"""Bytes of text transcoded to UTF-8 that are held in memory; more go to a temporary file."""
NAMES = {
    "cp1252": "Windows-1252", "mac_roman": "Mac Roman", "cp932": "Shift-JIS", "gb18030": "GBK", "big5": "Big5",
    "cp949": "EUC-KR", "utf-16-le": "UTF-16", "utf-16-be": "UTF-16", "utf-32-le": "UTF-32", "utf-32-be": "UTF-32",
}  # fmt: skip
"""The encodings that are read besides UTF-8, as people call them."""
FALLBACK = "cp1252"

_MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32-le"),
    (codecs.BOM_UTF32_BE, "utf-32-be"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)
_LATIN = re.compile("[ÄÖÜäöüßÀÂÇÈÉÊËÎÏÔŒÙÛàâçèéêëîïôœùûÁÍÑÓÚáíñóúÅÆØåæøÃÕãõìò°º²’‘“”–—½\xa0]")
_EVERYDAY: Mapping[str, re.Pattern[str]] = {
    "cp932": re.compile(
        "[ぁ-んァ-ヶー・番号球速度距離飛打出角回転数初高左右日時間名合計平均率最大総曲幅入射方向横縦残地点℃°]"
    ),
    "gb18030": re.compile(
        "[球杆速度距离角铁木号日期时间总飞行高左右旋转击打出面路径效率侧后倒平均最大落点偏差向程挖起推发°]"
    ),
    "big5": re.compile(
        "[球桿速度距離角鐵木號日期時間總飛行高左右旋轉擊打出面路徑效率側後倒平均最大落點偏差向程挖起推發°]"
    ),
    "cp949": re.compile(
        "[볼클럽스피드거리각도비캐리발사런치스핀량축방향아이언드라버우웨지번시간날짜총최고높좌회전수백사이헤팩터샷°]"
    ),
    "cp1252": _LATIN,
    "mac_roman": _LATIN,
}
"""Characters that tables of golf shots hold, by encoding: text of another encoding gives others.

Of encodings that fit as well the first counts: what makes everyday words of two bytes each does so by no accident.
"""


def unicode_by_bytes(start: bytes) -> tuple[str, int]:
    """Return the Unicode encoding of a text from its first bytes, and the length of its byte order mark.

    Text without a mark is UTF-16 where every other byte of some of it is zero, as in digits and commas, and few of the
    bytes between are; else UTF-8, which it need not be in the end.
    """
    for mark, encoding in _MARKS:
        if start.startswith(mark):
            return encoding, len(mark)
    pairs = len(start) // 2
    zeros = [start[0::2].count(0), start[1::2].count(0)]
    for place, encoding in ((1, "utf-16-le"), (0, "utf-16-be")):
        if pairs > 3 and zeros[place] > 0.1 * pairs and zeros[1 - place] < 0.25 * zeros[place]:
            return encoding, 0
    return "utf-8", 0


def as_utf8(file: BinaryIO, encoding: str, path: str) -> BinaryIO:
    """Return a file with the rest of the text of another, in UTF-8."""
    decoder = codecs.getincrementaldecoder(encoding)()
    text = tempfile.SpooledTemporaryFile(IN_MEMORY)  # noqa: SIM115 - it is returned open
    try:
        while chunk := file.read(SAMPLE):
            text.write(decoder.decode(chunk).encode())
        text.write(decoder.decode(b"", True).encode())
    except (UnicodeError, OSError) as error:
        text.close()
        what = "is damaged" if isinstance(error, UnicodeError) else f"cannot be read: {error.strerror}"
        raise FileError(path, None, f"this {NAMES[encoding]} text {what}; save it as CSV UTF-8") from None
    text.seek(0)
    return text  # pyright: ignore[reportReturnType]


def encoding_of(text: bytes) -> str:
    """Return the encoding, other than UTF-8, in which a text holds most characters that tables of shots hold.

    It must decode the whole text, and half of the characters that are not ASCII must be such; else it is Windows-1252.
    """
    scores = {name: _score(text, name) for name in _EVERYDAY}
    best = max(scores, key=lambda name: scores[name])
    return best if scores[best] >= 0.5 else FALLBACK


def _score(text: bytes, encoding: str) -> float:
    """Return the part of the characters beyond ASCII that are everyday ones; -1 where the text has another encoding."""
    try:
        beyond = re.sub(r"[\x00-\x7f]+", "", text.decode(encoding))
    except UnicodeDecodeError:
        return -1.0
    return len(_EVERYDAY[encoding].findall(beyond)) / max(len(beyond), 1)
