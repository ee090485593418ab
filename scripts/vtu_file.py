"""Reads the pictures of a run: .vtu files whose arrays are appended as raw bytes. Standard library only."""
import array
import struct
import sys
import xml.etree.ElementTree as xml

OPENING = b'<AppendedData encoding="raw">\n_'
TYPES = {"Float32": "f", "Int32": "i", "UInt8": "B"}


class VtuFile:
    """root is the XML of a file; arrays() are its elements DataArray, numbers(element) what stands in one.

    @raise ValueError if the file is no such picture, or an array goes beyond its end
    """

    def __init__(self, path):
        with open(path, "rb") as file:
            content = file.read()
        head, opening, self._bytes = content.partition(OPENING)
        if not opening:
            raise ValueError(f"'{path}' has no appended arrays")
        self.path, self.start = path, len(head) + len(opening)  # of the bytes, which are no XML
        try:
            self.root = xml.fromstring(head + b"</VTKFile>")
        except xml.ParseError as error:
            raise ValueError(f"'{path}' is not XML: {error}") from error

    def arrays(self):
        return self.root.iter("DataArray")

    def field(self, name):
        """The array that is called "name [unit]"."""
        return next(data for data in self.arrays() if data.get("Name", "").startswith(name + " ["))

    def points(self):
        """r, z, 0 of all points, one after the other."""
        return self.numbers(self.root.find("UnstructuredGrid/Piece/Points/DataArray"))

    def place(self, data):
        """Where in the file the values of an array begin."""
        return self.start + int(data.get("offset")) + 8

    def numbers(self, data):
        begin = int(data.get("offset"))
        values = array.array(TYPES[data.get("type")])
        try:
            size, = struct.unpack_from("=Q", self._bytes, begin)
            values.frombytes(self._bytes[begin + 8:begin + 8 + size])
        except (struct.error, ValueError) as error:
            raise ValueError(f"'{self.path}' ends within an array: {error}") from error
        if len(values) * values.itemsize != size:
            raise ValueError(f"'{self.path}' ends within an array")
        if self.root.get("byte_order", "LittleEndian") != {"little": "LittleEndian", "big": "BigEndian"}[sys.byteorder]:
            raise ValueError(f"'{self.path}' was written by a machine with another order of bytes")
        return values
