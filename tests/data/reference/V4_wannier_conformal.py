"""Writes V4_wannier_conformal.csv: Stokes flow between eccentric cylinders whose radii hardly differ (Jeffery 1922, Wannier 1950). Needs mpmath.

The inner cylinder, radius 1, turns with the surface speed 1; the outer one, radius 1 + clearance, stands still; the viscosity is 1. The stream function
in bipolar coordinates, psi = (cosh a - cos b)^-1 (P(a) + Q(a) cos b) with P = A ch + B a ch + C sh + D a sh and Q = A' ch 2a + B' + C' sh 2a + D' a, is
fixed by no slip on both walls, equal values of psi (up to a constant) and a pressure that is single-valued. It agrees with V4_wannier_summary.csv to 15
digits and with Sommerfeld's bearing in the limit."""
import sys

import mpmath as mp


def load_and_torque(clearance, eccentricity):
    a, b, e = mp.mpf(1), 1 + mp.mpf(clearance), mp.mpf(eccentricity) * mp.mpf(clearance)
    if e == 0:
        return mp.mpf(0), 4 * mp.pi * b**2 / (b**2 - 1)
    c = mp.sqrt((b**2 - a**2 - e**2)**2 - 4 * a**2 * e**2) / (2 * e)
    inner, outer = mp.asinh(c / a), mp.asinh(c / b)
    matrix, right = mp.matrix(9, 9), mp.matrix(9, 1)
    for wall, t in enumerate((inner, outer)):
        ch, sh, ch2, sh2 = mp.cosh(t), mp.sinh(t), mp.cosh(2 * t), mp.sinh(2 * t)
        rows = ((ch, t * ch, sh, t * sh, 0, 0, 0, 0, -ch), (0, 0, 0, 0, ch2, 1, sh2, t, 1),
                (sh, ch + t * sh, ch, sh + t * ch, 0, 0, 0, 0, -sh), (0, 0, 0, 0, 2 * sh2, 0, 2 * ch2, 1, 0))
        for i, row in enumerate(rows):
            for j, value in enumerate(row):
                matrix[4 * wall + i, j] = value if j < 8 or wall == 0 else 0
    right[2] = 1
    matrix[8, 1] = matrix[8, 7] = 1
    x = mp.lu_solve(matrix, right)
    return abs(4 * mp.pi * x[3]), abs(4 * mp.pi * c * (x[1] + x[3] * mp.coth(inner)))


mp.mp.dps = 60
with open(sys.argv[1] if len(sys.argv) > 1 else "V4_wannier_conformal.csv", "w") as file:
    file.write("clearance,eccentricity_ratio,force_on_inner,torque_on_inner\n")
    for clearance in ("0.3", "0.1", "0.03", "0.01", "0.003"):
        for eccentricity in ("0", "0.3", "0.6", "0.9", "0.99", "0.999"):
            file.write(f"{clearance},{eccentricity}," + ",".join(mp.nstr(v, 15) for v in load_and_torque(clearance, eccentricity)) + "\n")
