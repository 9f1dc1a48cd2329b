// Layout: attributes of the file give its type and the run's position in time; every array of the state is a dataset under
// /numbers, /integers or /fields, its name the path. The file is assembled in memory and written as a whole, so that a full
// disk gives its own error and never leaves half a file. A CRC over all content detects damage that HDF5 does not.
#include "gapflow/output/checkpoint.hpp"

#include "gapflow/output/file.hpp"
#include "gapflow/output/scene_difference.hpp"

#define H5_USE_110_API // the same calls in all later releases
#include <hdf5.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <utility>

namespace gapflow {

namespace {

constexpr const char* format_name = "gapflow checkpoint";
constexpr std::int64_t format_version = 8; // incremented (in restart_test.py too) whenever older states cannot be restored

/// A problem with a file, without its name.
class Unreadable : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Owns an HDF5 identifier.
class Handle {
public:
    Handle(hid_t id, herr_t (*close)(hid_t), const char* what) : id_(id), close_(close)
    {
        if (id < 0)
            throw Unreadable(std::string("no ") + what);
    }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Handle& operator=(Handle&&) = delete;
    ~Handle()
    {
        if (id_ >= 0)
            close_(id_);
    }
    operator hid_t() const { return id_; }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

void check(herr_t status, const std::string& what)
{
    if (status < 0)
        throw Unreadable("cannot handle " + what);
}

template <class T>
hid_t type_of()
{
    if constexpr (std::is_same_v<T, double>)
        return H5T_NATIVE_DOUBLE;
    else
        return H5T_NATIVE_INT64;
}

template <class T>
void write_attribute(hid_t file, const char* name, const T& value)
{
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "space");
    const Handle attribute(H5Acreate2(file, name, type_of<T>(), space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
    check(H5Awrite(attribute, type_of<T>(), &value), name);
}

template <class T>
T read_attribute(hid_t file, const char* name)
{
    T value{};
    const Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose, name);
    check(H5Aread(attribute, type_of<T>(), &value), name);
    return value;
}

void write_dataset(hid_t parent, const std::string& name, hid_t type, std::size_t count, const void* data)
{
    const hsize_t extent = count;
    const Handle space(H5Screate_simple(1, &extent, nullptr), H5Sclose, "space");
    const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "list");
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "list");
    check(H5Pset_create_intermediate_group(links, 1), name);
    check(H5Pset_obj_track_times(creation, false), name); // the same state gives the same file
    const Handle set(H5Dcreate2(parent, name.c_str(), type, space, links, creation, H5P_DEFAULT), H5Dclose, name.c_str());
    if (count > 0)
        check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), name);
}

