"""Definitions of GenCase written for the tests of `thalweg import`."""

HEAD = """<?xml version="1.0" encoding="UTF-8" ?>
<case>
  <casedef>
    <constantsdef>
      <gravity x="0" y="0" z="-9.81" />
      <rhop0 value="1000" />
    </constantsdef>
    <geometry>
      <definition dp="{dp}">
        <pointmin x="-1" y="{y0}" z="-1" />
        <pointmax x="3" y="{y1}" z="2" />
      </definition>
      <commands>
        {lists}
        <mainlist>
          <setshapemode>actual | bound</setshapemode>
          <setdrawmode mode="full" />
"""

TAIL = """        </mainlist>
      </commands>
    </geometry>
    {casedef}
  </casedef>
  <execution>
    <special>{special}</special>
    <parameters>
      <parameter key="TimeMax" value="0.1" />
      <parameter key="TimeOut" value="0.05" />
      {parameters}
    </parameters>
  </execution>
</case>
"""


def definition(commands, dp=0.02, flat=True, lists="", casedef="", special="", parameters=""):
    """The text of a definition whose mainlist holds these commands; flat: in the plane y = 0."""
    y0, y1 = (0, 0) if flat else (-1, 2)
    return HEAD.format(dp=dp, y0=y0, y1=y1, lists=lists) + commands + TAIL.format(casedef=casedef, special=special, parameters=parameters)


def box(fill, low, size):
    return (f'<drawbox><boxfill>{fill}</boxfill><point x="{low[0]}" y="{low[1]}" z="{low[2]}" />'
            f'<size x="{size[0]}" y="{size[1]}" z="{size[2]}" /></drawbox>\n')


def fluid(mk=0):
    return f'<setmkfluid mk="{mk}" />\n'


def bound(mk=0):
    return f'<setmkbound mk="{mk}" />\n'


TANK = bound() + box("bottom | left | right | front | back", (0, -1, 0), (1, 2, 0.6))
WATER = fluid() + box("solid", (0, -1, 0), (0.4, 2, 0.3))
DAM = WATER + TANK

SPACE = (fluid() + box("solid", (0, 0, 0), (0.4, 0.4, 0.3)) + bound() + box("all ^ top", (0, 0, 0), (1, 0.4, 0.6)))


def column(text, tag):
    """The lines on which a tag begins."""
    return [number for number, line in enumerate(text.splitlines(), 1) if f"<{tag}" in line]
