"""Reads the tables of a run: CSV behind comments that open with '#'. Standard library only."""
import csv


class CsvFile:
    """comments, names of the columns, and rows of words.

    @raise ValueError if there is no line with names
    """

    def __init__(self, path):
        with open(path, newline="", encoding="utf-8") as file:
            lines = file.read().splitlines()
        self.comments = [line[1:].strip() for line in lines if line.startswith("#")]
        rows = list(csv.reader(line for line in lines if line and not line.startswith("#")))
        if not rows:
            raise ValueError(f"'{path}' has no line with the names of its columns")
        self.names, self.rows = rows[0], rows[1:]


def rows_of(path):
    """The rows of a table, each a dictionary of words."""
    file = CsvFile(path)
    return [dict(zip(file.names, row)) for row in file.rows]
