// The same bits on any number of threads.
#include "trace/denoise.hpp"
#include "trace/scenes.hpp"
#include "trace/tracer.hpp"

#include <atomic>

#include <gtest/gtest.h>

namespace pastoso::trace {
namespace {

TEST(PathTracerThreads, ThreadsDoNotChangeThePicture) {
    const Scene scene = tests::busy_glass();
    core::ThreadPool one(1);
    PathTracer alone(scene, tests::small_picture(40), one);
    alone.add_samples(4);
    for (const int threads : {2, 3}) {
        core::ThreadPool pool(threads);
        PathTracer tracer(scene, tests::small_picture(40), pool);
        tracer.add_samples(4);
        EXPECT_EQ(tracer.radiance(), alone.radiance());
        EXPECT_EQ(tracer.denoised(), alone.denoised());
        EXPECT_EQ(tracer.rays(), alone.rays());
    }
}

TEST(PathTracerThreads, AStopOnAnyThreadIsMadeUpFor) {
    const Scene scene = tests::busy_glass();
    core::ThreadPool one(1), three(3);
    PathTracer whole(scene, tests::small_picture(64), one),
        stopped(scene, tests::small_picture(64), three);
    whole.add_samples(2);
    std::atomic<int> asked = 0;
    EXPECT_FALSE(stopped.add_samples(2, [&] { return ++asked > 6; }));
    EXPECT_TRUE(stopped.add_samples(2));
    EXPECT_EQ(stopped.radiance(), whole.radiance());
}

}  // namespace
}  // namespace pastoso::trace
