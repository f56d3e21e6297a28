"""How far the curves of an outline are from the points and the polygon that they were made from, in sentences."""
from outline import near_spline


class Fit:
    """The greatest distances that were added; in the units of the points that they were made from, times `factor`."""

    def __init__(self, factor=1.0):
        self.factor = factor
        self.moved = (0.0, 0j)  # distance, point
        self.apart = (0.0, 0j, 1.0)  # distance, middle of the segment, its spacing

    def add_moves(self, points, moved):
        """Of points onto a curve."""
        for z, other in zip(points, moved):
            if abs(other - z) > self.moved[0]:
                self.moved = abs(other - z), z

    def add_curve(self, points, is_periodic, ends=(None, None)):
        """Of the spline through the points from their polygon."""
        spacings = near_spline.spacings(points, is_periodic)
        for poles, spacing in zip(near_spline.spline_parts(points, is_periodic, ends), spacings):
            distance = near_spline.distance_beyond(poles, self.apart[0])
            if distance > self.apart[0]:
                self.apart = distance, (poles[0] + poles[3]) / 2, spacing

    def sentences(self):
        return [sentence for sentence in (self.of_moves(), self.of_curves()) if sentence]

    def of_moves(self):
        if self.moved[0] == 0:
            return None
        return f"points were moved by up to {self.moved[0] / self.factor:.3g}, at {self.place(self.moved[1])}"

    def of_curves(self):
        distance, place, spacing = self.apart
        if distance == 0:
            return None
        share = 100 * distance / spacing
        return (f"the curves are up to {distance / self.factor:.3g} away from the polygon ({share:.2g} % of the spacing "
                f"there), near {self.place(place)}")

    def place(self, z):
        return f"({z.real / self.factor:.9g}, {z.imag / self.factor:.9g})"
