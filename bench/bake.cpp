// Wall time and peak memory of `zonal bake` with all default outputs, by size of the input, as a user runs it.
// Usage: bench_bake ZONAL FOLDER [LARGEST_HEIGHT]; leaves its inputs and outputs in FOLDER.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace {

struct Cost {
  double seconds = 0;
  double peak_mb = 0;
};

Cost run(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const auto begin = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    std::fprintf(stderr, "failed: %s %s\n", words[0].c_str(), words[1].c_str());
    std::exit(1);
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  return {taken.count(), static_cast<double>(usage.ru_maxrss) / 1024};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s ZONAL FOLDER [LARGEST_HEIGHT]\n", argv[0]);
    return 2;
  }
  const std::string zonal = argv[1];
  const std::filesystem::path folder = argv[2];
  const int largest = argc > 3 ? std::atoi(argv[3]) : 4096;
  std::filesystem::create_directories(folder);
  std::printf("%12s %10s %12s %12s %16s\n", "input", "decoded", "best of 3", "peak memory", "peak / decoded");
  for (int height = 256; height <= largest; height *= 2) {
    const std::string sky = folder / ("sky" + std::to_string(height) + ".exr");
    if (!std::filesystem::exists(sky))
      run({zonal, "sky", "daylight", "--size", std::to_string(height), "-o", sky, "--quiet"});
    Cost best;
    for (int i = 0; i < 3; ++i) {
      const Cost cost = run({zonal, "bake", sky, "-o", folder / "out", "--quiet"});
      if (i == 0 || cost.seconds < best.seconds) best = cost;
    }
    const double decoded_mb = 12.0 * 2 * height * height / (1 << 20);
    std::printf("%7dx%4d %7.0f MiB %10.2f s %8.0f MiB %16.2f\n", 2 * height, height, decoded_mb, best.seconds,
                best.peak_mb, best.peak_mb / decoded_mb);
    std::fflush(stdout);
  }
}
