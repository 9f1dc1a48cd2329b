// A scene as plain data: the user's values with defaults filled in, checked by the reader.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gapflow {

/// A vector of the scene; in 2D the third number is 0 and unused.
using Triple = std::array<double, 3>;

/// One sampled function of time, held constant beyond its ends.
struct TimeTable {
    enum class Interpolation { linear, cubic };
    std::string file;
    std::vector<double> time;
    std::vector<std::vector<double>> rows;               ///< values after the time column
    Interpolation interpolation = Interpolation::linear; ///< between rows; cubic: monotone (motion tables)
};

struct SideScene {
    enum class Kind { wall, open, periodic, inflow, far, pressure, surface };
    Kind kind = Kind::wall; ///< surface: a water level at rest with air above
    Triple velocity{};      ///< of a sliding wall (in its plane), or of a constant inflow
    TimeTable
        table; ///< inflow from a file (time,u,v[,w]), empty if constant; pressure (time,pressure), a row without a file if constant

    /// Whether fluid passes as the pressure wants, which is known there or beyond.
    bool is_open() const { return kind == Kind::open || kind == Kind::far || kind == Kind::pressure || kind == Kind::surface; }
};

struct GapScene {
    enum class Contact { wet, dry };
    enum class Exit { automatic, reversible, jet };
    bool film = true;                ///< gap.model = "film" (else "none")
    std::optional<double> threshold; ///< h_c in cells; empty: automatic
    Contact contact = Contact::wet;
    double roughness = 0.0;           ///< length; of "auto" what it stands for
    bool automatic_roughness = false; ///< gap.roughness = "auto"
    double entrance_loss = 0.0;
    Exit exit = Exit::automatic;
};

struct ContactScene {
    double restitution = 0.0;
    double friction = 0.0;
    double thickness = 0.0;
};

/// Overrides of [gap] and [contact] for one pair of bodies (or body and wall).
struct PairScene {
    std::array<std::string, 2> bodies;
    GapScene gap;
    ContactScene contact;
};

/// Pulls a body's position towards a point.
struct SpringScene {
    Triple anchor{};
    double stiffness = 0.0;
    double damping = 0.0;
};

/// The body only turns about a point; 3D: about an axis of unit length through it.
struct HingeScene {
    Triple point{};
    Triple axis{1, 0, 0}; ///< 2D: as an angular velocity, the first number
};

struct BodyScene {
    enum class ShapeKind { box, ball, capsule, cylinder, half_space, mesh, sheet };
    enum class Motion { free, fixed, prescribed };

    std::string name;
    ShapeKind shape = ShapeKind::ball;
    Triple size{};              ///< box
    double radius = 0.0;        ///< ball, capsule, cylinder
    double length = 0.0;        ///< capsule (between the centres of its caps), cylinder
    Triple normal{};            ///< half-space: out of the solid
    std::string mesh_file;      ///< mesh, sheet: resolved against the scene's folder; a sheet of points has none
    double mesh_scale = 1.0;    ///< also of the points
    std::vector<Triple> points; ///< sheet in 2D: its polyline
    double thickness = 0.0;     ///< sheet
    bool inside_out = false;

    Triple position{};                            ///< of the shape's own origin
    double angle = 0.0;                           ///< 2D, radians
    std::array<double, 4> quaternion{1, 0, 0, 0}; ///< 3D, w x y z, normalised

    std::optional<double> density;
    std::optional<double> mass;
    std::vector<double> inertia; ///< with mass: 1 (2D), 3 (principal, body axes) or 9 (matrix, row by row) numbers
    Motion motion = Motion::free;
    TimeTable motion_table; ///< prescribed from a file: time,x,y,angle or time,x,y,z,qw,qx,qy,qz
    Triple velocity{};
    Triple angular_velocity{}; ///< 2D: the first number
    Triple force{};
    Triple torque{}; ///< 2D: the first number
    std::array<bool, 6> free{true, true, true,
                             true, true, true}; ///< x y z rx ry rz: free components of a free body's motion; 2D uses x y rz
    std::optional<SpringScene> spring;
    std::optional<HingeScene> hinge; ///< only with all of `free`
};

