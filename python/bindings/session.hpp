// A simulation for Python: of either dimension, with the files of its run if requested.
#pragma once

#include "gapflow/scene/scene.hpp"
#include "gapflow/step/simulation.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <string>

namespace gapflow {

/// All calls need the GIL; those that compute release it. While one computes, after a failure, and after end(), the others
/// throw std::runtime_error: there is no state to read then.
///
/// Arrays are copies that belong to their reader, indexed [x, y(, z)(, component)], of this rank's cells; only
/// face_velocity() and face_fraction() are views.
class Session : public std::enable_shared_from_this<Session> {
public:
    Session();
    virtual ~Session();

    /// Arrays of doubles, one an axis, of this rank's faces, as face_velocity() has them.
    using FaceArrays = std::vector<pybind11::array_t<double>>;

    /// The scene's simulation at its start or, with `resume`, where that checkpoint was written. `folder`: of the run's files; empty: none.
    /// `velocity`: of the fluid at the start; empty: the scene's. Throws InputError, ComputationError.
    static std::shared_ptr<Session> make(const Scene& scene, const std::string& folder, const std::string& resume,
                                         const FaceArrays& velocity);
    /// grid() of the scene's simulation at its start. Throws InputError. Collective.
    static pybind11::dict start_grid(const Scene& scene);

    virtual int dimension() const = 0;
    virtual double time() const = 0;
    virtual long steps() const = 0;
    /// The scene's key that ended the run; empty: it has not ended.
    virtual std::string ended_by() const = 0;
    virtual const Scene& scene() const = 0;
    virtual pybind11::dict report() const = 0; ///< of the last step, at first of the start
    /// One step that does not pass `until`, nor scene.end, nor the next output time where files are written. Lets the
    /// interpreter handle signals once it is done; if one raises, on any rank, all ranks do. Throws ComputationError;
    /// BufferError while views exist.
    virtual pybind11::dict step(double until) = 0;
    virtual void set_force(const std::string& body, const std::vector<double>& force, const std::vector<double>& torque) = 0;
    virtual void set_velocity(const std::string& body, const std::vector<double>& velocity,
                              const std::vector<double>& angular_velocity) = 0;

    /// A session without files in the same state. Throws ComputationError.
    virtual std::shared_ptr<Session> copy() const = 0;
    /// Goes on with values of another scene that the state does not hold. Throws InputError where the state is none of that scene; nothing
    /// has changed then. BufferError while views exist.
    virtual void change(const Scene& scene) = 0;
    /// Throws InputError where no run can change to a scene: other kinds of sides, viscosity or none.
    virtual void demand_changeable(const Scene& scene) const = 0;

    virtual pybind11::dict grid() const = 0;
    /// One row for each body, in the scene's order.
    virtual pybind11::dict bodies() const = 0;
    virtual pybind11::array velocity() const = 0; ///< at cell centres, mean of two faces
    /// Curl of the velocity at cell centres: one component in 2D, three in 3D.
    virtual pybind11::array vorticity() const = 0;
    virtual pybind11::array pressure() const = 0; ///< full; NaN in cells without an unknown of the grid
    virtual pybind11::array kind() const = 0;     ///< 0 solid, 1 bulk, 2 film, 3 mixed
    virtual pybind11::dict films() const = 0;
    virtual pybind11::list gaps() const = 0;
    virtual pybind11::dict budget() const = 0;
    virtual pybind11::dict stages() const = 0; ///< seconds
    /// Vertices in the world and elements of a body's surface, chords at most `tolerance` off.
    virtual pybind11::tuple surface(const std::string& body, double tolerance) const = 0;
    /// Views of the solver's own memory: they keep the session alive, and it cannot step while they exist.
    virtual pybind11::array face_velocity(int axis) = 0;
    virtual pybind11::array face_fraction(int axis) = 0;

    /// A checkpoint of this moment. Throws ComputationError.
    virtual void write_checkpoint(const std::string& file) = 0;
    /// Ends the files of the run, before time.end with a checkpoint to continue from, and frees the simulation; if views exist, its memory is never freed.
    virtual void end() = 0;
    /// The same where errors cannot be caught.
    void end_or_print();
    int views() const { return views_; }

protected:
    friend struct SessionView;
    int views_ = 0;
};

/// Name and NumPy type of each column of Session::gaps(): "U" (text), "f8", "i8".
std::vector<std::pair<std::string, std::string>> gap_column_types();

/// Keeps a session from stepping and from being freed.
struct SessionView {
    explicit SessionView(std::shared_ptr<Session> session_) : session(std::move(session_)) { ++session->views_; }
    ~SessionView() { --session->views_; }
    SessionView(const SessionView&) = delete;
    SessionView& operator=(const SessionView&) = delete;
    std::shared_ptr<Session> session;
};

} // namespace gapflow
