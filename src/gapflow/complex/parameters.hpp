// All numbers of the complex that a person chose.
#pragma once

namespace gapflow {

/// Lengths in cells.
struct ComplexParameters {
    /// An open stretch of an edge of the grid shorter than this is closed: round-off of coordinates of up to 1e3 cells.
    double least_stretch = 1e-12;
    /// A part whose open faces are smaller is none (cells^(D-1)): round-off of areas.
    double least_area = 1e-13;
    /// Borders of solids that touch each other join within this distance: round-off of their sections.
    double joint_distance = 1e-9;
    /// Share of a curved segment over which its direction at an end is taken, to find on which side of it a line starts: small against a
    /// turn, large against round-off.
    double tangent_share = 1e-3;
    /// Points along an arc at which two solids' overlap is looked for.
    int overlap_samples = 12;
    /// The link at a corner of angle alpha of a solid has the conductance corner_link tau^-corner_exponent d/c, tau = 1 - alpha/pi, d
    /// and c the open and covered lengths of the bisector in the corner's cell. The form: a link is shut where the corner reaches the
    /// border that its bisector leaves by (d = 0: the cell is divided anyway) and infinite where it reaches the other one (c = 0: no
    /// part of the solid is in the cell), so that energies are continuous as a corner passes a grid line. The exponent: that of the conductance for which
    /// the grid's network around a wedge, with the exact singular field on its rim, has the corner's energy, found for angles of 0, 30, .. 150 degrees. The
    /// number: without bias for boxes of 8.4 x 4.3 and 16.3 x 8.4 cells anywhere, with what corner_faces.hpp adds (decision 4).
    double corner_link = 1.35;
    double corner_exponent = 0.75;
    /// A surface of facets that turns by more than this at a corner or edge is sharp there: pi/4. Below it division gains nothing. A regular polygon
    /// of 4 cells a radius errs by -0.4 % (scatter 1.0) undivided and 1.0 (0.7) divided where it turns by 45 degrees, by -0.9 (1.3) and 1.0 (0.8) at 60.
    double sharp_turn = 0.7853981633974483;
    /// A bisector plane whose normal lies within this angle of a face's normal does not divide the face: its line there is known to
    /// joint_distance only.
    double parallel = 1e-6;
    /// Below this covered length a link counts as infinite: it bounds conductances at 1e7 times those of the grid.
    double least_covered = 1e-7;
    /// Thicknesses of a gap between which a face's energy goes over from that of the gap to a plain face's: a plain face is that of a gap of
    /// constant thickness, and right for one of several cells.
    double gap_start = 0.6, gap_end = 1.2;
    /// Distance of a corner from another wall up to which the resistance of its link is that of a gap's mouth; at gap_end it is that of the corner
    /// alone. The law of the mouth holds where the gap is thinner than the sector into which it opens, about a cell.
    double mouth_start = 0.8;
    /// Cosine of the largest angle between a wall and the gap's normal, and between the walls: beyond, they do not face each other. A face's energy goes
    /// over to a plain one's from twice that on.
    double least_facing = 0.3;
    /// A gap's thickness changes by no more than this factor within an interval of three Gauss points: 1e-4 of the integral of 1/t.
    double widening = 1.6;
    /// The same of five points, where intervals double in length away from the thinnest place: a quadratic thickness changes by 4.3 at most within one, and the
    /// integral of 1/t has an error of 3e-7. It bounds those of other shapes, 1e-4 where the thickness is linear.
    double way_widening = 5;
    /// Intervals along one way: ten times as many as a gap of 1e-11 cells takes. Where walls touch along faces round-off alone parts them, and
    /// their distance changes by any factor from place to place.
    unsigned most_intervals = 400;
    /// Curvature, relative to 1/thickness, below which the closing of a gap flows along the gradient of the thickness (its square: in all
    /// directions alike): small against one, large against the round-off of second differences.
    double faint_curvature = 1e-3;
    /// Planes of cells that a thread cuts at a time. An economy: no value depends on it.
    int slab = 8;
};

inline constexpr ComplexParameters parameters;

} // namespace gapflow