template <class T>
std::vector<T> read_dataset(hid_t parent, const std::string& name, hid_t type)
{
    const Handle set(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose, name.c_str());
    const Handle space(H5Dget_space(set), H5Sclose, name.c_str());
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    const hsize_t stored = H5Dget_storage_size(set);
    if (count < 0 || (count > 0 && stored != static_cast<hsize_t>(count) * sizeof(T)))
        throw Unreadable("no values of " + name);
    std::vector<T> values(static_cast<std::size_t>(count));
    if (count > 0)
        check(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
    return values;
}

void write_text(hid_t file, const char* name, const std::string& text)
{
    write_dataset(file, name, H5T_NATIVE_CHAR, text.size(), text.data());
}

std::string read_text(hid_t file, const char* name)
{
    const std::vector<char> text = read_dataset<char>(file, name, H5T_NATIVE_CHAR);
    return {text.begin(), text.end()};
}

template <class T>
void write_arrays(hid_t file, const std::string& group, const std::map<std::string, std::vector<T>>& arrays)
{
    for (const auto& [name, values] : arrays)
        write_dataset(file, group + "/" + name, type_of<T>(), values.size(), values.data());
}

template <class T>
std::map<std::string, std::vector<T>> read_arrays(hid_t file, const std::string& group)
{
    std::map<std::string, std::vector<T>> arrays;
    if (H5Lexists(file, group.c_str(), H5P_DEFAULT) <= 0)
        return arrays;
    const Handle root(H5Gopen2(file, group.c_str(), H5P_DEFAULT), H5Gclose, group.c_str());
    std::vector<std::string> names;
    const auto collect = [](hid_t, const char* name, const H5O_info_t* info, void* to) -> herr_t {
        if (info->type == H5O_TYPE_DATASET)
            static_cast<std::vector<std::string>*>(to)->push_back(name);
        return 0;
    };
    check(H5Ovisit(root, H5_INDEX_NAME, H5_ITER_INC, collect, &names), group);
    for (const std::string& name : names)
        arrays[name] = read_dataset<T>(root, name, type_of<T>());
    return arrays;
}

std::int64_t checksum(const Checkpoint& checkpoint)
{
    uLong crc = crc32_z(0, nullptr, 0);
    const auto add = [&](const void* data, std::size_t bytes) {
        if (bytes > 0)
            crc = crc32_z(crc, static_cast<const unsigned char*>(data), bytes);
    };
    const auto add_text = [&](const std::string& text) { add(text.c_str(), text.size() + 1); };
    const auto add_arrays = [&](const auto& arrays) {
        for (const auto& [name, values] : arrays) {
            add_text(name);
            add(values.data(), values.size() * sizeof values[0]);
        }
    };
    add_text(checkpoint.version);
    add_text(checkpoint.scene);
    add(&checkpoint.position.step, sizeof checkpoint.position.step);
    add(&checkpoint.position.frames, sizeof checkpoint.position.frames);
    add(&checkpoint.position.smallest_gap, sizeof checkpoint.position.smallest_gap);
    add_arrays(checkpoint.state.numbers);
    add_arrays(checkpoint.state.integers);
    add_arrays(checkpoint.state.fields);
    return static_cast<std::int64_t>(crc);
}

// The file's bytes.
std::vector<char> image_of(const Checkpoint& checkpoint)
{
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "list");
    constexpr std::size_t growth = std::size_t{4} << 20;
    check(H5Pset_fapl_core(access, growth, false), "memory");
    const Handle file(H5Fcreate("checkpoint in memory", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "file");
    write_attribute(file, "format_version", format_version);
    write_attribute(file, "step", static_cast<std::int64_t>(checkpoint.position.step));
    write_attribute(file, "frames", static_cast<std::int64_t>(checkpoint.position.frames));
    write_attribute(file, "smallest_gap", checkpoint.position.smallest_gap);
    write_attribute(file, "checksum", checksum(checkpoint));
    write_text(file, "format", format_name);
    write_text(file, "version", checkpoint.version);
    write_text(file, "scene", checkpoint.scene);
    write_arrays(file, "numbers", checkpoint.state.numbers);
    write_arrays(file, "integers", checkpoint.state.integers);
    write_arrays(file, "fields", checkpoint.state.fields);
    check(H5Fflush(file, H5F_SCOPE_LOCAL), "memory");
    const ssize_t bytes = H5Fget_file_image(file, nullptr, 0);
    if (bytes <= 0)
        throw Unreadable("no image");
    std::vector<char> image(static_cast<std::size_t>(bytes));
    if (H5Fget_file_image(file, image.data(), image.size()) != bytes)
        throw Unreadable("no image");
    return image;
}

void fill(const std::filesystem::path& path, Checkpoint& checkpoint)
{
    const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "HDF5 file");
    if (read_text(file, "format") != format_name)
        throw Unreadable("another format");
    checkpoint.version = read_text(file, "version");
    if (const auto version = read_attribute<std::int64_t>(file, "format_version"); version != format_version)
        throw InputError(path.string() + ": a checkpoint of format " + std::to_string(version) + ", written by gapflow " +
                         checkpoint.version + "; this version reads format " + std::to_string(format_version) +
                         ": resume with the version that wrote it or start the run anew");
    checkpoint.scene = read_text(file, "scene");
    checkpoint.position.step = read_attribute<std::int64_t>(file, "step");
    checkpoint.position.frames = static_cast<int>(read_attribute<std::int64_t>(file, "frames"));
    checkpoint.position.smallest_gap = read_attribute<double>(file, "smallest_gap");
    checkpoint.state.numbers = read_arrays<double>(file, "numbers");
    checkpoint.state.integers = read_arrays<std::int64_t>(file, "integers");
    checkpoint.state.fields = read_arrays<double>(file, "fields");
    if (read_attribute<std::int64_t>(file, "checksum") != checksum(checkpoint))
        throw Unreadable("its checksum is wrong");
}

