"""Planar faces from the curves of drawings (pipelines/manual.md, "From drawings").

  drawing_files  chooses the reader by the content of the file
  dxf_file       reads DXF, by ezdxf
  svg_file       reads SVG: shapes, transforms, names, unit of the page
  svg_path       reads the data of SVG paths
  sketch         curves with names, unit, notes and warnings of a drawing
  curves         segments, parts of ellipses, rational B-splines; affine maps
  pieces         where curves meet, by halving
  joining        common vertices, divided and repeated curves, crossings, gaps
  regions        the parts of the plane, outlines, holes
  step_edges     edges as those of a STEP file (outline.step_file)
  drawing_build  all together

Points are complex numbers, x + iy. Affine maps are z -> a z + b conj(z) + c.
"""