/// What a [[crowd]] became: bodies in a row of the scene's.
struct CrowdScene {
    enum class Arrangement { random, lattice };

    std::string name; ///< its bodies are called name_0001, name_0002 ...
    int first = 0;    ///< number of its first body among the scene's
    int number = 0;
    Arrangement arrangement = Arrangement::random;
    std::uint64_t seed = 1;
    double spacing = 0;               ///< smallest distance of its bodies from each other, other bodies and walls
    double region_volume = 0;         ///< 2D: area
    double volume_fraction = 0;       ///< of its bodies in the region
    double smallest = 1, largest = 1; ///< factors on the shape's lengths
};

/// A [[probe]]: points at which the flow is measured.
struct ProbeScene {
    enum class Kind { points, line, plane };

    std::string name;
    Kind kind = Kind::points;
    std::vector<Triple> points;  ///< as given; of a line its ends, of a plane its origin and the edges u and v
    std::array<int, 2> counts{}; ///< of a line, and of a plane along u and v
    bool pressure = true, velocity = true, vorticity = false;
    double every = 0.0; ///< 0: every step

    /// All points in their order: of a plane first those along u.
    std::vector<Triple> places() const;
};

/// A [[flux]]: what the volume flux is measured through.
struct FluxScene {
    enum class Kind { side, plane, gap };

    std::string name;
    Kind kind = Kind::side;
    int side = 0;                      ///< 2 * axis + end
    Triple point{}, normal{};          ///< of a plane; the latter of unit length
    std::optional<Triple> low, high;   ///< the part of the plane in a box; both or none
    std::array<std::string, 2> bodies; ///< of a gap
    std::optional<Triple> along;       ///< of a gap, of unit length: direction in which its flux counts positive
    double every = 0.0;                ///< 0: every step
};

/// Where the cells of a graded grid are squares (cubes), and how they grow outside.
struct CoreScene {
    double spacing = 0;
    Triple low{}, high{};
    double growth = 0;                               ///< most; of a cell over its neighbour nearer to the core
    std::optional<double> largest;                   ///< length
    std::array<std::vector<double>, 3> below, above; ///< widths of the cells outside over `spacing`, outwards
};

/// A grid that moves with the centre of mass of a body.
struct FollowScene {
    std::string body;
    std::array<bool, 3> axes{}; ///< along which it moves
};

struct Scene {
    enum class BodiesTable { automatic, csv, binary, both };
    enum class Fractions { cut_cell, voxel };
    enum class Advection { maccormack, semi_lagrangian };
    enum class Thin { refuse, allow };
    enum class Initial { rest, potential };
    enum class Backend { multigrid, petsc };
    enum class Leaving { warn, stop, remove };
    enum class Precision { double_, single };
    enum class Format { in_line, appended };

    std::string file; ///< as given, for messages
    std::string title;
    int dimension = 2;
    Triple gravity{};

    Triple size{};
    std::array<int, 3> cells{1, 1, 1}; ///< along each axis, those outside a core too
    Triple origin{};
    std::optional<CoreScene> core;     ///< of a graded grid
    std::optional<FollowScene> follow; ///< the grid moves with a body
    std::array<SideScene, 6> sides;    ///< x_low x_high y_low y_high z_low z_high

    Leaving leaving = Leaving::warn; ///< bodies on their way out of an open side

    double density = 1.0;
    double viscosity = 0.0;
    double reference_pressure = 0.0;
    std::optional<double> vapour_pressure; ///< absolute; empty: wet films withstand any tension
    Triple fluid_velocity{};
    std::optional<Triple> pressure_gradient; ///< mean, of the reduced pressure along periodic axes
    std::optional<Triple> mean_velocity;     ///< of fluid and solids along periodic axes; not with a gradient
    Initial initial = Initial::rest;

    Fractions fractions = Fractions::cut_cell;
    Advection advection = Advection::maccormack;
    Thin thin = Thin::refuse; ///< bodies thinner than a cell
    bool parts = false; ///< gap.model = "parts": every connected part of a cell's fluid is an unknown; bodies of any thickness

