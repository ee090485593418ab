#!/usr/bin/python3
"""Render a picture of the blank and the tools from blank_*.vtu and tools_*.vtu, without a screen.

    xvfb-run -a scripts/render.py output/cup                     output/cup/render.png, the last frame
    xvfb-run -a scripts/render.py output/cup --revolve           the cup as a body, cut open by a quarter
    xvfb-run -a scripts/render.py output/cup --frame 5 --field stress_von_mises --file a.png

Needs VTK's Python modules (Debian: python3-vtk9) and, to render without a screen, xvfb-run.
"""
import argparse
import glob
import math
import os
import re
import sys

import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import (
    vtkAppendPolyData,
    vtkCellDataToPointData,
    vtkClipPolyData,
    vtkFeatureEdges,
    vtkPolyDataNormals,
    vtkStripper,
    vtkTubeFilter,
)
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersModeling import vtkRotationalExtrusionFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkWindowToImageFilter,
)

# Plasma of matplotlib (CC0), at nine equally spaced values.
PLASMA = ["0d0887", "4c02a1", "7e03a8", "a92395", "cc4778", "e56b5d", "f89540", "fdc527", "f0f921"]
TOOL_COLOUR = (0.16, 0.17, 0.19)
SWEEP = 270.0


class NoPicture(Exception):
    """What is asked for cannot be rendered. The message is a sentence for the user."""


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", metavar="FOLDER", help="of the results of a run")
    parser.add_argument("--frame", type=int, help="number of the picture, 0 is the undeformed blank; default: the last")
    parser.add_argument("--field", default="equivalent_plastic_strain",
                        help="of a tensor with its component: 'plastic_strain rz'; default: %(default)s")
    parser.add_argument("--range", nargs=2, type=float, metavar=("LOW", "HIGH"), help="of the colours; default: all values")
    parser.add_argument("--revolve", action="store_true", help="turn the section about the axis, by 270 degrees")
    parser.add_argument("--mesh", action="store_true", help="with the edges of the cells (degree 2: of their quarters)")
    parser.add_argument("--window", nargs=4, type=float, metavar=("LEFT", "RIGHT", "BOTTOM", "TOP"),
                        help="show this part of the section only")
    parser.add_argument("--no-tools", action="store_true", help="only the blank")
    parser.add_argument("--size", nargs=2, type=int, default=(1600, 1000), metavar=("WIDTH", "HEIGHT"))
    parser.add_argument("--file", help="of the picture (.png); default: render.png in the folder")
    return parser.parse_args()


def frame_files(folder, frame):
    """File of the blank, and those of the tools."""
    numbers = sorted(
        int(match.group(1))
        for match in (re.fullmatch(r"blank_(\d+)\.vtu", os.path.basename(path)) for path in glob.glob(folder + "/*.vtu"))
        if match
    )
    if not numbers:
        raise NoPicture(f"there is no blank_*.vtu in '{folder}'")
    number = numbers[-1] if frame is None else frame
    if number not in numbers:
        raise NoPicture(f"there is no picture {number} in '{folder}': they go from {numbers[0]} to {numbers[-1]}")
    stem = os.path.join(glob.escape(folder), f"tools_{number:04d}")
    tools = sorted(glob.glob(stem + ".vtu") + glob.glob(stem + "_*.vtu"))  # earlier versions wrote one file
    return os.path.join(folder, f"blank_{number:04d}.vtu"), tools


