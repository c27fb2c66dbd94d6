#include "plane/geodesic_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <queue>

#include "base/test_cases.h"
#include "plane/inset_test_shapes.h"

namespace filigree {
namespace {

std::vector<Vec> random_sites(CaseRandom& random, const RegionRaster& raster, std::size_t count) {
    std::vector<std::uint32_t> cells;
    for (const RegionRaster::Run& run : raster.runs()) {
        for (std::uint32_t i = run.begin; i < run.end; ++i) cells.push_back(i);
    }
    std::vector<Vec> sites;
    for (std::size_t i = 0; i < count && !cells.empty(); ++i) {
        const std::size_t k = random.index(cells.size());
        sites.push_back(raster.centre(cells[k]));
        cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(k));
    }
    return sites;
}

// Dijkstra's algorithm from one cell, with the true lengths of steps.
std::vector<double> ways_from(const RegionRaster& raster, std::uint32_t start) {
    std::vector<double> ways(raster.size(), 1e300);
    std::priority_queue<std::pair<double, std::uint32_t>> queue;
    ways[start] = 0;
    queue.push({0, start});
    const auto row = static_cast<std::int64_t>(raster.columns());
    while (!queue.empty()) {
        const auto [minus_way, cell] = queue.top();
        queue.pop();
        if (-minus_way > ways[cell]) continue;
        for (int y = -1; y <= 1; ++y) {
            for (int x = -1; x <= 1; ++x) {
                const auto next = static_cast<std::uint32_t>(cell + y * row + x);
                const double way = ways[cell] + std::sqrt(x * x + y * y);
                if (!raster.is_inside(next) || way >= ways[next]) continue;
                ways[next] = way;
                queue.push({-way, next});
            }
        }
    }
    return ways;
}

TEST(GeodesicCells, EveryCellGoesToTheSiteThatIsNearestInside) {
    const std::uint64_t count = case_count(60);
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const Polygons region = random.coin()
                                    ? test_shapes::wobbly_shape(random, 40, random.whole(8, 80), 6)
                                    : test_shapes::one_polygon({test_shapes::wild_ring(random, {0, 0}, 40, 14)});
        const auto raster = RegionRaster::of(region[0], 2, 1U << 20);
        ASSERT_TRUE(raster);
        const std::vector<Vec> sites = random_sites(random, *raster, 6);
        if (sites.empty()) continue;
        GeodesicCells cells(*raster);
        cells.assign(sites);
        std::vector<std::vector<double>> ways;
        for (const Vec site : sites) ways.push_back(ways_from(*raster, raster->index_of(site)));
        for (const RegionRaster::Run& run : raster->runs()) {
            for (std::uint32_t i = run.begin; i < run.end; ++i) {
                double least = 1e300;
                for (const std::vector<double>& way : ways) least = std::min(least, way[i]);
                const std::uint32_t owner = cells.owners()[i];
                ASSERT_EQ(owner == GeodesicCells::none, least == 1e300);
                // Steps across corners count 17/12 instead of the root of 2, and lengths are rounded down.
                if (owner == GeodesicCells::none) continue;
                EXPECT_LE(ways[owner][i], least * 1.005 + 0.5);
            }
        }
    }
}

double spread_of(const RegionRaster& raster, const std::vector<Vec>& sites) {
    double sum = 0;
    for (const RegionRaster::Run& run : raster.runs()) {
        for (std::uint32_t i = run.begin; i < run.end; ++i) {
            double least = 1e300;
            for (const Vec site : sites) {
                const Vec to = raster.centre(i) - site;
                least = std::min(least, dot(to, to));
            }
            sum += least;
        }
    }
    return sum;
}

TEST(GeodesicCells, RelaxingBringsSitesToTheMiddleOfTheirCells) {
    CaseRandom random(2);
    const Polygons region = test_shapes::one_polygon({{snap({0, 0}), snap({100, 0}), snap({100, 80}), snap({0, 80})}});
    const auto raster = RegionRaster::of(region[0], 1, 1U << 20);
    const std::vector<Vec> start = random_sites(random, *raster, 20);
    double before = spread_of(*raster, start);
    for (const unsigned rounds : {1U, 4U, 20U}) {
        std::vector<Vec> sites = start;
        GeodesicCells(*raster).relax(sites, {rounds, 0});
        const double now = spread_of(*raster, sites);
        EXPECT_LT(now, before);
        before = now;
    }
    // A hexagonal lattice has 0.1604 times the area a site, squared.
    EXPECT_LT(before / 8000 / 400, 0.185);
}

TEST(GeodesicCells, SitesStayInsideBentRegions) {
    const std::uint64_t count = case_count(200);
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        SCOPED_TRACE(seed);
        CaseRandom random(seed);
        const Polygons region = random.coin()
                                    ? test_shapes::wobbly_shape(random, 40, random.whole(8, 80), 6)
                                    : test_shapes::one_polygon({test_shapes::wild_ring(random, {0, 0}, 40, 14)});
        const auto raster = RegionRaster::of(region[0], random.between(1, 3), 1U << 20);
        std::vector<Vec> sites = random_sites(random, *raster, random.index(8) + 1);
        GeodesicCells(*raster).relax(sites, {8, 0.1});
        for (const Vec site : sites) EXPECT_TRUE(raster->is_inside(raster->index_of(site)));
    }
}

TEST(GeodesicCells, AloneInABendASiteGoesHalfWay) {
    // A thin U, whose centroid lies outside.
    const Polygons region = test_shapes::one_polygon({{snap({0, 0}), snap({60, 0}), snap({60, 60}), snap({54, 60}),
                                                       snap({54, 6}), snap({6, 6}), snap({6, 60}), snap({0, 60})}});
    const auto raster = RegionRaster::of(region[0], 1, 1U << 20);
    std::vector<Vec> sites{{3, 50}};
    GeodesicCells(*raster).relax(sites, {4, 0});
    EXPECT_NEAR(sites[0].x, 30, 3);
    EXPECT_NEAR(sites[0].y, 3, 1);
}

TEST(GeodesicCells, WeightsDrawSites) {
    const Polygons region = test_shapes::one_polygon({{snap({0, 0}), snap({100, 0}), snap({100, 20}), snap({0, 20})}});
    const auto raster = RegionRaster::of(region[0], 1, 1U << 20);
    std::vector<std::uint16_t> weights(raster->size(), 1);
    for (std::uint32_t i = 0; i < raster->size(); ++i) {
        if (raster->centre(i).x > 80) weights[i] = 1000;
    }
    std::vector<Vec> even{{20, 10}}, drawn{{20, 10}};
    GeodesicCells(*raster).relax(even, {6, 0});
    GeodesicCells(*raster, weights).relax(drawn, {6, 0});
    EXPECT_NEAR(even[0].x, 50, 1);
    EXPECT_GT(drawn[0].x, 85);
}

}  // namespace
}  // namespace filigree