    GapScene gap;
    ContactScene contact;
    std::vector<PairScene> pairs;
    std::vector<BodyScene> bodies;  ///< the crowds' behind all others
    std::vector<CrowdScene> crowds; ///< in the order of their bodies

    double end = 0.0;
    double max_step = 0.0;
    double cfl = 1.0;
    double gap_cfl = 0.25;
    bool long_ways = true;              ///< gap_cfl does not hold where films hardly change the motion
    std::optional<double> until_steady; ///< the run ends once the flow's unsteadiness is below it

    double tolerance = 1e-8;
    Backend backend = Backend::multigrid;

    std::string output_directory = "out";
    double output_every = 0.0; ///< 0: only the start and the end
    std::vector<std::string> fields{"velocity", "pressure"};
    double checkpoint_every = 0.0; ///< 0: only at the end and when interrupted
    BodiesTable bodies_table = BodiesTable::automatic;

    Precision precision = Precision::double_; ///< of files of fields, bodies and films
    Format format = Format::in_line;          ///< of the same
    bool forces = false;                      ///< a table of the forces' parts
    std::vector<ProbeScene> probes;
    std::vector<FluxScene> fluxes;

    std::vector<std::string> warnings; ///< about settings that were accepted but not used, for the caller to print

    /// Edge of a cell; of a graded grid in its core.
    double spacing() const { return core ? core->spacing : size[0] / cells[0]; }
    /// Axes along which the fluid goes on or can leave: neither periodic nor between two walls.
    std::vector<int> endless_axes() const;
    /// The crowd that a body is of, by its number; null: none.
    const CrowdScene* crowd_of(int body) const;
    /// Whether bodies.csv, or the binary bodies.npy, is written.
    bool writes_csv() const;
    bool writes_binary() const;

    /// Settings that hold for a pair, by the names of its bodies in any order.
    const GapScene& gap_of(const std::string& a, const std::string& b) const;
    const ContactScene& contact_of(const std::string& a, const std::string& b) const;
    /// Distance that the pair's surfaces keep in contact: contact.thickness or gap.roughness, the larger.
    double held_distance(const std::string& a, const std::string& b) const;
    /// Distance below which they are pushed apart: the same, but without a roughness that is automatic. Bodies that the scene puts in touch
    /// stay where they are.
    double least_distance(const std::string& a, const std::string& b) const;
};

/// Names of the domain's sides: x_low ... z_high; the wall there is the body "wall:x_low".
extern const std::array<std::string, 6> side_names;

/// Values of a table at a time: linear between rows, constant beyond its ends.
std::vector<double> value_at(const TimeTable& table, double time);

/// Slopes of a table at a time: of the segment that starts at or holds it; 0 beyond its ends.
std::vector<double> derivative_at(const TimeTable& table, double time);

/// gap.roughness = "auto" in runs, in cells: a film of this thickness behaves as one of zero thickness, within the accuracy of the
/// grid, and steps and solves stay well within the resolution of double precision (method, "Mesh").
inline constexpr double automatic_roughness = 0.005;

/// output.bodies = "auto" writes bodies.npy in scenes with crowds and more bodies than this.
inline constexpr std::size_t most_bodies_of_csv = 50;

/// Additional checks of the reader.
enum class Purpose { run, added_mass, check };

/// Bytes that a run without viscosity needs on one rank, for `check` and for rejecting runs that are far too large: a fixed part, a part
/// per cell and a part for surfaces, fitted to the peaks of measured runs (docs/performance.md).
double expected_memory(int dimension, double cells);

/// Reads and validates a scene. `overrides` are dotted keys and TOML values as given to --set.
/// Throws InputError that names file, line, key, value, range and remedy.
Scene read_scene(const std::string& file, const std::vector<std::pair<std::string, std::string>>& overrides, Purpose purpose);

/// Text with the names of a crowd's bodies for the user: "ball_0001 ... ball_0400".
std::string names_text(const Scene& scene, const CrowdScene& crowd);

/// Text about the default roughness of gaps for the user: its length, in cells, and whether it is the automatic one.
std::string roughness_text(const Scene& scene);

/// The resolved scene as JSON text under the scene file's key names (goes into run.json).
std::string scene_as_json(const Scene& scene);

} // namespace gapflow
