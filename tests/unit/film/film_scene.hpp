// Boxes on a grid of cells of size 1, with their films: areas and kinds of cells are known by hand.
#pragma once

#include "gapflow/film/mouths.hpp"
#include "unit/grid/scenes.hpp"

#include <functional>
#include <memory>
#include <set>

namespace gapflow::test {

template <int D>
class FilmScene {
public:
    /// Cells of size 1 from the origin on, all on each rank, or shared out over those of `ranks`.
    explicit FilmScene(int cells, SideKind sides = SideKind::open, MPI_Comm ranks = MPI_COMM_SELF)
        : grid_(Vec<D>::Zero(), 1.0, Index<D>::Constant(cells), gapflow::testing::all_sides<D>(sides), 2, Communicator(ranks)),
          scene_(grid_)
    {
        gap.threshold = 0.5;
        gap.floor = 1e-9;
    }

    /// A box from low to high. Index of the new solid.
    int add_box(const std::string& name, const Vec<D>& low, const Vec<D>& high)
    {
        return scene_.add(name, make_box<D>(high - low), gapflow::testing::pose<D>(0.5 * (low + high)));
    }

    int add_ball(const std::string& name, double radius, const Vec<D>& centre)
    {
        return scene_.add(name, make_ball<D>(radius), gapflow::testing::pose<D>(centre));
    }

    /// After all bodies are there.
    void clip()
    {
        clipper_ = std::make_unique<FaceClipper<D>>(grid_, scene_.solids, FractionMode::cut_cell);
        fractions_ = face_fractions(grid_, *clipper_);
        faces_ = std::make_unique<FaceCache<D>>(grid_, *clipper_, scene_.solids, fractions_);
    }
    std::vector<Film<D>> films(const std::function<bool(int, int)>& has_film = {}) const
    {
        return find_films<D>(grid_, scene_.solids, *clipper_, settings(has_film), {});
    }
    FilmNetwork<D> network(const std::function<bool(int, int)>& has_film = {}) const
    {
        return build_film_network<D>(grid_, scene_.solids, *clipper_, fractions_, settings(has_film), {});
    }

    const Grid<D>& grid() const { return grid_; }
    const std::vector<Solid<D>>& solids() const { return scene_.solids; }
    const FaceCache<D>& faces() const { return *faces_; }

    GapSettings gap; ///< of all pairs

private:
    std::function<GapSettings(int, int)> settings(const std::function<bool(int, int)>& has_film) const
    {
        return [this, has_film](int a, int b) {
            GapSettings of_pair = gap;
            of_pair.film = !has_film || has_film(a, b);
            return of_pair;
        };
    }

    Grid<D> grid_;
    gapflow::testing::Scene<D> scene_;
    std::unique_ptr<FaceClipper<D>> clipper_;
    FaceFractions<D> fractions_;
    std::unique_ptr<FaceCache<D>> faces_;
};

/// A point with one number for the horizontal axes and another for the vertical one.
template <int D>
Vec<D> at(double aside, double height)
{
    Vec<D> x = Vec<D>::Constant(aside);
    x[D - 1] = height;
    return x;
}

/// Two plates, `low` to `high` wide along every horizontal axis, on both sides of a gap of 0.2 in the layer of cells 4: from 4.3 to 4.5.
template <int D>
std::unique_ptr<FilmScene<D>> plates(double low, double high, int cells = 10)
{
    auto scene = std::make_unique<FilmScene<D>>(cells);
    scene->add_box("lower", at<D>(low, 2), at<D>(high, 4.3));
    scene->add_box("upper", at<D>(low, 4.5), at<D>(high, 7));
    scene->clip();
    return scene;
}

} // namespace gapflow::test
