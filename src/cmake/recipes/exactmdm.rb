class Exactmdm < Formula
  desc "Exact minimal discrete matches of grain size distributions"
  # There is no homepage yet, and `brew audit` will say so.
  url "@SOURCE_URL@"
  version "0.2.0"
  sha256 "@SHA256@"
  license "Apache-2.0"

  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "boost"
  depends_on "cairo"
  depends_on "flint"
  depends_on "fmt"
  depends_on "gmp"
  depends_on "libzip"
  depends_on "mpfr"
  depends_on "openssl@3"
  depends_on "pugixml"
  depends_on "zlib"
  depends_on "zstd"
  # The programs call memfd_create and prctl.
  depends_on :linux

  def install
    args = %w[-G Ninja -DMDM_TESTS=OFF -DMDM_BENCHMARKS=OFF]
    system "cmake", "-S", ".", "-B", "build", *args, *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
    zsh_completion.install share/"zsh/vendor-completions/_mdm"
  end

  test do
    (testpath/"sand.csv").write "size_mm,mass\n0.15,2\n0.3,1\n0.6,0\n"
    system bin/"mdm", "solve", "sand.csv", "--proof", "sand.proof"
    assert_match "N = 4 is the smallest number of particles", shell_output("#{bin}/mdm-check sand.csv sand.proof")
  end
end