def read(path):
    """The drawing as polygons or lines; values of cells are brought to their points (the mean of those around)."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    to_points = vtkCellDataToPointData()
    to_points.SetInputConnection(reader.GetOutputPort())
    surface = vtkGeometryFilter()
    surface.SetInputConnection(to_points.GetOutputPort())
    surface.Update()
    if surface.GetOutput().GetNumberOfCells() == 0:
        raise NoPicture(f"'{path}' is empty or unreadable")
    return surface.GetOutput()


def read_all(paths):
    """Several drawings as one."""
    append = vtkAppendPolyData()
    for path in paths:
        append.AddInputData(read(path))
    append.Update()
    return append.GetOutput()


def field_of(data, name):
    """The array called "name [unit]" and a component: 0, of "plastic_strain rz" the one that is called rz."""
    points = data.GetPointData()
    names = []
    for i in range(points.GetNumberOfArrays()):
        label, array = points.GetArrayName(i), points.GetArray(i)
        own, unit = label.rstrip("]").split(" [") if " [" in label else (label, "-")
        if array.GetNumberOfComponents() != 6:
            names.append(own)
            if name in (label, own):
                return label, 0
            continue
        for k in range(4):
            names.append(f"{own} {array.GetComponentName(k)}")
            if name == names[-1]:
                return label, k
    raise NoPicture(f"there is no field '{name}'; there are: {', '.join(names)}")


def transformed(data, transform):
    result = vtkTransformPolyDataFilter()
    result.SetInputData(data)
    result.SetTransform(transform)
    result.Update()
    return result.GetOutput()


def upright(data, angle=0.0):
    """From the (r, z) plane to space with z upwards, turned about z by an angle in degrees."""
    transform = vtkTransform()
    transform.RotateZ(angle)
    transform.RotateX(90)
    return transformed(data, transform)


def swept(profile):
    """The surface that lines in the (x, z) plane sweep, and its normals."""
    sweep = vtkRotationalExtrusionFilter()
    sweep.SetInputData(profile)
    sweep.SetResolution(180)
    sweep.SetAngle(SWEEP)
    sweep.CappingOff()
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(sweep.GetOutputPort())
    normals.SetFeatureAngle(35)
    normals.Update()
    return normals.GetOutput()


def outline(data):
    """The boundary of the section, without what lies on the axis."""
    edges = vtkFeatureEdges()
    edges.SetInputData(data)
    edges.BoundaryEdgesOn()
    edges.FeatureEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ManifoldEdgesOff()
    edges.ColoringOff()
    return clipped(edges.GetOutputPort(), (1, 0, 0), (1e-4 * data.GetLength(), 0, 0))


def clipped(port, normal, origin):
    plane = vtkPlane()
    plane.SetNormal(*normal)
    plane.SetOrigin(*origin)
    clip = vtkClipPolyData()
    clip.SetInputConnection(port)
    clip.SetClipFunction(plane)
    clip.Update()
    return clip.GetOutput()


def cut_to_frame(data, bounds):
    """The part of the tools within (left, right, bottom, top)."""
    left, right, bottom, top = bounds
    for normal, origin in (
        ((1, 0, 0), (left, 0, 0)),
        ((-1, 0, 0), (right, 0, 0)),
        ((0, 1, 0), (0, bottom, 0)),
        ((0, -1, 0), (0, top, 0)),
    ):
        append = vtkAppendPolyData()
        append.AddInputData(data)
        data = clipped(append.GetOutputPort(), normal, origin)
    return data


def tubes(data, radius):
    """Lines as round bars, so that thickness and light are the same everywhere."""
    strips = vtkStripper()
    strips.SetInputData(data)
    strips.JoinContiguousSegmentsOn()
    tube = vtkTubeFilter()
    tube.SetInputConnection(strips.GetOutputPort())
    tube.SetRadius(radius)
    tube.SetNumberOfSides(16)
    tube.CappingOn()
    tube.Update()
    return tube.GetOutput()


def colours_between(low, high):
    result = vtkColorTransferFunction()
    for i, code in enumerate(PLASMA):
        rgb = [int(code[k:k + 2], 16) / 255 for k in (0, 2, 4)]
        result.AddRGBPoint(low + (high - low) * i / (len(PLASMA) - 1), *rgb)
    return result


def round_range(low, high):
    """A range of round numbers that holds the given one, and how many labels divide it roundly."""
    if 0 < low < 0.5 * high:
        low = 0.0
    if not high > low:
        high = low + (abs(low) or 1.0)
    power = 10.0 ** math.floor(math.log10((high - low) / 4))
    step = power * next(nice for nice in (1, 2, 2.5, 4, 5, 10) if nice * power >= 0.999999 * (high - low) / 4)
    first, last = math.floor(low / step + 1e-6), math.ceil(high / step - 1e-6)
    return first * step, last * step, last - first + 1


def colour_by(data, label, component):
    """The component of a tensor as a field of its own, called like it; of a field without components the field itself."""
    array = data.GetPointData().GetArray(label)
    if array.GetNumberOfComponents() != 6:
        return label
    own, unit = label.rstrip("]").split(" [")
    result = vtkFloatArray()
    result.SetName(f"{own} {array.GetComponentName(component)} [{unit}]")
    result.SetNumberOfTuples(array.GetNumberOfTuples())
    result.CopyComponent(0, array, component)
    data.GetPointData().AddArray(result)
    return result.GetName()


def coloured(data, label, colours):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOn()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(label)
    mapper.SetLookupTable(colours)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def plain(data, colour, opacity=1.0):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def text_style(style, size, bold=False):
    style.SetFontFamilyToArial()
    style.SetFontSize(size)
    style.SetColor(0.15, 0.15, 0.17)
    style.SetBold(bold)
    style.SetItalic(False)
    style.SetShadow(False)


def scalar_bar(label, colours, n_labels, size):
    bar = vtkScalarBarActor()
    bar.SetLookupTable(colours)
    bar.SetNumberOfLabels(n_labels)
    bar.SetMaximumNumberOfColors(256)
    bar.SetTextPad(6)
    bar.SetLabelFormat("%.3g")
    bar.SetOrientationToVertical()
    bar.SetPosition(0.895, 0.18)
    bar.SetWidth(0.07)
    bar.SetHeight(0.64)
    bar.SetBarRatio(0.32)
    bar.UnconstrainedFontSizeOn()
    text_style(bar.GetLabelTextProperty(), size[1] // 42)
    title = vtkTextActor()
    title.SetInput(label.replace("_", " ").replace(" [-]", ""))
    text_style(title.GetTextProperty(), size[1] // 40, bold=True)
    title.GetTextProperty().SetJustificationToRight()
    title.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    title.SetPosition(0.97, 0.86)
    return bar, title


def add_section(renderer, blank, tools, label, colours, size, window=None, mesh=False):
    """The section as it is, seen along the normal of its plane."""
    left, right, bottom, top = window or blank.GetBounds()[:4]
    if window:
        blank = cut_to_frame(blank, window)
    axisymmetric_edge = abs(left) < 1e-6 * (right - left)
    width, height = right - left, top - bottom
    margin = 0.14 * max(width, height)
    frame = (left - (0.02 if axisymmetric_edge else 1) * margin, right + margin, bottom - margin, top + margin)
    actor = coloured(blank, label, colours)
    actor.GetProperty().LightingOff()
    if mesh:
        actor.GetProperty().EdgeVisibilityOn()
        actor.GetProperty().SetEdgeColor(0.25, 0.25, 0.25)
    renderer.AddActor(actor)
    if tools is not None:
        lines = plain(tubes(cut_to_frame(tools, frame), 0.0022 * max(width, height)), TOOL_COLOUR)
        lines.GetProperty().LightingOff()
        lines.SetPosition(0, 0, -0.1 * max(width, height))
        renderer.AddActor(lines)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    aspect = 0.84 * size[0] / size[1]  # the scalar bar needs the rest
    half = 0.5 * max(frame[3] - frame[2], (frame[1] - frame[0]) / aspect) * 1.06
    x = 0.5 * (frame[0] + frame[1]) + 0.08 * half * size[0] / size[1]
    y = 0.5 * (frame[2] + frame[3])
    camera.SetFocalPoint(x, y, 0)
    camera.SetPosition(x, y, 10 * max(width, height))
    camera.SetParallelScale(half)
    renderer.ResetCameraClippingRange()


def add_body(renderer, blank, tools, label, colours, size):
    """The body that the section sweeps about the axis, open towards the viewer."""
    length = blank.GetLength()
    start = 0.5 * (360 - SWEEP) - 90 + 18  # the opening lies around -y, where the camera is, a little to the right
    turn = vtkTransform()
    turn.RotateZ(start)
    surface = coloured(transformed(swept(upright(outline(blank))), turn), label, colours)
    surface.GetProperty().SetSpecular(0.25)
    surface.GetProperty().SetSpecularPower(28)
    surface.GetProperty().SetAmbient(0.28)
    surface.GetProperty().SetDiffuse(0.78)
    renderer.AddActor(surface)
    for angle in (start, start + SWEEP):
        cut = coloured(upright(blank, angle), label, colours)
        cut.GetProperty().LightingOff()
        renderer.AddActor(cut)
        if tools is not None:
            bars = plain(tubes(upright(tools_near(tools, blank), angle), 0.002 * length), TOOL_COLOUR)
            bars.GetProperty().SetSpecular(0.3)
            renderer.AddActor(bars)

    # A key light from the left, a weaker one from the right, and one from below for the undersides.
    for position, intensity in (((-0.8, 1.0, 1.0), 0.62), ((1.0, 0.5, 0.9), 0.34), ((0.0, -1.0, 0.8), 0.3)):
        light = vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(*position)
        light.SetIntensity(intensity)
        renderer.AddLight(light)

    camera = renderer.GetActiveCamera()
    right, bottom, top = (blank.GetBounds()[i] for i in (1, 2, 3))
    elevation, angle = math.radians(34), 22.0
    radius = 1.1 * right
    seen = max(0.5 * (top - bottom) * math.cos(elevation) + radius * math.sin(elevation), radius * size[1] / (0.8 * size[0]))
    distance = 1.15 * seen / math.tan(math.radians(0.5 * angle)) + 0.6 * radius
    middle = 0.5 * (bottom + top)
    aside = 0.16 * radius  # the scalar bar needs the right of the picture
    camera.SetFocalPoint(aside, 0, middle)
    camera.SetPosition(aside, -distance * math.cos(elevation), middle + distance * math.sin(elevation))
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(angle)
    renderer.ResetCameraClippingRange()


def tools_near(tools, blank):
    """The part of the tools that does not dwarf the body."""
    _, right, bottom, top = blank.GetBounds()[:4]
    margin = 0.12 * max(right, top - bottom)
    return cut_to_frame(tools, (-1.0, right + margin, bottom - margin, top + margin))


def render(options):
    blank_file, tool_files = frame_files(options.folder, options.frame)
    blank = read(blank_file)
    tools = None if options.no_tools or not tool_files else read_all(tool_files)
    label = colour_by(blank, *field_of(blank, options.field))
    low, high, n_labels = round_range(*(options.range or blank.GetPointData().GetArray(label).GetRange()))
    colours = colours_between(low, high)
    if options.revolve and blank.GetBounds()[0] < -1e-4 * blank.GetLength():
        raise NoPicture("the blank lies on both sides of r = 0: it cannot be revolved")

    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    if options.revolve:
        add_body(renderer, blank, tools, label, colours, options.size)
    else:
        add_section(renderer, blank, tools, label, colours, options.size, options.window, options.mesh)
    for actor in scalar_bar(label, colours, n_labels, options.size):
        renderer.AddActor2D(actor)

    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*options.size)
    window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    path = options.file or os.path.join(options.folder, "render.png")
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    if not os.path.exists(path):
        raise NoPicture(f"cannot write '{path}'")
    print(path)


if __name__ == "__main__":
    try:
        render(arguments())
    except NoPicture as error:
        sys.exit(f"render.py: {error}")
