#include "tests/cli/command.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <thread>

#include "zonal/io/picture.h"

namespace zonal {
namespace fs = std::filesystem;
namespace {

pid_t start(const std::vector<std::string>& words, const fs::path& folder, const std::string& out,
            const std::string& err) {
  std::vector<std::string> all = {ZONAL_COMMAND};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> argv;
  for (std::string& word : all) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child != 0) return child;
  // In the child: nothing but system calls.
  const int out_file = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  const int err_file = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (out_file < 0 || err_file < 0 || ::chdir(folder.c_str()) != 0) ::_exit(126);
  ::dup2(out_file, STDOUT_FILENO);
  ::dup2(err_file, STDERR_FILENO);
  ::execv(argv[0], argv.data());
  ::_exit(127);
}

Result finish(pid_t child, const std::string& out, const std::string& err) {
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  Result result;
  if (WIFEXITED(status)) result.code = WEXITSTATUS(status);
  if (fs::is_regular_file(out)) result.out = bytes_of(out);
  result.err = bytes_of(err);
  return result;
}

std::string joined(const std::vector<std::string>& words) {
  std::string line = "zonal";
  for (const std::string& word : words) line += " " + word;
  return line;
}

}  // namespace

void Cli::SetUp() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  folder_ = fs::path(testing::TempDir()) / (std::string("zonal_cli_") + info->test_suite_name() + "_" + info->name());
  fs::remove_all(folder_);
  fs::create_directories(folder_);
}

void Cli::TearDown() {
  fs::remove_all(folder_);
  fs::remove(folder_.string() + ".out");
  fs::remove(folder_.string() + ".err");
}

Result Cli::run(const std::vector<std::string>& words, const std::string& stdout_path) const {
  // Beside the folder, so that it holds nothing but what the command wrote.
  const std::string out = stdout_path.empty() ? folder_.string() + ".out" : stdout_path,
                    err = folder_.string() + ".err";
  return finish(start(words, folder_, out, err), out, err);
}

Result Cli::run_interrupted(const std::vector<std::string>& words, int milliseconds) const {
  const std::string out = folder_.string() + ".out", err = folder_.string() + ".err";
  const pid_t child = start(words, folder_, out, err);
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  ::kill(child, SIGINT);
  return finish(child, out, err);
}

Result Cli::good(const std::vector<std::string>& words) const {
  const Result result = run(words);
  EXPECT_EQ(result.code, 0) << joined(words) << "\n" << result.err;
  return result;
}

Result Cli::bad(int code, const std::vector<std::string>& words, std::string_view says) const {
  const auto before = files();
  const Result result = run(words);
  EXPECT_EQ(result.code, code) << joined(words) << "\n" << result.err;
  EXPECT_NE(result.err.find("zonal: "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("hint: "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find(says), std::string::npos) << joined(words) << "\n" << result.err;
  EXPECT_EQ(files(), before) << joined(words);
  return result;
}

std::map<std::string, std::string> Cli::files(const fs::path& below) const {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / below)) {
    const std::string name = fs::relative(entry.path(), folder_ / below).string();
    all[name] = entry.is_regular_file() ? bytes_of(entry.path()) : "(folder)";
  }
  return all;
}

void Cli::write(std::string_view name, std::string_view bytes) const {
  std::ofstream file(path(name), std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  ASSERT_TRUE(file.good());
}

void Cli::write_pfm(std::string_view name, int width, int height, const std::vector<float>& values) const {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  ASSERT_TRUE(values.size() == pixels || values.size() == 3 * pixels);
  std::string bytes = values.size() == pixels ? "Pf\n" : "PF\n";
  bytes += std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
  const std::size_t header = bytes.size();
  bytes.resize(header + values.size() * sizeof(float));
  std::memcpy(bytes.data() + header, values.data(), values.size() * sizeof(float));
  write(name, bytes);
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  EXPECT_TRUE(in.good()) << file;
  return {std::istreambuf_iterator<char>(in), {}};
}

Image<Rgb> pixels_of(const fs::path& file) { return load_picture(file).pixels; }

double worst_from(const Image<Rgb>& picture, double value) {
  EXPECT_FALSE(picture.empty());
  double worst = 0;
  for (const Rgb& p : picture.values()) {
    for (const float channel : {p.r, p.g, p.b}) {
      if (!(std::abs(channel - value) <= worst)) worst = std::abs(channel - value);  // a NaN stays
    }
  }
  return worst;
}

}  // namespace zonal
