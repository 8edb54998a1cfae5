"""Small files of deliveries, and what is read back from the files made of them."""

import csv

HEAD = "id,club_speed_mph,attack_deg,Dynamic Loft [deg],impact_toe_mm\n"
GOOD = HEAD + "a,113,-1.3,12.8,5\nb,108,2,13,-3\n"


def table(path, delimiter=","):
    """The rows of a CSV file by heading."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file, delimiter=delimiter))