void silence_hdf5()
{
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // errors are reported by exceptions
}

void broadcast(std::string& text, const Communicator& comm)
{
    long size = static_cast<long>(text.size());
    MPI_Bcast(&size, 1, MPI_LONG, 0, comm.mpi());
    text.resize(static_cast<std::size_t>(size));
    MPI_Bcast(text.data(), static_cast<int>(size), MPI_CHAR, 0, comm.mpi());
}

template <class T>
void broadcast(std::map<std::string, std::vector<T>>& arrays, const Communicator& comm)
{
    long count = static_cast<long>(arrays.size());
    MPI_Bcast(&count, 1, MPI_LONG, 0, comm.mpi());
    auto next = arrays.begin();
    for (long i = 0; i < count; ++i) {
        std::string name = comm.root() ? next->first : std::string();
        broadcast(name, comm);
        std::vector<T>& values = comm.root() ? (next++)->second : arrays[name];
        long size = static_cast<long>(values.size());
        MPI_Bcast(&size, 1, MPI_LONG, 0, comm.mpi());
        values.resize(static_cast<std::size_t>(size));
        MPI_Bcast(values.data(), static_cast<int>(size), std::is_same_v<T, double> ? MPI_DOUBLE : MPI_INT64_T, 0, comm.mpi());
    }
}

// What may differ between a run and its continuation.
const std::vector<std::string> free_keys{"title", "time", "solver", "output", "probe", "flux", "domain.leaving"};

} // namespace

bool same_scene(const std::string& one, const std::string& other)
{
    return scene_difference(one, other, free_keys).empty();
}

void throw_checkpoint_error(const std::filesystem::path& path, const std::string& problem)
{
    throw InputError(path.string() + ": cannot go on from this checkpoint: " + problem +
                     "; resume with the scene and the version that wrote it, or start the run anew");
}

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint, const Communicator& comm)
{
    on_root(comm, [&] {
        silence_hdf5();
        std::vector<char> image;
        try {
            image = image_of(checkpoint);
        } catch (const Unreadable& error) {
            throw ComputationError(path.string() + ": cannot put the checkpoint together (" + error.what() +
                                   "); there may be too little memory");
        }
        write_atomically(path, {image.data(), image.size()});
    });
}

Checkpoint read_checkpoint(const std::filesystem::path& path, const Communicator& comm)
{
    Checkpoint checkpoint;
    on_root(comm, [&] {
        silence_hdf5();
        std::error_code error;
        if (!std::filesystem::exists(path, error))
            throw InputError(path.string() + ": no such file; give the checkpoint.h5 of a run's folder");
        if (H5Fis_hdf5(path.c_str()) <= 0)
            throw InputError(path.string() + ": not a checkpoint, or damaged; give the checkpoint.h5 of a run's folder");
        try {
            fill(path, checkpoint);
        } catch (const InputError&) {
            throw;
        } catch (const std::exception& problem) { // a damaged size may also request too much memory
            throw InputError(path.string() + ": not a checkpoint, or damaged (" + problem.what() +
                             "); take another checkpoint or start the run anew");
        }
    });
    if (comm.size() > 1) {
        broadcast(checkpoint.version, comm);
        broadcast(checkpoint.scene, comm);
        MPI_Bcast(&checkpoint.position, sizeof checkpoint.position, MPI_BYTE, 0, comm.mpi());
        broadcast(checkpoint.state.numbers, comm);
        broadcast(checkpoint.state.integers, comm);
    }
    return checkpoint;
}

void require_same_scene(const std::filesystem::path& path, const Checkpoint& checkpoint, const Scene& scene)
{
    const std::string found = scene_difference(checkpoint.scene, scene_as_json(scene), free_keys);
    if (!found.empty())
        throw InputError(path.string() + ": a checkpoint of another scene: " + found +
                         "; only title, time, solver, output, probe, flux and domain.leaving may change: put the scene back or "
                         "start the run anew");
}

} // namespace gapflow
